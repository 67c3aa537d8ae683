/* images.c -- where particles stand in a domain that repeats, and images of those near
 * its sides. */
#include "space/images.h"

#include "base/status.h"
#include "base/threads.h"
#include "space/list-private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Images reach further than pairs are listed, by far more than rounding [radii]. */
static const double wider = 1e-3;

enum {
    IMAGES_EACH = 1 << DIM, /* of one particle at most, itself included      */
    WORTH_THREADS = 4096    /* particles that repay waking the threads       */
};

bool images_any(const struct list_def *def)
{
    for (int d = 0; d < DIM; d++)
        if (def->period[d] > 0)
            return true;
    return false;
}

static void set_sides(struct images *to, const struct list_def *def)
{
    const double reach = (def->support + def->skin) * (1 + wider);

    for (int d = 0; d < DIM; d++) {
        const bool repeats = def->period[d] > 0;

        to->low[d] = repeats ? def->side[d] + reach : -INFINITY;
        to->high[d] = repeats ? def->side[d] + def->period[d] - reach : INFINITY;
    }
}

int images_create(struct list *list)
{
    struct images *to = &list->own->images;
    const size_t n = (size_t)list->n + 1;

    if (!images_any(&list->def))
        return STATUS_DONE;
    set_sides(to, &list->def);
    to->home = status_alloc(n, sizeof *to->home);
    to->turns = status_alloc(n, sizeof *to->turns);
    list->offset = status_alloc(n, sizeof *list->offset);
    list->own->offset_room = n;
    return to->home && to->turns && list->offset ? STATUS_DONE : STATUS_FAILED;
}

void images_free(struct images *images)
{
    free(images->home);
    free(images->turns);
    free(images->all);
    *images = (struct images){ 0 };
}

/* The one sum by which positions become places: x and whole lengths. */
static double moved(const struct list_def *def, int d, double x, int turns)
{
    return turns ? x + turns * def->period[d] : x;
}

/* A particle so far away that lengths cannot be counted stays where it is; no sum with
 * such a position is worth anything. */
static int turns_of(const struct list_def *def, int d, double x)
{
    const double lengths = def->period[d] > 0 ? (x - def->side[d]) / def->period[d] : 0;

    if (!(fabs(lengths) < 1e9))
        return 0;
    return (lengths < (int)lengths) - (int)lengths; /* -floor() */
}

/* Rows of this thread, of `n` from `from` on, which are at `x`. */
static void bring_part(const struct list *list, const double *x, int from, int n)
{
    const struct threads_part part = threads_part(n);
    const struct images *to = &list->own->images;

    for (int i = part.from; i < part.to; i++)
        for (int d = 0; d < DIM; d++) {
            const double at = x[(size_t)i * DIM + (size_t)d];

            to->turns[from + i][d] = turns_of(&list->def, d, at);
            to->home[from + i][d] = moved(&list->def, d, at, to->turns[from + i][d]);
        }
}

void images_bring_home(const struct list *list, const struct cloud *cloud)
{
    for (int kind = 0; kind < KINDS; kind++) {
        const int from = list->def.from[kind], n = list->def.from[kind + 1] - from;

        THREADS(n > WORTH_THREADS, bring_part(list, cloud->x[kind], from, n));
    }
}

/* Bit d: near a side of direction d. */
static int sides_near(const struct images *images, const double *x)
{
    int near = 0;

    for (int d = 0; d < DIM; d++)
        near |= ((x[d] < images->low[d]) | (x[d] > images->high[d])) << d;
    return near;
}

/* The image beyond these sides of one that is at x, in row i. */
static void make_image(const struct list *list, int i, const double *x, int sides, struct image *image)
{
    const struct images *of = &list->own->images;

    image->of = i;
    for (int d = 0; d < DIM; d++) {
        const int shift = of->home[i][d] < of->low[d] ? 1 : -1;

        image->turns[d] = of->turns[i][d] + (sides >> d & 1 ? shift : 0);
        image->at[d] = moved(&list->def, d, x[d], image->turns[d]);
    }
}

void images_widen(const struct list *list, const double *x, int row, struct list_bounds *to)
{
    const struct images *of = &list->own->images;
    const int near = sides_near(of, of->home[row]);

    for (int sides = 1; sides <= near; sides++) {
        struct list_bounds one = { .n = 1 };
        struct image image;

        if (sides & ~near)
            continue;
        make_image(list, row, x, sides, &image);
        memcpy(one.low, image.at, sizeof one.low);
        memcpy(one.high, image.at, sizeof one.high);
        list_widen(to, &one);
    }
}

