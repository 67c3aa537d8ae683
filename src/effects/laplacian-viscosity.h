/* laplacian-viscosity.h -- viscosity by the Laplacian of a kernel: what its right
 * and its printed form have in common.
 *
 *   F_ab = -m_a m_b mu/(rho_a rho_b) lapW_ab (v_a - v_b)                (V3), (28)
 *
 * with mu the dynamic viscosity.  lapW must be positive everywhere, or the effect
 * drives the fluid instead of braking it.  Toth 2012, (28), without its leading minus,
 * which its (31) takes back. */
#ifndef EFFECTS_LAPLACIAN_VISCOSITY_H
#define EFFECTS_LAPLACIAN_VISCOSITY_H

#include "effects/effects.h"
#include "effects/lightest.h"

struct laplacian_viscosity {
    double mu;     /* dynamic viscosity                             [Pa s]   */
    double factor; /* mu times what a misprint makes of lapW        [Pa s ..] */
    double rate;   /* fastest decay with mu/rho = 1                 [1/m^2]  */
    const char *side, *stick; /* NULL: explicit, at particles                */
};

#define LAPLACIAN_VISCOSITY_MU                                                           \
    { .key = "mu", .unit = "Pa s", .offset = offsetof(struct laplacian_viscosity, mu),   \
      .fallback = 1e-3, .min = 0, .max = 1e4,                                            \
      .about = "dynamic viscosity; 0.001 is water, Toth (2012) takes 0.5" }

/* The c of rows k, F_ab = -c v. */
LANES_INLINE lanes laplacian_viscosity_coupling(const struct laplacian_viscosity *s,
                                                const struct side *a, const struct block *b,
                                                int k)
{
    return (real)s->factor * (a->irho * b->irho[k]) * b->lw[k];
}

static void laplacian_viscosity_pairs(const void *self, const struct side *a,
                                      const struct block *b, struct sum *to)
{
    const struct laplacian_viscosity *s = self;
    struct sum t = *to; /* registers, not memory */

    for (int k = 0; k < b->n; k++) {
        const lanes c = laplacian_viscosity_coupling(s, a, b, k);
        for (int d = 0; d < DIM; d++)
            t.f[d] -= c * b->v[d][k];
    }
    *to = t;
}

static void laplacian_viscosity_limit(const void *self, const struct view *v, struct limit *out)
{
    const struct laplacian_viscosity *s = self;
    out->rate = s->rate * s->factor / lightest_fluid(v, out);
    out->decay = true;
}

static const struct part_law laplacian_viscosity_law = {
    .rows = NEED_V | NEED_IRHO | NEED_LAPW,
    .columns = COLUMN_FORCE,
    .kernel = PART_VISCOSITY,
    .acts = EFFECTS_ACT_STICKY,
    .pairs = laplacian_viscosity_pairs,
};

#define LAPLACIAN_VISCOSITY_PART                                                         \
    .size = sizeof(struct laplacian_viscosity), .params = params,                        \
    .needs = FIELD_DENSITY, .prepare = prepare, .limit = laplacian_viscosity_limit,      \
    .as.law = &laplacian_viscosity_law

#endif
