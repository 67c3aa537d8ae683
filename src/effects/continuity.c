/* continuity.c -- density that evolves.
 *
 *   d rho_a/dt = sum_b m_b (v_a - v_b) . gradW_ab                          (D1)
 *
 * Monaghan, J. Comput. Phys. 110 (1994) 399-406, eq. 2.3.  Together with the
 * pressure force (P1) it moves energy between kinetic and internal without
 * making or losing any.  Checked in tests/physics/laws.c. */
#include "effects/density-rate.h"
#include "effects/effects.h"

static void pairs(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    pairs_rows(density_rate_row, self, a, b, to);
}

/* The fluid's own density; solids get theirs from their wall model. */
static int blocks(const void *self, const struct scales *s, const struct particles *p,
                  struct layout *l, int density_row[KINDS])
{
    (void)self;
    density_row[KIND_FLUID] = layout_add(l, LAYOUT_OTHER, "density of fluid", "kg/m^3",
                                         particles_count(p, KIND_FLUID), 1, s->density);
    return density_row[KIND_FLUID] < 0 ? 1 : 0;
}

static const struct part_law law = {
    .rows = NEED_XV | NEED_GRADW,
    .columns = COLUMN_DRHO,
    .acts = EFFECTS_ACT_ALL,
    .conservative = true,
    .pairs = pairs,
};

const struct part LANE_NAME(effects_continuity) = {
    .name = "continuity",
    .about = "density that evolves with the flow",
    .equation = "(D1) d rho_a/dt = sum_b m_b (v_a - v_b) . gradW_ab",
    .source = "Monaghan, J. Comput. Phys. 110 (1994) 399-406",
    .provides = FIELD_DENSITY | FIELD_DENSITY_RATE,
    .blocks = blocks,
    .as.law = &law,
};
