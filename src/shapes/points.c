/* points.c -- a list of places that grows. */
#include "shapes/points.h"

#include "base/status.h"
#include <stdlib.h>
#include <string.h>

int points_reserve(struct points *p, long more)
{
    const long room = p->n + more > 2 * p->room ? p->n + more : 2 * p->room;
    double (*x)[DIM];

    if (p->n + more <= p->room)
        return STATUS_DONE;
    x = status_alloc(room, sizeof *x);
    if (!x)
        return STATUS_FAILED;
    if (p->n > 0)
        memcpy(x, p->x, p->n * sizeof *x);
    free(p->x);
    p->x = x;
    p->room = room;
    return STATUS_DONE;
}

int points_add(struct points *p, const double *x)
{
    TRY(points_reserve(p, 1));
    memcpy(p->x[p->n++], x, sizeof *p->x);
    return STATUS_DONE;
}

void points_free(struct points *p)
{
    free(p->x);
    *p = (struct points){ 0 };
}
