/* scan.c -- finds neighbours among all particles of the cells around. */
#include "space/scan.h"

#if LANES == 8
#include "space/scan-sift.h"
#else
#include "space/scan-table.h"
#endif

#include <float.h>
#include <math.h>

enum {
    FARTHEST = 1 << 29, /* distance squared that places can tell [units^2]   */
    APART = LANES < 8 ? 1 : 2 /* owners spread over so many radii look alone */
};

/* All in the window, in ascending places. */
static void take_window(struct scan *s, const struct cells *c, const struct cells_window *w)
{
    const int more = w->high[0] - w->low[0] + 1;
#if DIM == 3
    for (int z = w->low[2]; z <= w->high[2]; z++) {
        const int row = z * c->n[1];
        const int from = z % 2 ? c->n[1] - 1 - w->high[1] : w->low[1];
        const int to = from + w->high[1] - w->low[1];
#else
    {
        const int row = 0, from = w->low[1], to = w->high[1];
#endif
        for (int y = from; y <= to; y++) {
            const int *start = c->start + cells_first(c, w, row + y);

            take_run(s, start[0], start[more]);
        }
    }
}

/* From 0, of a coordinate of any particle or image [m]. */
static double farthest(const struct list *list)
{
    double far = 0;

    for (int kind = 0; kind < KINDS; kind++)
        far = fmax(far, fmax(list->own->cells[kind].farthest, list->own->image_cells[kind].farthest));
    return far;
}

/* Places are whole, so a distance is off by 2 sqrt(3) units at most; products of
 * coordinates are rounded. */
void scan_start(struct scan *s, const struct list *list, int *near, size_t room)
{
    const double radius = list->def.support + list->def.skin;

    s->list = list;
    s->wide = LIST_UNITS * (1 + 4 * DBL_EPSILON * farthest(list) / radius) + 4;
    s->reach = s->wide / list->own->per_metre;
    s->bound = (int)fmin(s->wide * s->wide, FARTHEST);
    for (int l = 0; l < LANES; l++)
        s->near[l] = near + (size_t)l * room;
    prepare(s);
}

static const double *position(const struct scan *s, int lane)
{
    return s->list->own->stand + (size_t)DIM * (size_t)s->list->order[s->group + lane];
}

/* From now on lanes first..last-1 look for neighbours. */
static void let_look(struct scan *s, int first, int last)
{
    double low[DIM], high[DIM];

    s->first = first;
    s->last = last;
    memcpy(low, position(s, first), sizeof low);
    memcpy(high, low, sizeof high);
    for (int l = first + 1; l < last; l++) {
        const double *x = position(s, l);

        for (int d = 0; d < DIM; d++) {
            low[d] = x[d] < low[d] ? x[d] : low[d];
            high[d] = x[d] > high[d] ? x[d] : high[d];
        }
    }
    memcpy(s->low, low, sizeof low);
    memcpy(s->high, high, sizeof high);
    set_lanes(s);
}

void scan_group(struct scan *s, int group, int owners)
{
    s->group = group;
    s->owners = owners;
    let_look(s, 0, owners);
    s->apart = false;
    for (int d = 0; d < DIM; d++)
        s->apart |= s->high[d] - s->low[d] > APART * s->reach;
}

/* All of a kind, then of its images, that may be near the box. */
static void take_box(struct scan *s, int kind)
{
    const struct list_private *own = s->list->own;
    struct cells_window w;
    double low[DIM], high[DIM];

    for (int d = 0; d < DIM; d++) {
        low[d] = s->low[d] - s->reach;
        high[d] = s->high[d] + s->reach;
    }
    if (cells_window(&own->cells[kind], low, high, &w))
        take_window(s, &own->cells[kind], &w);
    if (s->list->offset && images_near(&own->images, s->low, s->high)
        && cells_window(&own->image_cells[kind], low, high, &w))
        take_window(s, &own->image_cells[kind], &w);
    take_rest(s);
}

/* Owners so far apart that their common box holds too many look one by one. */
void scan_near(struct scan *s, int kind)
{
    memset(s->count, 0, sizeof s->count);
    if (!s->apart)
        take_box(s, kind);
    for (int l = 0; l < s->owners && s->apart; l++) {
        let_look(s, l, l + 1);
        take_box(s, kind);
    }
}
