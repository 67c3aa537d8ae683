/* velocity-smoothing.c -- velocities become those of the neighbours.
 *
 *   F_ab = -m_a m_b k W_ab (v_a - v_b)/rhobar                              (S1)
 *
 * with rhobar the harmonic mean of both densities, as in (V2): a velocity approaches
 * the mean around it at the rate k.  F_ab . (v_a - v_b) is never positive, so this
 * effect only takes energy out.  The mean is that of XSPH, Monaghan, J. Comput.
 * Phys. 82 (1989) 1-15, there for moving particles, here as a force. */
#include "effects/effects.h"

struct velocity_smoothing {
    double k; /* [1/s] */
};

static const struct param params[] = {
    { .key = "k", .unit = "1/s", .offset = offsetof(struct velocity_smoothing, k),
      .fallback = 1, .min = 0, .max = 1e4,
      .about = "rate at which a velocity approaches the mean of its neighbours" },
    { 0 },
};

static void pairs(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    const struct velocity_smoothing *s = self;
    struct sum t = *to; /* registers, not memory */

    for (int i = 0; i < b->n; i++) {
        const lanes c = (real)(s->k / 2) * (a->irho + b->irho[i]) * b->w[i];
        for (int d = 0; d < DIM; d++)
            t.f[d] -= c * b->v[d][i];
    }
    *to = t;
}

/* All neighbours together weigh sum_b m_b W/rho = 1 and less; a half more is for
 * those that are pushed together. */
static void limit(const void *self, const struct view *v, struct limit *out)
{
    const struct velocity_smoothing *s = self;

    (void)v;
    out->rate = 1.5 * s->k;
    out->decay = true;
    out->where = -1; /* the same everywhere */
}

static const struct part_law law = {
    .rows = NEED_V | NEED_IRHO | NEED_W,
    .columns = COLUMN_FORCE,
    .kernel = PART_VISCOSITY,
    .acts = EFFECTS_ACT_STICKY,
    .pairs = pairs,
};

const struct part LANE_NAME(effects_velocity_smoothing) = {
    .name = "velocity-smoothing",
    .about = "velocities approach the mean of their neighbours",
    .equation = "(S1) F_ab = -m_a m_b k W_ab (v_a - v_b)/rhobar",
    .source = "after Monaghan, J. Comput. Phys. 82 (1989) 1-15",
    .size = sizeof(struct velocity_smoothing),
    .params = params,
    .needs = FIELD_DENSITY,
    .limit = limit,
    .as.law = &law,
};
