/* list.c -- the pair list but for its rows: freshness, rebuilding. */
#include "space/list-private.h"
#include "space/reach.h"

#include "base/status.h"
#include "base/threads.h"
#include "base/waiting.h"

#include <math.h>
#include <string.h>

/* Particles from which rebuilding repays waking the threads. */
enum { WORTH_BUILDING = 500 };

struct check {
    bool moved; /* a particle, further than half the margin                  */
    bool back;  /* one that was left out is inside again                     */
    int bad; /* lowest row with a position that is not finite, or n           */
};

/* A particle that moved far, was left out, or is nowhere: which of them? */
static void look_closer(const struct list *list, int i, const double *x, struct check *c)
{
    for (int d = 0; d < DIM; d++)
        if (!isfinite(x[d])) {
            c->bad = i < c->bad ? i : c->bad;
            return;
        }
    c->moved |= list->slot[i] >= 0;
    c->back |= list->slot[i] < 0 && list_inside(&list->def, x);
}

/* Displacements of particles of one kind, x of the first; `built` of those left out is infinite.  Most
 * are near, and asked together. */
static void check_range(const struct list *list, const double *x, int from, int to,
                        struct check *c)
{
    enum { STRETCH = 64 };
    const double *built = list->own->built + (size_t)DIM * (size_t)from;
    const double limit = list->def.skin / 2;

    for (; from < to; from += STRETCH, x += STRETCH * DIM, built += STRETCH * DIM) {
        const int n = to - from < STRETCH ? to - from : STRETCH;

        if (reach_all_within(x, built, n, limit))
            continue;
        for (int k = 0; k < n; k++)
            if (!(list_square(x + (size_t)k * DIM, built + (size_t)k * DIM) <= limit * limit))
                look_closer(list, from + k, x + (size_t)k * DIM, c);
    }
}

/* Part t of `of`. */
static struct check check_part(const struct list *list, const struct cloud *cloud, long t, long of)
{
    struct check c = { false, false, list->n };

    for (int kind = 0; kind < KINDS; kind++) {
        const long first = list->def.from[kind], n = list->def.from[kind + 1] - first;
        const int from = (int)(first + n * t / of), to = (int)(first + n * (t + 1) / of);

        if (!list->stands || !list_is_still(list, kind))
            check_range(list, cloud->x[kind] + DIM * (from - first), from, to, &c);
    }
    return c;
}

static struct check check(const struct list *list, const struct cloud *cloud)
{
    bool moved = false, back = false;
    int bad = list->n;

    if (threads_most() == 1)
        return check_part(list, cloud, 0, 1);
#pragma omp parallel if (waiting_repays(list->n)) reduction(|| : moved, back) \
    reduction(min : bad)
    {
        const struct check c = check_part(list, cloud, threads_me(), threads_all());

        moved = c.moved;
        back = c.back;
        bad = c.bad;
    }
    return (struct check){ moved, back, bad };
}

static bool outdated(const struct list *list, const struct cloud *cloud, const struct check *c,
                     bool harmed)
{
    return !list->stands || c->back
           || (c->moved && (harmed || !drift_harmless(list, cloud)));
}

/* As long as blocks answer, no particle need be asked: they cannot where one is nowhere, and
 * do not know of those left out. */
static bool blocks_first(const struct list *list)
{
    return list->stands && list->own->drift.far && list->start[KINDS] == list->n;
}

bool list_stale(const struct list *list, const struct cloud *cloud)
{
    if (!list->stands)
        return true;
    const struct check c = check(list, cloud);
    return c.bad < list->n || outdated(list, cloud, &c, false);
}

void list_forget(struct list *list)
{
    list->stands = false;
}

static void make_groups(struct list *list)
{
    struct list_private *own = list->own;

    list->groups = 0;
    for (int kind = 0; kind < KINDS; kind++) {
        list->group_from[kind] = list->groups;
        if (!list->def.acts[kind])
            continue;
        for (int s = list->start[kind]; s < list->start[kind + 1]; s += list->lanes) {
            own->group_slot[list->groups] = s;
            own->group_kind[list->groups++] = kind;
        }
    }
    list->group_from[KINDS] = list->groups;
}

static int make_stores(struct list *list, int threads)
{
    struct list_private *own = list->own;
    size_t room = (size_t)own->stores;

    if (threads > own->stores) {
        if (!list_grow((void **)&own->store, &room, (size_t)threads, sizeof *own->store))
            return list_no_memory(list);
        memset(own->store + own->stores, 0, (room - (size_t)own->stores) * sizeof *own->store);
        own->stores = (int)room;
    }
    for (int t = 0; t < own->stores; t++) {
        own->store[t].used = own->store[t].founds = 0;
        own->store[t].failed = false;
    }
    return STATUS_DONE;
}

