/* own-density.c -- solids with a density of their own.
 *
 * Points of walls and skins obey the continuity equation (D1) like the fluid,
 * with the velocity of the solid, and press by the same law (P1): "dynamic
 * boundary particles", Crespo, Gomez-Gesteira, Dalrymple, Comput. Mater. Contin.
 * 5 (2007) 173-184.  Energy and momentum close exactly; a gap of about one
 * spacing stays between fluid and wall. */
#include "base/lanes.h"
#include "walls/solid-rows.h"
#include "walls/walls.h"

static const char *const with[] = { "continuity", NULL };

static const struct part_wall wall = {
    .as_fluid = true,
    .with = with,
};

const struct part LANE_NAME(walls_own_density) = {
    .name = "own-density",
    .about = "solids with a density of their own (dynamic boundary particles)",
    .equation = "(D1) and (P1) with the velocity of the solid",
    .source = "Crespo, Gomez-Gesteira, Dalrymple, Comput. Mater. Contin. 5 (2007) 173-184",
    .needs = FIELD_DENSITY | FIELD_PRESSURE,
    .blocks = solid_rows_add,
    .as.wall = &wall,
};
