/* images.c -- where everybody stands in a domain that repeats, and images of those near
 * its sides. */
#include "space/images.h"

#include "base/status.h"
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

int images_create(struct list *list)
{
    struct images *to = &list->own->images;
    const size_t n = (size_t)list->n + 1;

    if (!images_any(&list->def))
        return STATUS_DONE;
    to->home = status_alloc(n, sizeof *to->home);
    to->turns = status_alloc(n, sizeof *to->turns);
    return to->home && to->turns ? STATUS_DONE : STATUS_FAILED;
}

void images_free(struct images *images)
{
    free(images->home);
    free(images->turns);
    free(images->of);
    free(images->shift);
    free(images->rank);
    *images = (struct images){ 0 };
}

/* The one sum by which positions become places: x and whole lengths. */
static double moved(const struct list_def *def, int d, double x, int turns)
{
    return turns ? x + turns * def->period[d] : x;
}

/* Somebody so far away that lengths cannot be counted stays where it is; no sum with
 * such a position is worth anything. */
static int turns_of(const struct list_def *def, int d, double x)
{
    const double turns = def->period[d] > 0 ? -floor((x - def->side[d]) / def->period[d]) : 0;

    return fabs(turns) < 1e9 ? (int)turns : 0;
}

void images_bring_home(struct list *list, const struct cloud *cloud)
{
    struct images *to = &list->own->images;

    for (int kind = 0; kind < KINDS; kind++) {
        const int from = list->def.from[kind], end = list->def.from[kind + 1];

#pragma omp parallel for schedule(static) if (end - from > WORTH_THREADS)
        for (int i = from; i < end; i++) {
            const double *x = cloud->x[kind] + (size_t)(i - from) * DIM;

            for (int d = 0; d < DIM; d++) {
                to->turns[i][d] = turns_of(&list->def, d, x[d]);
                to->home[i][d] = moved(&list->def, d, x[d], to->turns[i][d]);
            }
        }
    }
}

/* Shifts to all images of one who stands at x, to itself first; their number. */
static int shifts_of(const struct list_def *def, const double *x, int shift[IMAGES_EACH][DIM])
{
    const double reach = (def->support + def->skin) * (1 + wider);
    int n = 1;

    memset(shift[0], 0, sizeof shift[0]);
    for (int d = 0; d < DIM; d++) {
        const bool low = x[d] < def->side[d] + reach;
        const bool high = x[d] > def->side[d] + def->period[d] - reach;
        if (!(def->period[d] > 0) || !(low || high))
            continue;
        memcpy(shift + n, shift, (size_t)n * sizeof *shift);
        for (int k = n; k < 2 * n; k++)
            shift[k][d] = low ? 1 : -1;
        n *= 2;
    }
    return n;
}

static int add(struct list *list, int i, const int *shift)
{
    struct images *to = &list->own->images;
    const size_t want = (size_t)to->n + 1;

    if (!list_grow((void **)&to->of, &to->of_room, want, sizeof *to->of)
        || !list_grow((void **)&to->rank, &to->rank_room, want, sizeof *to->rank)
        || !list_grow((void **)&to->shift, &to->shift_room, want, sizeof *to->shift))
        return list_no_memory(list);
    to->of[to->n] = i;
    memcpy(to->shift[to->n++], shift, sizeof *to->shift);
    return STATUS_DONE;
}

static int find(struct list *list)
{
    struct images *to = &list->own->images;
    int shift[IMAGES_EACH][DIM];

    to->n = 0;
    for (int kind = 0; kind < KINDS; kind++) {
        to->from[kind] = to->n;
        for (int i = list->def.from[kind]; i < list->def.from[kind + 1]; i++) {
            if (list->slot[i] < 0)
                continue;
            const int n = shifts_of(&list->def, to->home[i], shift);
            for (int k = 1; k < n; k++)
                TRY(add(list, i, shift[k]));
        }
    }
    to->from[KINDS] = to->n;
    return STATUS_DONE;
}

/* Where image m stands, and how many lengths from its position. */
static void place_of(const struct list *list, const struct cloud *cloud, int kind, int m,
                     double *x, double *offset)
{
    const struct images *all = &list->own->images;
    const int i = all->of[m];
    const double *from = cloud->x[kind] + (size_t)(i - list->def.from[kind]) * DIM;

    for (int d = 0; d < DIM; d++) {
        const int turns = all->turns[i][d] + all->shift[m][d];
        x[d] = moved(&list->def, d, from[d], turns);
        offset[d] = turns * list->def.period[d];
    }
}

static int make_grid(struct list *list, const struct cloud *cloud, int kind)
{
    const struct images *all = &list->own->images;
    struct cells *c = &list->own->image_cells[kind];
    double high[DIM], x[DIM], offset[DIM];

    for (int d = 0; d < DIM; d++) {
        c->low[d] = INFINITY;
        high[d] = -INFINITY;
    }
    for (int m = all->from[kind]; m < all->from[kind + 1]; m++) {
        place_of(list, cloud, kind, m, x, offset);
        for (int d = 0; d < DIM; d++) {
            c->low[d] = fmin(c->low[d], x[d]);
            high[d] = fmax(high[d], x[d]);
            list->own->farthest = fmax(list->own->farthest, fabs(x[d]));
        }
    }
    return cells_grid(list, c, high, all->from[kind + 1] - all->from[kind]);
}

static int sort_kind(struct list *list, const struct cloud *cloud, int kind)
{
    struct images *all = &list->own->images;
    struct cells *c = &list->own->image_cells[kind];
    double x[DIM], offset[DIM];

    TRY(make_grid(list, cloud, kind));
    for (int m = all->from[kind]; m < all->from[kind + 1]; m++) {
        place_of(list, cloud, kind, m, x, offset);
        all->rank[m] = cells_rank(c, x);
        c->start[all->rank[m] + 2]++;
    }
    cells_add_up(c, list->image[kind]);
    for (int m = all->from[kind]; m < all->from[kind + 1]; m++) {
        const int s = c->start[all->rank[m] + 1]++;

        place_of(list, cloud, kind, m, x, list->offset[s]);
        list->order[s] = all->of[m];
        cells_note(list, s, x);
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
    const struct images *all = &list->own->images;

    TRY(find(list));
    TRY(make_room(list));
    for (int s = 0; s < list->start[KINDS]; s++)
        for (int d = 0; d < DIM; d++)
            list->offset[s][d] = all->turns[list->order[s]][d] * list->def.period[d];
    for (int kind = 0; kind < KINDS; kind++) {
        list->image[kind] = list->start[KINDS] + all->from[kind];
        list->image[kind + 1] = list->start[KINDS] + all->from[kind + 1];
        TRY(sort_kind(list, cloud, kind));
    }
    return STATUS_DONE;
}
