/* rows.c -- finds the neighbours of LANES owners at a time and lays them out
 * in rows; the pair list's engine of this lane width.
 *
 * Distances are compared in single precision, WIDE candidates at a time, but
 * only after the owners' own place has been subtracted in double precision:
 * the error is 6e-7 of the radius at most, and the radius is widened by more
 * than that, so no pair is ever missed and no domain is too large. */
#include "space/lanes.h"
#include "space/list-private.h"

#include "base/status.h"

#include <stdint.h>
#include <string.h>
#if LANES == 4 || defined(__SSE2__)
#include <immintrin.h>
#endif

enum { WIDE = 2 * LANES, HITS = 1 << WIDE, CHUNKS = 128, BLOCK = 4,
       NOWHERE = CHUNKS * WIDE };
_Static_assert(BLOCK * WIDE <= (int)LIST_PAD, "places are read a block at a time");

typedef float floats __attribute__((vector_size(4 * WIDE)));
typedef int ints __attribute__((vector_size(4 * WIDE)));
typedef int quad __attribute__((vector_size(16), may_alias));

static const double WIDER = 1 + 1e-6;

/* Work on one group.  Candidates are collected in chunks of WIDE slots in turn;
 * then every owner is compared with all of them. */
struct scan {
    const double *const *place;
    double reach;              /* [m]                                        */
    int group, owners;         /* first slot, lanes in use                   */
    double origin[DIM];        /* subtracted from everybody [m]              */
    float own[LANES][DIM];     /* owners, after that                         */
    int first, last;           /* lanes that look for neighbours now         */
    int chunks;
    int self[LANES];           /* owner among the candidates, else NOWHERE   */
    int slot[CHUNKS + BLOCK];  /* first slot of each chunk                   */
    float x[DIM][(CHUNKS + BLOCK) * WIDE];
    unsigned char hits[CHUNKS + 1][LANES];
    int *near[LANES];          /* neighbours so far                          */
    int count[LANES];
    ints hit[HITS];            /* the set bits of a mask in turn             */
    ints count_up;             /* 0, 1, 2, ...                               */
};

/* Bit l of the answer: lane l is below the bound. */
static inline unsigned below(floats a, float bound)
{
#if LANES == 4
    return (unsigned)_mm256_movemask_ps((__m256)(a < bound));
#elif defined(__SSE2__)
    return (unsigned)_mm_movemask_ps((__m128)(a < bound));
#else
    unsigned mask = 0;

    for (int l = 0; l < WIDE; l++)
        mask |= (unsigned)(a[l] < bound) << l;
    return mask;
#endif
}

/* Coordinates x[0..WIDE-1] less the origin. */
static inline floats offsets(const double *x, double origin)
{
#if LANES == 4
    const __m256d o = _mm256_set1_pd(origin);
    const __m128 low = _mm256_cvtpd_ps(_mm256_sub_pd(_mm256_loadu_pd(x), o));
    const __m128 high = _mm256_cvtpd_ps(_mm256_sub_pd(_mm256_loadu_pd(x + 4), o));

    return (floats)_mm256_insertf128_ps(_mm256_castps128_ps256(low), high, 1);
#elif defined(__SSE2__)
    const __m128d o = _mm_set1_pd(origin);
    const __m128 low = _mm_cvtpd_ps(_mm_sub_pd(_mm_loadu_pd(x), o));
    const __m128 high = _mm_cvtpd_ps(_mm_sub_pd(_mm_loadu_pd(x + 2), o));

    return (floats)_mm_movelh_ps(low, high);
#else
    floats f;

    for (int l = 0; l < WIDE; l++)
        f[l] = (float)(x[l] - origin);
    return f;
#endif
}

static inline int bits(unsigned mask)
{
#ifdef __POPCNT__
    return __builtin_popcount(mask);
#else
    static const unsigned char of[16] = { 0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4 };

    return of[mask & 15] + of[mask >> 4];
#endif
}

static inline floats floats_at(const float *x)
{
    floats f;

    memcpy(&f, x, sizeof f);
    return f;
}

/* Compares all lanes with all chunks: hits; an owner does not hit himself. */
static inline void compare(struct scan *s)
{
    const float bound = (float)(s->reach * s->reach);

    for (int c = 0; c < s->chunks; c++) {
        floats x[DIM];

        for (int d = 0; d < DIM; d++)
            x[d] = floats_at(s->x[d] + c * WIDE);
        for (int l = 0; l < LANES; l++) {
            floats r2 = { 0 };

            for (int d = 0; d < DIM; d++)
                r2 += (x[d] - s->own[l][d]) * (x[d] - s->own[l][d]);
            s->hits[c][l] = (unsigned char)below(r2, bound);
        }
    }
    for (int l = 0; l < LANES; l++)
        s->hits[s->self[l] / WIDE][l] &= (unsigned char)~(1u << s->self[l] % WIDE);
}

