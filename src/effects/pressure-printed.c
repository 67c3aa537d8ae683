/* pressure-printed.c -- the pressure force as Toth (2012) prints it: to be seen, not
 * to be used.
 *
 *   F_ab = -m_a m_b (p_a/rho_a + p_b/rho_b) gradW_ab                        (24)
 *
 * The units are wrong: p/rho stands where (P1) has p/rho^2, so that in SI units the
 * force is too large by rho, a thousand times in water.  Toth 2012, (24) in (33). */
#include "effects/effects.h"

static void pairs(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    struct sum t = *to; /* registers, not memory */
    const lanes own = a->p2 * a->rho;

    (void)self;
    for (int k = 0; k < b->n; k++) {
        const lanes c = (own + b->p2[k] * b->rho[k]) * b->gw[k];
        for (int d = 0; d < DIM; d++)
            t.f[d] -= c * b->x[d][k];
    }
    *to = t;
}

static const struct part_law law = {
    .rows = NEED_X | NEED_RHO | NEED_P2 | NEED_GRADW,
    .columns = COLUMN_FORCE,
    .kernel = PART_PRESSURE,
    .acts = EFFECTS_ACT_ALL,
    .conservative = true,
    .pairs = pairs,
};

const struct part LANE_NAME(effects_pressure_printed) = {
    .name = "pressure-printed",
    .about = "pressure force with the misprint of Toth (2012): a thousand times too strong in "
             "water",
    .equation = "(24) F_ab = -m_a m_b (p_a/rho_a + p_b/rho_b) gradW_ab",
    .source = "Toth 2012, (24) as printed",
    .instead = "pressure",
    .needs = FIELD_DENSITY | FIELD_PRESSURE,
    .as.law = &law,
};
