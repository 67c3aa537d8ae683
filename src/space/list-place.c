/* list-place.c -- where particles stand as a list sees them, and boxes around them. */
#include "space/list-private.h"

#include "base/status.h"

#include <math.h>

const double *list_home(const struct list *list, const struct cloud *cloud, int kind, int row)
{
    return list_homes(list, cloud, kind) + (size_t)DIM * (size_t)(row - list->def.from[kind]);
}

void list_leave_out(struct list *list)
{
    const int n = list->stands ? list->start[KINDS] : list->n;

    list->own->sorted = 0;
    for (int i = 0; i < n; i++) {
        const int row = list->stands ? list->order[i] : i;
        list->slot[row] = -1;
        for (int d = 0; d < DIM && !list->whole; d++)
            list->own->built[(size_t)DIM * (size_t)row + (size_t)d] = INFINITY;
    }
}

void list_widen(struct list_bounds *to, const struct list_bounds *by)
{
    to->n += by->n;
    for (int d = 0; d < DIM; d++) {
        to->low[d] = by->low[d] < to->low[d] ? by->low[d] : to->low[d];
        to->high[d] = by->high[d] > to->high[d] ? by->high[d] : to->high[d];
    }
}

int list_nowhere(struct list *list, int row, int id)
{
    list->bad = row;
    return status_fail(STATUS_FAILED, "the position of particle %d is not a number: the step "
                       "was too large, or a force is not finite", id);
}
