/* xsph.c -- particles move with a velocity nearer to that of their neighbours than their own.
 *
 *   dx_a/dt = v_a + w_a,  w_a = strength sum_b m_b (v_b - v_a)/rhobar W_ab       (D6)
 *
 * over fluid, with rhobar the harmonic mean of both densities as in (V2).  Velocities stay as
 * they are, so nothing is braked, and m_a w_a summed over all is 0: the centre of mass goes
 * its way.  What is carried is smoother than v: particles keep their order and pass through each
 * other less easily.  The rate of density (D1) goes by v, not by v + w: the published
 * inconsistency.  A drift across the weight is energy, and booked; scenes with other body forces
 * are refused.  Monaghan, J. Comput. Phys. 82 (1989) 1-15; seed 003, (2.5).
 * Checked in tests/physics/xsph.c. */
#include "effects/effects.h"

struct xsph {
    double strength; /* share of the difference [1] */
};

static const struct param params[] = {
    { .key = "strength", .unit = "1", .offset = offsetof(struct xsph, strength), .fallback = 0.5,
      .max = 1, .about = "share of the neighbours' mean velocity that a particle moves with" },
    { 0 },
};

static void gather(const void *self, const struct side *a, const struct block *b,
                   struct field_sum *to)
{
    struct field_sum t = *to; /* registers, not memory */

    (void)self;
    for (int k = 0; k < b->n; k++) {
        const lanes c = (a->irho + b->irho[k]) * b->w[k];
        for (int d = 0; d < DIM; d++)
            t.s[d] -= c * b->v[d][k];
    }
    *to = t;
}

static void carry(const void *self, const struct part_sums *s, double (*drift)[DIM])
{
    const struct xsph *o = self;
    const struct particles *p = s->v->p;
    const int first = p->from[s->kind];

    for (int i = 0; i < s->n; i++)
        for (int d = 0; d < DIM; d++)
            drift[s->owner[i] - first][d] += o->strength / 2 * s->sum[i][d] / p->m[s->owner[i]];
}

static const struct part_summed summed = {
    .meets = { [KIND_FLUID] = KIND_BIT(KIND_FLUID) },
    .rows = NEED_V | NEED_IRHO | NEED_W,
    .gather = gather,
    .carry = carry,
};

const struct part LANE_NAME(effects_xsph) = {
    .name = "xsph",
    .about = "particles move with the mean velocity of their neighbours in part",
    .equation = "(D6) dx_a/dt = v_a + strength sum_b m_b (v_b - v_a)/rhobar W_ab",
    .source = "Monaghan, J. Comput. Phys. 82 (1989) 1-15",
    .size = sizeof(struct xsph),
    .params = params,
    .needs = FIELD_DENSITY,
    .as.summed = &summed,
};
