/* artificial-stress.c -- particles under tension repel one another when they come close.
 *
 *   F_ab = -m_a m_b (R_a + R_b) f^4 gradW_ab,   f = W(r)/W(dx)             (P3)
 *   R_a = strength max(0, -p_a)/rho_a^2
 *
 * A negative pressure draws neighbours together the stronger the nearer they are, until
 * they stand in pairs.  This takes part of that pull away at the spacing dx of the
 * lattice, all of it and more when they are nearer, and next to nothing from 2 dx on.
 * The force points along x and has both sides in it, so momentum and its moment are
 * kept; its work is in the book.  Nothing happens where no pressure is negative.
 * Monaghan, J. Comput. Phys. 159 (2000) 290-311, with n = 4, there with strength 0.2
 * and 0.01 of pressures that are not negative, too.
 * Checked in tests/physics/stress.c. */
#include "effects/effects.h"

struct artificial_stress {
    double strength; /* share of the pull at dx  [1]   */
    double nearby;   /* 1/W(dx)                  [m^D] */
};

static const struct param params[] = {
    { .key = "strength", .unit = "1", .offset = offsetof(struct artificial_stress, strength),
      .fallback = 0.3, .max = 1,
      .about = "share of the pull that is taken away at the spacing dx" },
    { 0 },
};

static void pairs(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    const struct artificial_stress *s = self;
    const real nearby = (real)s->nearby, strength = (real)s->strength;
    const lanes pull = lanes_positive(-a->p2), least = lanes_all(LANES_LEAST);
    struct sum t = *to; /* registers, not memory */

    for (int k = 0; k < b->n; k++) {
        const lanes f = nearby * b->w[k] / lanes_max(b->mm[k], least), f2 = f * f;
        const lanes c = strength * (pull + lanes_positive(-b->p2[k])) * (f2 * f2) * b->gw[k];
        for (int d = 0; d < DIM; d++)
            t.f[d] -= c * b->x[d][k];
    }
    *to = t;
}

static int prepare(void *self, const struct scales *scales)
{
    struct artificial_stress *s = self;

    s->nearby = 1 / scales->nearby;
    return 0;
}

static const struct part_law law = {
    .rows = NEED_X | NEED_P2 | NEED_W | NEED_GRADW,
    .columns = COLUMN_FORCE,
    .kernel = PART_PRESSURE,
    .acts = EFFECTS_ACT_FLUID,
    .pairs = pairs,
};

const struct part LANE_NAME(effects_artificial_stress) = {
    .name = "artificial-stress",
    .about = "keeps particles under tension from pairing",
    .equation = "(P3) F_ab = -m_a m_b (R_a + R_b) (W(r)/W(dx))^4 gradW_ab, "
                "R = strength max(0, -p)/rho^2",
    .source = "Monaghan, J. Comput. Phys. 159 (2000) 290-311",
    .size = sizeof(struct artificial_stress),
    .params = params,
    .needs = FIELD_DENSITY | FIELD_PRESSURE,
    .prepare = prepare,
    .as.law = &law,
};
