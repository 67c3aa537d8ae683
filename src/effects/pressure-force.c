/* pressure-force.c -- force of the pressure between neighbours.
 *
 *   F_ab = -m_a m_b (p_a/rho_a^2 + p_b/rho_b^2) gradW_ab                   (P1)
 *
 * Monaghan, J. Comput. Phys. 110 (1994) 399-406; the form that follows from a
 * Lagrangian with (D1).  It replaces (24) of Toth (2012), which has p/rho: wrong by
 * a factor of about rho.  Checked in tests/physics/laws.c. */
#include "effects/effects.h"
#include "effects/pressure-force.h"

static void pairs(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    pairs_rows(pressure_force_row, self, a, b, to);
}

static const struct part_law law = {
    .rows = NEED_X | NEED_P2 | NEED_GRADW,
    .columns = COLUMN_FORCE,
    .kernel = PART_PRESSURE,
    .acts = EFFECTS_ACT_ALL,
    .conservative = true,
    .pairs = pairs,
};

const struct part LANE_NAME(effects_pressure_force) = {
    .name = "pressure",
    .about = "force of the pressure between neighbours",
    .equation = "(P1) F_ab = -m_a m_b (p_a/rho_a^2 + p_b/rho_b^2) gradW_ab",
    .source = "Monaghan, J. Comput. Phys. 110 (1994) 399-406",
    .needs = FIELD_DENSITY | FIELD_PRESSURE,
    .as.law = &law,
};
