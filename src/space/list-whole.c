/* list-whole.c -- what one of many ranks must know of all particles, so that its list has the grids,
 * the order and the patience of one that has them all. */
#include "space/growing.h"
#include "space/list-private.h"

#include <math.h>
#include <string.h>

static const double rounding = 1e-6;

static struct list_bounds none(void)
{
    struct list_bounds none = { .n = 0 };

    for (int d = 0; d < DIM; d++) {
        none.low[d] = INFINITY;
        none.high[d] = -INFINITY;
    }
    return none;
}

static struct list_bounds grown(const struct growing *b)
{
    struct list_bounds to = { .n = b->n };

    coords_put(b->low, to.low);
    coords_put(b->high, to.high);
    return to;
}

/* Of a kind.  Fluid of others is not here. */
static void bound(const struct list *list, const struct cloud *cloud, int kind, struct list_whole *to)
{
    const int first = list->def.from[kind], n = list->def.from[kind + 1] - first;
    const double *x = list_homes(list, cloud, kind), *was = cloud->x[kind];
    struct growing own = growing_none(), others = growing_none(), all;

    to->images[kind] = none();
    for (int i = 0; i < n; i++, x += DIM, was += DIM) {
        const bool mine = list->mine[first + i];

        if ((kind == KIND_FLUID && !mine) || !list_inside(&list->def, x))
            continue;
        if (mine)
            growing_take(&own, coords_at(x));
        else
            growing_take(&others, coords_at(x));
        if (list->own->images.home)
            images_widen(list, was, first + i, &to->images[kind]);
    }
    all = own;
    growing_join(&all, &others);
    to->of[kind] = grown(&all);
    to->mine[kind] = grown(&own);
}

void list_bounds(const struct list *list, const struct cloud *cloud, struct list_whole *to,
                 struct list_bounds *box)
{
    if (list->own->images.home)
        images_bring_home(list, cloud);
    *box = none();
    for (int kind = 0; kind < KINDS; kind++) {
        if (!to->stands || !list_is_still(list, kind))
            bound(list, cloud, kind, to);
        list_widen(box, &to->mine[kind]);
    }
    to->stands = true;
}

/* The grid that sorting will have for these. */
static struct cells grid_of(const struct list *list, const struct list_bounds *b)
{
    struct cells c = { .room = 0 };

    memcpy(c.low, b->low, sizeof c.low);
    if (b->n > 0)
        cells_shape(list, &c, b->high, b->n);
    return c;
}

double list_reach(const struct list *list, const struct list_whole *whole)
{
    struct cells cells[KINDS], images[KINDS];
    struct drift drift = { .useds = 0 };
    double most = 0;

    for (int kind = 0; kind < KINDS; kind++) {
        cells[kind] = grid_of(list, &whole->of[kind]);
        images[kind] = grid_of(list, &whole->images[kind]);
    }
    if (list_known(list) == 0)
        return 0;
    drift_shape(list, cells, images, &drift);
    for (int d = 0; d < DIM; d++)
        most = fmax(most, 2 * (1 + rounding) / drift.per_metre[d]);
    return most;
}

struct list_zone list_zone(const struct list *list, const struct list_bounds *box, double reach)
{
    struct list_zone zone = { .list = list, .any = box->n > 0 };

    for (int d = 0; d < DIM; d++) {
        zone.low[d] = box->low[d] - reach;
        zone.high[d] = box->high[d] + reach;
        zone.repeats |= list->def.period[d] > 0;
    }
    return zone;
}

/* Is some place from low to high in it, or an image of one? */
static bool touches(const struct list_zone *zone, const double *low, const double *high)
{
    enum { TURNS = 2 }; /* two images of one direction may meet */
    bool near = zone->any;

    for (int d = 0; d < DIM && near; d++) {
        const double period = zone->list->def.period[d];
        const int turns = period > 0 ? TURNS : 0;

        near = false;
        for (int k = -turns; k <= turns && !near; k++)
            near = high[d] + k * period >= zone->low[d] && low[d] + k * period <= zone->high[d];
    }
    return near;
}

bool list_image_near(const struct list_zone *zone, const double *x)
{
    return touches(zone, x, x);
}

bool list_meets(const struct list_zone *zone, const struct list_bounds *of)
{
    return of->n > 0 && touches(zone, of->low, of->high);
}

double list_order(const struct list *list, int row)
{
    static const double cells = 1099511627776; /* 2^40, more than a kind has */
    int kind = 0;

    while (row >= list->def.from[kind + 1])
        kind++;
    return kind * cells + cells_rank(&list->own->cells[kind], list->own->stand + (size_t)DIM * (size_t)row);
}
