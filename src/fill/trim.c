/* trim.c -- fluid with a slanted or round border makes room for walls it touches. */
#include "fill/trim.h"

#include "base/status.h"
#include "fill/buckets.h"
#include <string.h>

/* On the common border of fluid and wall a site is 0.73 dx from the nearest of a row
 * that stands half a spacing behind it in steps of up to 1.05 dx [dx] */
static const double room = 0.75;

static bool is_ragged(const struct fill_item *item)
{
    return item->kind == KIND_FLUID && item->shape
        && !(item->shape->kind == SHAPE_BOX && item->shape->angle == 0);
}

static bool is_wall(const struct fill_item *item)
{
    return item->kind == KIND_WALL || item->kind == KIND_WALL_SLIP;
}

static int gather_walls(const struct fill_item *item, int items, const struct points *points,
                        struct points *walls)
{
    for (int k = 0; k < items; k++)
        if (is_wall(&item[k]) && points[k].n > 0) {
            TRY(points_reserve(walls, points[k].n));
            memcpy(walls->x + walls->n, points[k].x, points[k].n * sizeof *walls->x);
            walls->n += points[k].n;
        }
    return STATUS_DONE;
}

static void trim(struct points *p, const struct buckets *walls)
{
    long n = 0;

    for (long i = 0; i < p->n; i++)
        if (buckets_find(walls, p->x[i], walls->width, NULL, NULL) < 0)
            memmove(p->x[n++], p->x[i], sizeof *p->x);
    p->n = n;
}

static int trim_all(const struct fill_item *item, int items, double dx, struct points *points,
                    struct points *walls)
{
    struct buckets b;

    TRY(gather_walls(item, items, points, walls));
    TRY(buckets_create(&b, (const double (*)[DIM])walls->x, (int)walls->n, room * dx));
    for (int k = 0; k < items; k++)
        if (is_ragged(&item[k]))
            trim(&points[k], &b);
    buckets_free(&b);
    return STATUS_DONE;
}

int trim_fluids(const struct fill_item *item, int items, double dx, struct points *points)
{
    struct points walls = { 0 };
    int code = STATUS_DONE, ragged = 0;

    for (int k = 0; k < items; k++)
        ragged += is_ragged(&item[k]);
    if (ragged > 0)
        code = trim_all(item, items, dx, points, &walls);
    points_free(&walls);
    return code;
}