/* Now that the stores no longer move: segments in order of groups. */
static int join(struct list *list)
{
    struct list_private *own = list->own;
    size_t n = 0;

    for (int t = 0; t < own->stores; t++) {
        if (own->store[t].failed)
            return list_no_memory(list);
        n += own->store[t].founds;
    }
    if (!list_grow((void **)&own->segment, &own->segment_room, n, sizeof *own->segment))
        return list_no_memory(list);
    list->segment = own->segment;
    n = 0;
    for (int t = 0; t < own->stores; t++) {
        const struct list_store *s = &own->store[t];

        for (size_t k = 0; k < s->founds; k++)
            own->segment[n++] = (struct list_segment){ s->found[k].partner, s->found[k].rows,
                                                       s->j + s->found[k].at };
    }
    own->segment_from[0] = 0;
    own->rows_before[0] = 0;
    for (int g = 0; g < list->groups; g++) {
        own->segment_from[g + 1] += own->segment_from[g];
        own->rows_before[g + 1] += own->rows_before[g];
    }
    return STATUS_DONE;
}

/* Where each of the threads begins: at equal shares of rows of the list that was, which had
 * `groups` groups, as this one will be much like it. */
static void share_groups(struct list *list, int groups, int threads)
{
    const long *rows = list->own->rows_before;
    int g = 0;

    for (int t = 0; t < threads; t++) {
        const double part = (double)t / threads;

        if (groups == 0)
            g = (int)(part * list->groups);
        while (g < groups && rows[g] + 4.0 * g < part * (rows[groups] + 4.0 * groups))
            g++;
        list->own->store[t].from = g < list->groups ? g : list->groups;
    }
}

/* All particles in places, images behind all others. */
static int sort(struct list *list, const struct cloud *cloud)
{
    const bool repeats = list->own->images.home;

    if (repeats)
        images_bring_home(list, cloud);
    TRY(cells_sort(list, cloud));
    for (int kind = 0; kind <= KINDS; kind++)
        list->image[kind] = list->start[KINDS];
    if (repeats)
        TRY(images_sort(list, cloud));
    list->listed = list->image[KINDS];
    for (int w = 0; w < LIST_WORDS; w++)
        memset(list->own->place[w] + list->listed, 0, LIST_PAD * sizeof(int));
    return STATUS_DONE;
}

/* All rows; the list had `before` groups. */
static void find_rows(struct list *list, list_rows *rows, int before)
{
    const int t = threads_me(), of = threads_all();
    struct list_store *store = list->own->store, mine; /* two in an array share a line of the cache */

#pragma omp single nowait
    share_groups(list, before, of);
    threads_meet();
    mine = store[t];
    rows(list, &mine, mine.from, t + 1 < of ? store[t + 1].from : list->groups);
    store[t] = mine;
}

int list_rebuild(struct list *list, const struct cloud *cloud, list_rows *rows)
{
    const int before = list->groups;

    if (list->whole)
        list_leave_out(list);
    list->stands = false; /* should there be no memory on the way */
    TRY(sort(list, cloud));
    TRY(drift_note(list, cloud));
    make_groups(list);
    TRY(make_stores(list, threads_most()));
    THREADS(list->listed > WORTH_BUILDING, find_rows(list, rows, before));
    TRY(join(list));
    list->builds++;
    list->stands = true;
    return STATUS_DONE;
}

static bool finite_position(const double *x)
{
    bool good = true;

    for (int d = 0; d < DIM; d++)
        good &= isfinite(x[d]) != 0;
    return good;
}

/* Of the particles with a position that is not finite, that with the smallest id, where
 * `bad` is the lowest row of them. */
static int refuse_bad(struct list *list, const struct cloud *cloud, int bad)
{
    int kind = 0, k;

    while (bad >= list->def.from[kind + 1])
        kind++;
    const int from = list->def.from[kind], *row = cloud->row[kind];
    for (k = row ? 0 : bad - from; row && finite_position(cloud->x[kind] + (size_t)row[k] * DIM);)
        k++;
    return list_nowhere(list, from + (row ? row[k] : k), from + k);
}

int list_update(struct list *list, const struct cloud *cloud, list_rows *rows)
{
    list->bad = -1;
    if (!list->stands)
        list_leave_out(list);
    const bool asked = blocks_first(list);
    if (asked && drift_harmless(list, cloud))
        return STATUS_DONE;
    const struct check c = check(list, cloud);

    list->own->drift.far = c.moved;
    if (c.bad < list->n)
        return refuse_bad(list, cloud, c.bad);
    return outdated(list, cloud, &c, asked) ? list_rebuild(list, cloud, rows) : STATUS_DONE;
}

double list_entries(const struct list *list)
{
    return (double)list->rows_before[list->groups] * list->lanes;
}
