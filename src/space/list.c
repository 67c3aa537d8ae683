/* list.c -- the pair list but for its rows: memory, freshness, rebuilding. */
#include "space/list-private.h"

#include "base/status.h"
#include "base/threads.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Particles whose check and whose rebuilding repay waking the threads. */
enum { WORTH_CHECKING = 20000, WORTH_BUILDING = 500 };

struct check {
    bool moved; /* somebody, further than half the skin                      */
    bool back;  /* one who was left out is inside again                      */
    int bad; /* lowest row with a position that is not finite, or n           */
};

bool list_grow(void **array, size_t *room, size_t want, size_t size)
{
    if (want <= *room)
        return true;
    size_t now = *room + *room / 2;
    if (now < want)
        now = want;
    void *bigger = now <= SIZE_MAX / size ? realloc(*array, now * size) : NULL;
    if (!bigger)
        return false;
    *array = bigger;
    *room = now;
    return true;
}

int list_no_memory(const struct list *list)
{
    return status_fail(STATUS_FAILED, "no memory for the pair list of %d particles: they are "
                       "too many for this machine, or have drawn together in one place", list->n);
}

static void *array(size_t count, size_t size)
{
    return status_alloc(count > 0 ? count : 1, size);
}

int list_create(struct list **list, const struct list_def *def, int lanes)
{
    struct list *made = array(1, sizeof *made);
    struct list_private *own = array(1, sizeof *own);
    const size_t n = (size_t)def->from[KINDS];
    const size_t groups = n / (size_t)lanes + KINDS;

    *list = made;
    if (!made || !own) {
        free(own);
        free(made);
        *list = NULL;
        return STATUS_FAILED;
    }
    *made = (struct list){ .def = *def, .lanes = lanes, .n = (int)n, .bad = -1, .own = own };
    made->order = array(n, sizeof *made->order);
    made->slot = array(n, sizeof *made->slot);
    own->built = array(n * DIM, sizeof *own->built);
    own->order_room = n;
    own->per_metre = LIST_UNITS / (def->support + def->skin);
    bool good = made->order && made->slot && own->built && images_create(made) == STATUS_DONE;
    for (int w = 0; w < LIST_WORDS; w++) {
        good = good && (own->place[w] = array(n + LIST_PAD, sizeof(int)));
        own->place_room[w] = n + LIST_PAD;
    }
    own->stand = own->images.home ? own->images.home[0] : own->built;
    made->group_slot = own->group_slot = array(groups, sizeof *own->group_slot);
    made->group_kind = own->group_kind = array(groups, sizeof *own->group_kind);
    made->segment_from = own->segment_from = array(groups + 1, sizeof *own->segment_from);
    made->rows_before = own->rows_before = array(groups + 1, sizeof *own->rows_before);
    if (good && own->group_slot && own->group_kind && own->segment_from && own->rows_before)
        return STATUS_DONE;
    list_free(list);
    return STATUS_FAILED;
}

void list_free(struct list **list)
{
    if (!*list)
        return;
    struct list_private *own = (*list)->own;

    for (int t = 0; t < own->stores; t++) {
        free(own->store[t].j);
        free(own->store[t].found);
        free(own->store[t].near);
    }
    for (int kind = 0; kind < KINDS; kind++) {
        free(own->cells[kind].start);
        free(own->image_cells[kind].start);
    }
    images_free(&own->images);
    drift_free(&own->drift);
    for (int w = 0; w < LIST_WORDS; w++)
        free(own->place[w]);
    free(own->store);
    free(own->built);
    free(own->group_slot);
    free(own->group_kind);
    free(own->segment_from);
    free(own->rows_before);
    free(own->segment);
    free(own);
    free((*list)->order);
    free((*list)->offset);
    free((*list)->slot);
    free(*list);
    *list = NULL;
}

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

/* |a - b|^2, written out: everybody is asked in every right-hand side. */
static inline double distance2(const double *a, const double *b)
{
    double sum = (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);

#if DIM == 3
    sum += (a[2] - b[2]) * (a[2] - b[2]);
#endif
    return sum;
}

/* Displacements of the particles from..to-1 of one kind, x of the first; those
 * left out have an infinite `built`, so they are always looked at. */
static void check_range(const struct list *list, const double *x, int from, int to,
                        struct check *c)
{
    const double *built = list->own->built + (size_t)DIM * (size_t)from;
    const double limit = list->def.skin / 2;

