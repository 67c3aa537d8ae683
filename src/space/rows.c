/* rows.c -- lays the neighbours of LANES owners out in rows; the pair list's
 * engine of this lane width. */
#include "space/scan.h"

#include "base/status.h"

#include <string.h>

/* So many entries ahead of those written are fetched, as stores wait for their lines. */
enum { AHEAD = 512, LINE = 64 / sizeof(int) };

typedef int quad __attribute__((vector_size(16), may_alias));

static inline quad four(const int *near)
{
    return *(const quad *)near;
}

/* Four neighbours of each lane to four rows, as entries; behind the last neighbour stands anything,
 * which may not overflow. */
#if LANES > 2
typedef int row __attribute__((vector_size(4 * LANES)));
typedef unsigned row_entries __attribute__((vector_size(4 * LANES)));

static inline void store(int *to, row neighbours)
{
    const row_entries entries = (row_entries)neighbours * (unsigned)LIST_STEP;

    memcpy(to, &entries, sizeof entries);
}

#if LANES == 8
/* Lanes l and l + 4 side by side. */
static inline row part(int *const near[LANES], int l, int k)
{
    return __builtin_shufflevector(four(near[l] + k), four(near[l + 4] + k), 0, 1, 2, 3, 4, 5,
                                   6, 7);
}

/* First and second, third and fourth of each four of a and b in turn. */
static inline row first(row a, row b)
{
    return __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
}

static inline row second(row a, row b)
{
    return __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
}
#else
static inline row part(int *const near[LANES], int l, int k)
{
    return four(near[l] + k);
}

static inline row first(row a, row b)
{
    return __builtin_shufflevector(a, b, 0, 4, 1, 5);
}

static inline row second(row a, row b)
{
    return __builtin_shufflevector(a, b, 2, 6, 3, 7);
}
#endif

static inline void transpose(int *const near[LANES], int k, int *to)
{
    const row a = part(near, 0, k), b = part(near, 1, k);
    const row c = part(near, 2, k), d = part(near, 3, k);

    store(to, first(first(a, c), first(b, d)));
    store(to + LANES, second(first(a, c), first(b, d)));
    store(to + 2 * LANES, first(second(a, c), second(b, d)));
    store(to + 3 * LANES, second(second(a, c), second(b, d)));
}
#else
typedef unsigned quad_entries __attribute__((vector_size(16)));

static inline void transpose(int *const near[LANES], int k, int *to)
{
    const quad a = four(near[0] + k), b = four(near[1] + k);
    const quad_entries low
        = (quad_entries)__builtin_shufflevector(a, b, 0, 4, 1, 5) * (unsigned)LIST_STEP;
    const quad_entries high
        = (quad_entries)__builtin_shufflevector(a, b, 2, 6, 3, 7) * (unsigned)LIST_STEP;

    memcpy(to, &low, sizeof low);
    memcpy(to + 4, &high, sizeof high);
}
#endif

/* Pads a lane's n neighbours to the longest; SCAN_WIDE at a time, so that the usual
 * case has no loop to mispredict. */
static inline void pad(int *near, int n, int rows, int dummy)
{
    const scan_ints dummies = (scan_ints){ 0 } + dummy;

    do {
        memcpy(near + n, &dummies, sizeof dummies);
        n += SCAN_WIDE;
    } while (n < rows);
}

/* Pads the lanes to the longest and appends the rows. */
static int append(struct list_store *store, const struct scan *s, int partner, int dummy)
{
    int rows = 0;

    for (int l = 0; l < LANES; l++)
        rows = s->count[l] > rows ? s->count[l] : rows;
    if (rows == 0)
        return 0;
    const size_t want = store->used + (size_t)(rows + 4) * LANES;
    if (!list_grow((void **)&store->j, &store->room, want, sizeof *store->j)
        || !list_grow((void **)&store->found, &store->found_room, store->founds + 1,
                      sizeof *store->found)) {
        store->failed = true;
        return 0;
    }
    for (int l = 0; l < LANES; l++)
        pad(s->near[l], s->count[l], rows, dummy);
    for (int k = 0; k < rows; k += 4) {
        int *to = store->j + store->used + (size_t)k * LANES;

        for (int i = 0; i < 4 * LANES; i += LINE)
            __builtin_prefetch(to + AHEAD + i, 1);
        transpose(s->near, k, to);
    }
    store->found[store->founds++] = (struct list_found){ partner, rows, store->used };
    store->used += (size_t)rows * LANES;
    return rows;
}

/* Owners of other ranks look for nobody. */
static void keep_mine(const struct list *list, int first, int owners, int count[LANES])
{
    for (int l = 0; l < owners; l++)
        if (!list->mine[list->order[first + l]])
            count[l] = 0;
}

static void find_rows(struct list *list, struct list_store *store, struct scan *s, int g)
{
    struct list_private *own = list->own;
    const int kind = list->group_kind[g];
    const int left = list->start[kind + 1] - list->group_slot[g];
    const size_t before = store->founds;
    long rows = 0;

    scan_group(s, list->group_slot[g], left < LANES ? left : LANES);
    for (int partner = 0; partner < KINDS; partner++) {
        if (!(list->def.acts[kind] & KIND_BIT(partner))
            || list->start[partner] == list->start[partner + 1])
            continue;
        scan_near(s, partner);
        if (list->mine)
            keep_mine(list, s->group, s->owners, s->count);
        rows += append(store, s, partner, list->listed);
    }
    own->segment_from[g + 1] = (int)(store->founds - before);
    own->rows_before[g + 1] = rows;
}

/* Rows of the groups from..to-1. */
static void find_all(struct list *list, struct list_store *store, int from, int to)
{
    const size_t room = ((size_t)list->listed + 2 * SCAN_WIDE + 3) / 4 * 4;
    struct scan s;

    if (!list_grow((void **)&store->near, &store->near_room, LANES * room, sizeof(int))) {
        store->failed = true;
        return;
    }
    scan_start(&s, list, store->near, room);
    for (int g = from; g < to && !store->failed; g++)
        find_rows(list, store, &s, g);
}

static int create(struct list **list, const struct list_def *def)
{
    return list_create(list, def, LANES);
}

static int update(struct list *list, const struct cloud *cloud)
{
    return list_update(list, cloud, find_all);
}

static int make(struct list *list, const struct cloud *cloud)
{
    list->bad = -1;
    return list_rebuild(list, cloud, find_all);
}

static int rearrange(struct list *list, const int *const from[KINDS],
                     const int *const rows[KINDS])
{
    return list_rearrange(list, from, rows, find_all);
}

const struct list_engine LANE_NAME(list_engine) = {
    .lanes = LANES, .create = create, .free = list_free, .update = update, .make = make,
    .stale = list_stale, .rearrange = rearrange,
};
