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

enum { WIDE = 2 * LANES, HITS = 1 << WIDE };
_Static_assert((int)WIDE <= (int)LIST_PAD, "places are read WIDE at a time");

typedef float floats __attribute__((vector_size(4 * WIDE)));
typedef int ints __attribute__((vector_size(4 * WIDE)));
typedef int quad __attribute__((vector_size(16), may_alias));

static const double WIDER = 1 + 1e-6;

struct scan {
    const ints *hit;           /* [HITS] the set bits of a mask in turn      */
    const double *const *place;
    double reach;              /* [m]                                        */
    double origin[DIM];        /* subtracted from everybody [m]              */
    float own[LANES][DIM];     /* owners, after that                         */
    int group, owners;         /* first slot, lanes in use                   */
    int *near[LANES];          /* neighbours so far                          */
    int count[LANES];
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

/* Candidates from..to-1 for lanes first..last; WIDE at most, and never oneself,
 * when among is set: the owners themselves may be among them. */
static inline void scan_slots(struct scan *s, int from, int to, int first, int last, bool among)
{
    const float bound = (float)(s->reach * s->reach);
    int *to_near[LANES];

    for (int l = first; l <= last; l++)
        to_near[l] = s->near[l] + s->count[l];
    for (int j = from; j < to; j += WIDE) {
        const unsigned valid = to - j < WIDE ? (1u << (to - j)) - 1 : HITS - 1;
        floats x[DIM];

        for (int d = 0; d < DIM; d++)
            x[d] = offsets(s->place[d] + j, s->origin[d]);
        for (int l = first; l <= last; l++) {
            floats r2 = { 0 };

            for (int d = 0; d < DIM; d++)
                r2 += (x[d] - s->own[l][d]) * (x[d] - s->own[l][d]);
            unsigned hits = below(r2, bound) & valid;
            if (among) /* bit group + l - j, which may be negative */
                hits &= ~(1u << (WIDE + s->group + l - j) >> WIDE);
            const ints slots = s->hit[hits] + j;
            memcpy(to_near[l], &slots, sizeof slots);
            to_near[l] += bits(hits);
        }
    }
    for (int l = first; l <= last; l++)
        s->count[l] = (int)(to_near[l] - s->near[l]);
}

/* A run of slots; the stretch that holds the owners themselves is apart. */
static inline void scan_run(struct scan *s, int from, int to, int first, int last)
{
    const int a = from > s->group ? from : s->group;
    const int b = a + WIDE < to ? a + WIDE : to;

    if (a >= to || a >= s->group + LANES) {
        scan_slots(s, from, to, first, last, false);
        return;
    }
    scan_slots(s, from, a, first, last, false);
    scan_slots(s, a, b, first, last, true);
    scan_slots(s, b, to, first, last, false);
}

/* Everybody in the window, in ascending slots. */
static inline void scan_window(struct scan *s, const struct cells *c, const struct cells_window *w,
                               int first, int last)
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
                scan_run(s, start[0], start[more], first, last);
        }
    }
}

/* The box of lanes first..last, widened by the reach. */
static void box_of(const struct scan *s, int first, int last, double *low, double *high)
{
    for (int d = 0; d < DIM; d++) {
        const double *x = s->place[d] + s->group;

        low[d] = high[d] = x[first];
        for (int l = first + 1; l <= last; l++) {
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

        set_origin(s, l);
        box_of(s, l, l, low, high);
        if (cells_window(c, low, high, &w))
            scan_window(s, c, &w, l, l);
    }
    set_origin(s, 0);
}

static void scan_together(struct scan *s, const struct cells *c)
{
    double low[DIM], high[DIM];
    struct cells_window w;

    box_of(s, 0, s->owners - 1, low, high);
    for (int d = 0; d < DIM; d++)
        if (high[d] - low[d] > 3 * s->reach) {
            scan_apart(s, c);
            return;
        }
    if (cells_window(c, low, high, &w))
        scan_window(s, c, &w, 0, LANES - 1);
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
    const quad rows[4] = { __builtin_shufflevector(ac, bd, 0, 4, 1, 5),
                           __builtin_shufflevector(ac, bd, 2, 6, 3, 7),
                           __builtin_shufflevector(ac2, bd2, 0, 4, 1, 5),
                           __builtin_shufflevector(ac2, bd2, 2, 6, 3, 7) };
#else
    const quad a = *(const quad *)(near[0] + k), b = *(const quad *)(near[1] + k);
    const quad rows[2] = { __builtin_shufflevector(a, b, 0, 4, 1, 5),
                           __builtin_shufflevector(a, b, 2, 6, 3, 7) };
#endif
    memcpy(to, rows, sizeof rows);
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
        for (int k = l < s->owners ? s->count[l] : 0; k < rows; k++)
            s->near[l][k] = dummy;
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
    ints hit[HITS];
    const size_t room = ((size_t)list->listed + WIDE + 3) / 4 * 4;
    struct scan s = {
        .hit = hit,
        .place = (const double *const *)list->own->place,
        .reach = (list->def.support + list->def.skin) * WIDER,
    };

    if (!list_grow((void **)&store->near, &store->near_room, LANES * room, sizeof(int))) {
        store->failed = true;
        return;
    }
    for (int l = 0; l < LANES; l++)
        s.near[l] = store->near + (size_t)l * room;
    make_hits(hit);
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