/* Images of one that is at x, for each choice of the sides it is near to. */
static int add(struct list *list, int i, const double *x, int near)
{
    struct images *to = &list->own->images;
    const size_t want = (size_t)to->n + IMAGES_EACH;

    if (!list_grow((void **)&to->all, &to->room, want, sizeof *to->all))
        return list_no_memory(list);
    for (int sides = 1; sides <= near; sides++) {
        if (sides & ~near)
            continue;
        make_image(list, i, x, sides, &to->all[to->n++]);
    }
    return STATUS_DONE;
}

static int find(struct list *list, const struct cloud *cloud, int kind)
{
    const int from = list->def.from[kind], n = list->def.from[kind + 1] - from;
    const int *row = cloud->row[kind];
    struct images *to = &list->own->images;

    to->from[kind] = to->n;
    for (int k = 0; k < n; k++) {
        const int i = from + (row ? row[k] : k), near = sides_near(to, to->home[i]);

        if (near && list->slot[i] >= 0)
            TRY(add(list, i, cloud->x[kind] + (size_t)(i - from) * DIM, near));
    }
    to->from[kind + 1] = to->n;
    return STATUS_DONE;
}

static int make_grid(struct list *list, int kind)
{
    const struct images *all = &list->own->images;
    struct cells *c = &list->own->image_cells[kind];
    double high[DIM];

    for (int d = 0; d < DIM; d++) {
        c->low[d] = INFINITY;
        high[d] = -INFINITY;
    }
    for (int m = all->from[kind]; m < all->from[kind + 1]; m++)
        for (int d = 0; d < DIM; d++) {
            const double x = all->all[m].at[d];

            c->low[d] = x < c->low[d] ? x : c->low[d];
            high[d] = x > high[d] ? x : high[d];
        }
    double n = all->from[kind + 1] - all->from[kind];
    if (list->whole) {
        memcpy(c->low, list->whole->images[kind].low, sizeof c->low);
        memcpy(high, list->whole->images[kind].high, sizeof high);
        n = list->whole->images[kind].n;
    }
    return cells_grid(list, c, high, n);
}

static void set_offset(struct list *list, int slot, const int *turns)
{
    for (int d = 0; d < DIM; d++)
        list->offset[slot][d] = turns[d] * list->def.period[d];
}

static int sort_kind(struct list *list, int kind)
{
    struct images *all = &list->own->images;
    struct cells *c = &list->own->image_cells[kind];

    TRY(make_grid(list, kind));
    for (int m = all->from[kind]; m < all->from[kind + 1]; m++) {
        all->all[m].rank = cells_rank(c, all->all[m].at);
        c->start[all->all[m].rank + 2]++;
    }
    cells_add_up(c, list->image[kind]);
    for (int m = all->from[kind]; m < all->from[kind + 1]; m++) {
        const struct image *image = &all->all[m];
        const int s = c->start[image->rank + 1]++;

        list->order[s] = image->of;
        set_offset(list, s, image->turns);
        cells_note(list, s, image->at);
    }
    return STATUS_DONE;
}

static int make_room(struct list *list)
{
    struct list_private *own = list->own;
    const size_t want = (size_t)(list->start[KINDS] + own->images.n) + LIST_PAD;

    for (int w = 0; w < LIST_WORDS; w++)
        if (!list_grow((void **)&own->place[w], &own->place_room[w], want, sizeof(int)))
            return list_no_memory(list);
    if (!list_grow((void **)&list->order, &own->order_room, want, sizeof *list->order)
        || !list_grow((void **)&list->offset, &own->offset_room, want, sizeof *list->offset))
        return list_no_memory(list);
    return STATUS_DONE;
}

int images_sort(struct list *list, const struct cloud *cloud)
{
    struct images *all = &list->own->images;

    all->n = 0;
    for (int kind = 0; kind < KINDS; kind++)
        TRY(find(list, cloud, kind));
    TRY(make_room(list));
    for (int i = 0; i < list->n; i++)
        if (list->slot[i] >= 0)
            set_offset(list, list->slot[i], all->turns[i]);
    for (int kind = 0; kind < KINDS; kind++) {
        list->image[kind] = list->start[KINDS] + all->from[kind];
        list->image[kind + 1] = list->start[KINDS] + all->from[kind + 1];
        TRY(sort_kind(list, kind));
    }
    return STATUS_DONE;
}
