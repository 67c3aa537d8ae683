/* stress-viscosity.c -- laminar viscosity along the line of centres: the whole stress.
 *
 *   F_ab = m_a m_b 2 (D + 2) mu/(rho_a rho_b) (x . v)/(r^2 + 0.01 hs^2) gradW_ab   (V4)
 *
 * with x = x_a - x_b, v = v_a - v_b, hs half the support: (V2) with a physical mu.  Where
 * (V1) has the Laplacian of velocities, and takes out mu (grad u)^2, this has the
 * divergence of the stress mu (grad u + grad u^T), and takes out 2 mu D:D.  In closed tanks
 * both are the same; below a free surface, which no stress pulls at, only this is right.
 * F_ab . v is never positive.  Monaghan, Rep. Prog. Phys. 68 (2005) 1703-1759, section
 * 8; Colagrossi, Antuono, Le Touze, Phys. Rev. E 79 (2009) 056701.  Checked in
 * tests/unit/effects.c, tests/validation/A05.sh. */
#include "effects/effects.h"
#include "effects/lightest.h"

struct stress_viscosity {
    double mu;       /* dynamic viscosity              [Pa s]  */
    double strength; /* 2 (D + 2) mu                   [Pa s]  */
    double rate;     /* fastest decay with nu = 1      [1/m^2] */
};

static const struct param params[] = {
    { .key = "mu", .unit = "Pa s", .offset = offsetof(struct stress_viscosity, mu),
      .fallback = 1e-3, .min = 0, .max = 1e4, .about = "dynamic viscosity; 0.001 is water" },
    { 0 },
};

static void pairs(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    const struct stress_viscosity *s = self;
    struct sum t = *to; /* registers, not memory */

    for (int k = 0; k < b->n; k++) {
        const lanes c = (real)s->strength * (a->irho * b->irho[k]) * (b->xv[k] * b->gw_r2[k]);
        for (int d = 0; d < DIM; d++)
            t.f[d] += c * b->x[d][k];
    }
    *to = t;
}

/* Longitudinal waves feel three times the viscosity of shear. */
static int prepare(void *self, const struct scales *scales)
{
    struct stress_viscosity *s = self;

    s->strength = 2 * (DIM + 2) * s->mu;
    s->rate = 3 * SCALES_LAPLACE * scales->laplace_viscosity / (scales->hs * scales->hs);
    return 0;
}

static void limit(const void *self, const struct view *v, struct limit *out)
{
    const struct stress_viscosity *s = self;

    out->rate = s->rate * s->mu / lightest_fluid(v, out);
    out->decay = true;
}

static const struct part_law law = {
    .rows = NEED_X | NEED_IRHO | NEED_XV | NEED_GRADW_R2,
    .columns = COLUMN_FORCE,
    .kernel = PART_VISCOSITY,
    .acts = EFFECTS_ACT_STICKY,
    .pairs = pairs,
};

const struct part LANE_NAME(effects_stress_viscosity) = {
    .name = "stress-viscosity",
    .about = "laminar viscosity along the line of centres, right below free surfaces",
    .equation = "(V4) F_ab = m_a m_b 2 (D + 2) mu/(rho_a rho_b) (x.v)/(r^2 + 0.01 hs^2) gradW_ab",
    .source = "Monaghan, Rep. Prog. Phys. 68 (2005) 1703-1759",
    .size = sizeof(struct stress_viscosity),
    .params = params,
    .needs = FIELD_DENSITY,
    .prepare = prepare,
    .limit = limit,
    .as.law = &law,
};
