/* laplacian-viscosity.c -- viscosity (28) of Toth (2012) with the right Laplacian of
 * the right kernel: (K9) and its lapW = 40/(pi H^5) (H - r) in 2D.  (V3) */
#include "effects/laplacian-viscosity.h"
#include "effects/viscosity-side.h"

static const char *const sticks[] = { "particles", "face", NULL };

static const struct param params[] = {
    LAPLACIAN_VISCOSITY_MU,
    VISCOSITY_SIDE(struct laplacian_viscosity),
    VISCOSITY_STICK(struct laplacian_viscosity),
    { 0 }
};

static int prepare(void *self, const struct scales *scales)
{
    struct laplacian_viscosity *s = self;

    s->factor = s->mu;
    s->rate = scales->laplacian;
    return 0;
}

static void couple(const void *self, const struct side *a, const struct block *b,
                   struct coupling *to)
{
    for (int k = 0; k < b->n; k++)
        to->c[k] = laplacian_viscosity_coupling(self, a, b, k);
}

static bool stiff(const void *self)
{
    const struct laplacian_viscosity *s = self;
    return viscosity_is_implicit(s->side);
}

static bool faces(const void *self)
{
    const struct laplacian_viscosity *s = self;
    return viscosity_at_faces(s->stick);
}

static double mu(const void *self)
{
    return ((const struct laplacian_viscosity *)self)->mu;
}

static const struct part_operator operator = {
    .couple = couple,
    .stiff = stiff,
    .faces = faces,
    .mu = mu,
};

const struct part LANE_NAME(effects_laplacian_viscosity) = {
    .name = "laplacian-viscosity",
    .about = "laminar viscosity by the Laplacian of a kernel, as in Toth (2012)",
    .equation = "(V3) F_ab = -m_a m_b mu/(rho_a rho_b) lapW_ab (v_a - v_b)",
    .source = "Toth 2012, (28), with (31) corrected",
    LAPLACIAN_VISCOSITY_PART,
    .as.operator = &operator,
};