/* Appends what lanes first..last hit to their neighbours. */
static inline void compress(struct scan *s, int first, int last)
{
    int *to[LANES];

    for (int l = first; l <= last; l++)
        to[l] = s->near[l] + s->count[l];
    for (int c = 0; c < s->chunks; c++)
        for (int l = first; l <= last; l++) {
            const unsigned hits = s->hits[c][l];
            const ints slots = s->hit[hits] + s->slot[c];

            memcpy(to[l], &slots, sizeof slots);
            to[l] += bits(hits);
        }
    for (int l = first; l <= last; l++)
        s->count[l] = (int)(to[l] - s->near[l]);
}

/* Done with the candidates collected so far. */
static void flush(struct scan *s)
{
    compare(s);
    if (s->first == 0 && s->last == LANES - 1)
        compress(s, 0, LANES - 1);
    else
        compress(s, s->first, s->last);
    for (int l = 0; l < LANES; l++)
        s->self[l] = NOWHERE;
    s->chunks = 0;
}

/* Collects a run of at most CHUNKS * WIDE slots, BLOCK chunks at a time without
 * asking whether they are all needed: a mispredicted branch costs more.  What
 * the last chunk has too many of is made NaN, which is near nobody. */
static inline void collect(struct scan *s, int from, int to)
{
    const int base = s->chunks * WIDE, n = to - from;

    for (int k = 0; k < n; k += BLOCK * WIDE)
        for (int c = 0; c < BLOCK; c++) {
            const int at = k + c * WIDE;
            const ints surplus = s->count_up >= n - at;

            s->slot[s->chunks + k / WIDE + c] = from + at;
            for (int d = 0; d < DIM; d++) {
                const floats x = offsets(s->place[d] + from + at, s->origin[d]);
                const ints or_nan = (ints)x | surplus;
                memcpy(s->x[d] + base + at, &or_nan, sizeof or_nan);
            }
        }
    s->chunks += (n + WIDE - 1) / WIDE;
    if (from >= s->group + LANES || to <= s->group)
        return;
    for (int l = 0; l < LANES; l++)
        if (s->group + l >= from && s->group + l < to)
            s->self[l] = base + s->group + l - from;
}

static inline void scan_run(struct scan *s, int from, int to)
{
    for (; to - from > CHUNKS * WIDE; from += CHUNKS * WIDE) {
        flush(s);
        collect(s, from, from + CHUNKS * WIDE);
    }
    if (s->chunks + (to - from + WIDE - 1) / WIDE > CHUNKS)
        flush(s);
    collect(s, from, to);
}

/* Everybody in the window, in ascending slots. */
static void scan_window(struct scan *s, const struct cells *c, const struct cells_window *w)
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

            if (start[0] < start[more])
                scan_run(s, start[0], start[more]);
        }
    }
    if (s->chunks > 0)
        flush(s);
}

/* The box of the lanes that look, widened by the reach. */
static void box_of(const struct scan *s, double *low, double *high)
{
    for (int d = 0; d < DIM; d++) {
        const double *x = s->place[d] + s->group;

        low[d] = high[d] = x[s->first];
        for (int l = s->first + 1; l <= s->last; l++) {
            low[d] = x[l] < low[d] ? x[l] : low[d];
            high[d] = x[l] > high[d] ? x[l] : high[d];
        }
        low[d] -= s->reach;
        high[d] += s->reach;
    }
}

static void set_origin(struct scan *s, int lane)
{
    for (int d = 0; d < DIM; d++) {
        const double *x = s->place[d] + s->group;

        s->origin[d] = x[lane];
        for (int l = 0; l < LANES; l++)
            s->own[l][d] = (float)(x[l < s->owners ? l : lane] - x[lane]);
    }
}

/* Owners so far apart that their common box holds too many: one by one. */
static void scan_apart(struct scan *s, const struct cells *c)
{
    for (int l = 0; l < s->owners; l++) {
        double low[DIM], high[DIM];
        struct cells_window w;

        s->first = s->last = l;
        set_origin(s, l);
        box_of(s, low, high);
        if (cells_window(c, low, high, &w))
            scan_window(s, c, &w);
    }
    set_origin(s, 0);
}

static void scan_together(struct scan *s, const struct cells *c)
{
    double low[DIM], high[DIM];
    struct cells_window w;

    s->first = 0;
    s->last = s->owners - 1;
    box_of(s, low, high);
    for (int d = 0; d < DIM; d++)
        if (high[d] - low[d] > 3 * s->reach) {
            scan_apart(s, c);
            return;
        }
    if (cells_window(c, low, high, &w))
        scan_window(s, c, &w);
}

