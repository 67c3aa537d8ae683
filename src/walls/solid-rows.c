/* solid-rows.c -- rows of y for densities that solids have of their own. */
#include "walls/solid-rows.h"

int solid_rows_add(const void *self, const struct scales *s, const struct particles *p,
                   struct layout *l, int density_row[KINDS])
{
    static const char *const names[KINDS] = {
        [KIND_WALL] = "density of walls",
        [KIND_WALL_SLIP] = "density of slip walls",
        [KIND_SKIN] = "density of skins",
        [KIND_SKIN_SLIP] = "density of slip skins",
    };

    (void)self;
    for (int k = KIND_WALL; k < KINDS; k++) {
        const int n = particles_count(p, k);
        if (n == 0)
            continue;
        density_row[k] = layout_add(l, LAYOUT_OTHER, names[k], "kg/m^3", n, 1, s->density);
        if (density_row[k] < 0)
            return 1;
    }
    return 0;
}
