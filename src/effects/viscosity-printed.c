/* viscosity-printed.c -- viscosity of Toth (2012) with the misprint of its Laplacian:
 * to be seen, not to be used.
 *
 *   lapW = -40/(pi H^4) (H - r)                                             (31)
 *
 * has the power of H wrong by one (its minus and that of (28) cancel), so that in SI
 * units the viscosity is too small by H: 119 times for the support of 8.4 mm that goes
 * with 1,800 particles.  2D only: Toth prints no other. */
#include "effects/laplacian-viscosity.h"

#include "base/status.h"

static const struct param params[] = { LAPLACIAN_VISCOSITY_MU, { 0 } };

static int prepare(void *self, const struct scales *scales)
{
    struct laplacian_viscosity *s = self;

    if (DIM != 2)
        return status_fail(STATUS_BAD_SCENE, "effects.viscosity-printed: Toth (2012) prints this "
                           "formula for two dimensions; in three take laplacian-viscosity");
    s->factor = s->mu * scales->support;
    s->rate = scales->laplacian;
    return 0;
}

const struct part LANE_NAME(effects_viscosity_printed) = {
    .name = "viscosity-printed",
    .about = "viscosity of Toth (2012) with its misprint: some hundred times too weak",
    .equation = "(28) with (31) as printed: (V3) with lapW times H",
    .source = "Toth 2012, (28), (31) as printed",
    .instead = "laplacian-viscosity",
    LAPLACIAN_VISCOSITY_PART,
};
