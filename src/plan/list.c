/* list.c -- how far the list of pairs looks, and where. */
#include "plan/inside.h"

#include <math.h>
#include <string.h>

/* How far walls move along each axis until the end [m]: a tank carries what is in it along. */
static void wall_reach(const struct plan *p, double *most)
{
    for (int d = 0; d < DIM; d++)
        most[d] = 0;
    for (int i = 0; i < p->walls; i++) {
        double low[DIM], high[DIM], reach[DIM];
        shape_bounds(&p->in.wall[i].set.shape, low, high);
        motion_extent(&p->wall[i].motion, low, high, p->in.set.until, reach);
        for (int d = 0; d < DIM; d++)
            most[d] = fmax(most[d], reach[d]);
    }
}

/* Kinds of walls, if none moves. */
static unsigned still_kinds(const struct plan *p)
{
    for (int i = 0; i < p->walls; i++)
        if (p->wall[i].moves)
            return 0;
    return KIND_BIT(KIND_WALL) | KIND_BIT(KIND_WALL_SLIP);
}

/* Which kinds meet was noted with the tables. */
void plan_list_make(struct plan *p)
{
    struct list_def *d = &p->list_def;
    double reach[DIM];

    wall_reach(p, reach);
    memcpy(d->from, p->particles->from, sizeof d->from);
    d->still = still_kinds(p);
    d->support = p->scales.support;
    d->skin = p->in.kernel.skin * p->scales.support;
    for (int i = 0; i < DIM; i++) { /* walls stand outside of the domain */
        const double room = (ceil(p->in.kernel.support) + 0.5) * p->scales.dx + reach[i];
        d->low[i] = p->scales.low[i] - room;
        d->high[i] = p->scales.high[i] + room;
        if (p->scales.period[i] > 0) {
            d->period[i] = p->scales.period[i];
            d->side[i] = p->scales.low[i];
            d->low[i] = -HUGE_VAL;
            d->high[i] = HUGE_VAL;
        }
    }
}
