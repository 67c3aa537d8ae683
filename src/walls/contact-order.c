/* contact-order.c -- particles of solids along a curve that stays near where it was. */
#include "walls/contact-order.h"

#include "base/status.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

enum { BITS = 64 / DIM }; /* of a cell's number along an axis */

struct place {
    uint64_t cell; /* bits of its numbers along the axes in turn */
    int group, solid;
};

static const double *place_of(const struct part_places *at, int solid)
{
    return at->p->x0[at->p->from[KIND_WALL] + solid];
}

/* Counted from the sides of the domain: of walls beyond them water mostly reaches two layers, and these share
 * cells of twice the width. */
static uint64_t cell_of(const struct scales *s, const double *x)
{
    static const double most = (double)((1ull << BITS) - 1), middle = (double)(1ull << (BITS - 1));
    uint64_t cell = 0;

    for (int d = 0; d < DIM; d++) {
        const double along = floor((x[d] - s->low[d]) / s->dx) + middle;
        const uint64_t k = (uint64_t)fmin(fmax(along, 0), most);
        for (int b = 0; b < BITS; b++)
            cell |= (k >> b & 1) << (b * DIM + d);
    }
    return cell;
}

static int compare(const void *one, const void *other)
{
    const struct place *a = one, *b = other;

    if (a->group != b->group)
        return a->group < b->group ? -1 : 1;
    if (a->cell != b->cell)
        return a->cell < b->cell ? -1 : 1;
    return (a->solid > b->solid) - (a->solid < b->solid);
}

int contact_order_sort(const struct part_places *at, int n, int *solid)
{
    struct place *place = status_alloc((unsigned long)n + 1, sizeof *place);
    const int first = at->p->from[KIND_WALL];

    if (!place)
        return STATUS_FAILED;
    for (int i = 0; i < n; i++)
        place[i] = (struct place){ .cell = cell_of(at->p->scales, place_of(at, solid[i])),
                                   .group = at->solid[at->p->object_of[first + solid[i]]].group,
                                   .solid = solid[i] };
    qsort(place, (size_t)n, sizeof *place, compare);
    for (int i = 0; i < n; i++)
        solid[i] = place[i].solid;
    free(place);
    return STATUS_DONE;
}