    for (int i = from; i < to; i++, x += DIM, built += DIM)
        if (!(distance2(x, built) <= limit * limit))
            look_closer(list, i, x, c);
}

static struct check check(const struct list *list, const struct cloud *cloud)
{
    bool moved = false, back = false;
    int bad = list->n;

#pragma omp parallel if (list->n > WORTH_CHECKING) reduction(|| : moved, back) \
    reduction(min : bad)
    {
        struct check c = { false, false, list->n };
        const long t = threads_me(), of = threads_all();

        for (int kind = 0; kind < KINDS; kind++) {
            const long first = list->def.from[kind], n = list->def.from[kind + 1] - first;
            const int from = (int)(first + n * t / of), to = (int)(first + n * (t + 1) / of);

            check_range(list, cloud->x[kind] + DIM * (from - first), from, to, &c);
        }
        moved = c.moved;
        back = c.back;
        bad = c.bad;
    }
    return (struct check){ moved, back, bad };
}

static bool outdated(const struct list *list, const struct cloud *cloud, const struct check *c)
{
    return list->builds == 0 || c->back || (c->moved && !drift_harmless(list, cloud));
}

bool list_stale(const struct list *list, const struct cloud *cloud)
{
    if (list->builds == 0)
        return true;
    const struct check c = check(list, cloud);
    return c.bad < list->n || outdated(list, cloud, &c);
}

/* Before the first build everybody counts as left out. */
static void forget(struct list *list)
{
    for (int i = 0; i < list->n; i++) {
        list->slot[i] = -1;
        for (int d = 0; d < DIM; d++)
            list->own->built[(size_t)DIM * (size_t)i + (size_t)d] = INFINITY;
    }
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

int list_rebuild(struct list *list, const struct cloud *cloud, list_rows *rows)
{
    TRY(cells_sort(list, cloud));
    TRY(drift_note(list, cloud));
    make_groups(list);
    TRY(make_stores(list, threads_most()));
#pragma omp parallel if (list->listed > WORTH_BUILDING)
    {
        const long t = threads_me(), of = threads_all();

        rows(list, &list->own->store[t], (int)(list->groups * t / of),
             (int)(list->groups * (t + 1) / of));
    }
    TRY(join(list));
    list->builds++;
    return STATUS_DONE;
}

static bool finite_position(const double *x)
{
    bool good = true;

    for (int d = 0; d < DIM; d++)
        good &= isfinite(x[d]) != 0;
    return good;
}

/* Of the particles whose position is not finite, that with the smallest id, where
 * `bad` is the lowest row of them: its row is noted, its number by ids returned. */
static int note_bad(struct list *list, const struct cloud *cloud, int bad)
{
    int kind = 0, k;

    while (bad >= list->def.from[kind + 1])
        kind++;
    const int from = list->def.from[kind], *row = cloud->row[kind];
    for (k = row ? 0 : bad - from; row && finite_position(cloud->x[kind] + (size_t)row[k] * DIM);)
        k++;
    list->bad = from + (row ? row[k] : k);
    return from + k;
}

int list_update(struct list *list, const struct cloud *cloud, list_rows *rows)
{
    if (list->builds == 0)
        forget(list);
    const struct check c = check(list, cloud);

    list->bad = -1;
    if (c.bad < list->n)
        return status_fail(STATUS_FAILED, "the position of particle %d is not a number: the step "
                           "was too large, or a force is not finite",
                           note_bad(list, cloud, c.bad));
    return outdated(list, cloud, &c) ? list_rebuild(list, cloud, rows) : STATUS_DONE;
}

double list_entries(const struct list *list)
{
    return (double)list->rows_before[list->groups] * list->lanes;
}

/* Positions, order and slots; a group is of four, mostly, and has a segment or two,
 * each noted twice. Where something is periodic also what images.h says, and offsets. */
double list_bytes(double n, double slots, double entries)
{
    const double group = 2 * sizeof(int) + sizeof(int) + sizeof(long)
                       + 1.5 * (sizeof(struct list_segment) + sizeof(struct list_found));
    const double place = DIM * sizeof(double), turns = DIM * sizeof(int);
    const double images = slots > n ? n * (place + turns) + slots * place
                                          + (slots - n) * sizeof(struct image)
                                    : 0;

    return entries * sizeof(int) + n * (place + sizeof(int) + group / 4) + images
         + slots * (1 + LIST_WORDS) * sizeof(int);
}
