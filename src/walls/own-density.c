/* own-density.c -- solids with a density of their own.
 *
 * Points of walls and skins obey the continuity equation (D1) like the fluid,
 * with the velocity of the solid, and press by the same law (P1): "dynamic
 * boundary particles", Crespo, Gomez-Gesteira, Dalrymple, Comput. Mater. Contin.
 * 5 (2007) 173-184.  Energy and momentum close exactly; a gap of about one
 * spacing stays between fluid and wall. */
#include "base/lanes.h"
#include "walls/walls.h"

static const char *const with[] = { "continuity", NULL };

static int blocks(const void *self, const struct scales *s, const struct particles *p,
                  struct layout *l, int density_row[KINDS])
{
    static const char *const names[KINDS] = {
        [KIND_WALL] = "density of walls",
        [KIND_WALL_SLIP] = "density of slip walls",
        [KIND_SKIN] = "density of skins",
        [KIND_SKIN_SLIP] = "density of slip skins",
    };
    const double mach = s->speed / s->c0;

    (void)self;
    for (int k = KIND_WALL; k < KINDS; k++) {
        const int n = particles_count(p, k);
        if (n == 0)
            continue;
        density_row[k] = layout_add(l, LAYOUT_OTHER, names[k], "kg/m^3", n, 1,
                                    s->rho0 * mach * mach);
        if (density_row[k] < 0)
            return 1;
    }
    return 0;
}

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
    .blocks = blocks,
    .as.wall = &wall,
};
