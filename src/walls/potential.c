/* potential.c -- solids that nothing but effects.contact-potential acts on.
 *
 * Their particles keep the density at rest and have no pressure: the fluid does not see them in
 * its density, pressure, viscosity, diffusion or drift, only by (W7). */
#include "base/lanes.h"
#include "walls/solid-rows.h"
#include "walls/walls.h"

static const char *const with[] = { "continuity", NULL };

static const struct part_wall wall = {
    .as_fluid = true,
    .with = with,
    .only = "contact-potential",
};

const struct part LANE_NAME(walls_potential) = {
    .name = "potential",
    .about = "solids that repel the fluid by effects.contact-potential, and by nothing else",
    .equation = "(W7)",
    .source = "Vignjevic, De Vuyst, Campbell, ICCES 3 (2007) 107-112",
    .needs = FIELD_DENSITY | FIELD_PRESSURE,
    .blocks = solid_rows_add,
    .as.wall = &wall,
};
