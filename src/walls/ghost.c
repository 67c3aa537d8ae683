/* ghost.c -- walls of Toth (2012): particles that stand still and are fluid otherwise.
 *
 * Their density is the sum (D3) over all particles around them, walls included, and they
 * press the fluid by the same law (P1), but not each other.  A wall that the fluid has
 * left has too few neighbours, rho < rho0: with tension it would suck, so eos.tension =
 * false belongs to it.
 * Toth 2012, section 3.5.3. */
#include "base/lanes.h"
#include "walls/walls.h"

static const char *const with[] = { "summation", NULL };

static const struct part_wall wall = {
    .as_fluid = true,
    .with = with,
};

const struct part LANE_NAME(walls_ghost) = {
    .name = "ghost",
    .about = "solids with a density summed like the fluid's, walls of Toth (2012)",
    .equation = "(D3) and (P1) with the velocity of the solid",
    .source = "Toth 2012, section 3.5.3",
    .needs = FIELD_DENSITY | FIELD_PRESSURE,
    .as.wall = &wall,
};
