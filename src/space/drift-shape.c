/* drift-shape.c -- the grid of blocks in which displacements are compared. */
#include "space/drift.h"

#include "space/list-private.h"

#include <math.h>

/* Widens low..high by the grids of all kinds. */
static void widen(const struct cells *cells, double *low, double *high)
{
    for (int d = 0; d < DIM; d++)
        for (int kind = 0; kind < KINDS; kind++) {
            if (cells[kind].n[d] == 0)
                continue;
            low[d] = fmin(low[d], cells[kind].low[d]);
            high[d] = fmax(high[d], cells[kind].low[d]
                                        + cells[kind].n[d] / cells[kind].per_metre[d]);
        }
}

/* Blocks over the grids of all kinds, an empty one around them; coarser until
 * there are not many more than particles. */
size_t drift_shape(const struct list *list, const struct cells *cells, const struct cells *images,
                   struct drift *drift)
{
    const double edge = list->def.support + 2 * DRIFT_FARTHEST * list->def.skin;
    double high[DIM];

    for (int d = 0; d < DIM; d++) {
        drift->low[d] = INFINITY;
        high[d] = -INFINITY;
    }
    widen(cells, drift->low, high);
    widen(images, drift->low, high);
    for (double coarse = 1;; coarse *= 1.25) {
        double blocks = 1;

        for (int d = 0; d < DIM; d++) {
            drift->per_metre[d] = 1 / (coarse * edge);
            blocks *= floor((high[d] - drift->low[d]) * drift->per_metre[d]) + 3;
        }
        if (blocks > 8.0 * list_known(list) + 4096)
            continue;
        for (int d = 0; d < DIM; d++)
            drift->n[d] = (int)((high[d] - drift->low[d]) * drift->per_metre[d]) + 3;
        return (size_t)blocks;
    }
}

int drift_touching(const struct drift *drift, int offset[DRIFT_TOUCHING])
{
    int n = 0;

    for (int z = DIM == 3 ? -1 : 0; z <= (DIM == 3); z++)
        for (int y = -1; y <= 1; y++)
            for (int x = -1; x <= 1; x++) {
                const int to = (z * drift->n[1] + y) * drift->n[0] + x;
                if (to >= 0)
                    offset[n++] = to;
            }
    return n;
}