static inline void store(int *to, quad four)
{
    memcpy(to, &four, sizeof four);
}

/* Four neighbours of each lane to four rows. */
static inline void transpose(int *const near[LANES], int k, int *to)
{
#if LANES == 4
    const quad a = *(const quad *)(near[0] + k), b = *(const quad *)(near[1] + k);
    const quad c = *(const quad *)(near[2] + k), d = *(const quad *)(near[3] + k);
    const quad ac = __builtin_shufflevector(a, c, 0, 4, 1, 5);
    const quad bd = __builtin_shufflevector(b, d, 0, 4, 1, 5);
    const quad ac2 = __builtin_shufflevector(a, c, 2, 6, 3, 7);
    const quad bd2 = __builtin_shufflevector(b, d, 2, 6, 3, 7);

    store(to, __builtin_shufflevector(ac, bd, 0, 4, 1, 5));
    store(to + 4, __builtin_shufflevector(ac, bd, 2, 6, 3, 7));
    store(to + 8, __builtin_shufflevector(ac2, bd2, 0, 4, 1, 5));
    store(to + 12, __builtin_shufflevector(ac2, bd2, 2, 6, 3, 7));
#else
    const quad a = *(const quad *)(near[0] + k), b = *(const quad *)(near[1] + k);

    store(to, __builtin_shufflevector(a, b, 0, 4, 1, 5));
    store(to + 4, __builtin_shufflevector(a, b, 2, 6, 3, 7));
#endif
}

/* Pads a lane's n neighbours to the longest; WIDE at a time, so that the usual
 * case has no loop to mispredict. */
static inline void pad(int *near, int n, int rows, int dummy)
{
    const ints dummies = (ints){ 0 } + dummy;

    do {
        memcpy(near + n, &dummies, sizeof dummies);
        n += WIDE;
    } while (n < rows);
}

/* Pads the lanes to the longest and appends the rows. */
static int append(struct list_store *store, struct scan *s, int partner, int dummy)
{
    int rows = 0;

    for (int l = 0; l < s->owners; l++)
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
        pad(s->near[l], l < s->owners ? s->count[l] : 0, rows, dummy);
    for (int k = 0; k < rows; k += 4)
        transpose(s->near, k, store->j + store->used + (size_t)k * LANES);
    store->found[store->founds++] = (struct list_found){ partner, rows, store->used };
    store->used += (size_t)rows * LANES;
    return rows;
}

static void find_rows(struct list *list, struct list_store *store, struct scan *s, int g)
{
    struct list_private *own = list->own;
    const int kind = list->group_kind[g];
    const int left = list->start[kind + 1] - list->group_slot[g];
    const size_t before = store->founds;
    long rows = 0;

    s->group = list->group_slot[g];
    s->owners = left < LANES ? left : LANES;
    set_origin(s, 0);
    for (int partner = 0; partner < KINDS; partner++) {
        if (!(list->def.acts[kind] & KIND_BIT(partner)))
            continue;
        memset(s->count, 0, sizeof s->count);
        scan_together(s, &own->cells[partner]);
        rows += append(store, s, partner, list->listed);
    }
    own->segment_from[g + 1] = (int)(store->founds - before);
    own->rows_before[g + 1] = rows;
}

/* Positions of the set bits of every mask, for compressing by table. */
static void make_hits(ints *hit)
{
    for (int mask = 0; mask < HITS; mask++) {
        int n = 0;

        hit[mask] = (ints){ 0 };
        for (int bit = 0; bit < WIDE; bit++)
            if (mask >> bit & 1)
                hit[mask][n++] = bit;
    }
}

/* Rows of the groups from..to-1. */
static void find_all(struct list *list, struct list_store *store, int from, int to)
{
    const size_t room = ((size_t)list->listed + 2 * WIDE + 3) / 4 * 4;
    struct scan s;

    if (!list_grow((void **)&store->near, &store->near_room, LANES * room, sizeof(int))) {
        store->failed = true;
        return;
    }
    s.place = (const double *const *)list->own->place;
    s.reach = (list->def.support + list->def.skin) * WIDER;
    s.chunks = 0;
    memset(s.x, 0, sizeof s.x);
    for (int l = 0; l < LANES; l++) {
        s.near[l] = store->near + (size_t)l * room;
        s.self[l] = NOWHERE;
    }
    make_hits(s.hit);
    s.count_up = s.hit[HITS - 1];
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

const struct list_engine LANE_NAME(list_engine) = {
    .lanes = LANES, .create = create, .free = list_free, .update = update, .stale = list_stale,
};
