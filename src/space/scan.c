/* scan.c -- finds neighbours by comparing with all who are in the cells around.
 *
 * Distances are compared in single precision, SCAN_WIDE candidates at a time,
 * but only after the owners' own place has been subtracted in double precision:
 * the error is 6e-7 of the radius at most, and the radius is widened by more
 * than that, so no pair is ever missed and no domain is too large. */
#include "space/scan.h"

#include <string.h>
#if LANES == 4 || defined(__SSE2__)
#include <immintrin.h>
#endif

static const double WIDER = 1 + 1e-6;

/* Bit l of the answer: lane l is below the bound. */
static inline unsigned below(scan_floats a, float bound)
{
#if LANES == 4
    return (unsigned)_mm256_movemask_ps((__m256)(a < bound));
#elif defined(__SSE2__)
    return (unsigned)_mm_movemask_ps((__m128)(a < bound));
#else
    unsigned mask = 0;

    for (int l = 0; l < SCAN_WIDE; l++)
        mask |= (unsigned)(a[l] < bound) << l;
    return mask;
#endif
}

/* Coordinates x[0..SCAN_WIDE-1] less the origin. */
static inline scan_floats offsets(const double *x, double origin)
{
#if LANES == 4
    const __m256d o = _mm256_set1_pd(origin);
    const __m128 low = _mm256_cvtpd_ps(_mm256_sub_pd(_mm256_loadu_pd(x), o));
    const __m128 high = _mm256_cvtpd_ps(_mm256_sub_pd(_mm256_loadu_pd(x + 4), o));

    return (scan_floats)_mm256_insertf128_ps(_mm256_castps128_ps256(low), high, 1);
#elif defined(__SSE2__)
    const __m128d o = _mm_set1_pd(origin);
    const __m128 low = _mm_cvtpd_ps(_mm_sub_pd(_mm_loadu_pd(x), o));
    const __m128 high = _mm_cvtpd_ps(_mm_sub_pd(_mm_loadu_pd(x + 2), o));

    return (scan_floats)_mm_movelh_ps(low, high);
#else
    scan_floats f;

    for (int l = 0; l < SCAN_WIDE; l++)
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

    return of[mask & 15] + (SCAN_WIDE > 4 ? of[mask >> 4] : 0);
#endif
}

static inline scan_floats floats_at(const float *x)
{
    scan_floats f;

    memcpy(&f, x, sizeof f);
    return f;
}

/* Compares all lanes with all chunks: hits; an owner does not hit himself. */
static inline void compare(struct scan *s)
{
    const float bound = (float)(s->reach * s->reach);

    for (int c = 0; c < s->chunks; c++) {
        scan_floats x[DIM];

        for (int d = 0; d < DIM; d++)
            x[d] = floats_at(s->x[d] + c * SCAN_WIDE);
        for (int l = 0; l < LANES; l++) {
            scan_floats r2 = { 0 };

            for (int d = 0; d < DIM; d++)
                r2 += (x[d] - s->own[l][d]) * (x[d] - s->own[l][d]);
            s->hits[c][l] = (unsigned char)below(r2, bound);
        }
    }
    for (int l = 0; l < LANES; l++)
        s->hits[s->self[l] / SCAN_WIDE][l] &= (unsigned char)~(1u << s->self[l] % SCAN_WIDE);
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
            const scan_ints slots = s->hit[hits] + s->slot[c];

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
        s->self[l] = SCAN_NOWHERE;
    s->chunks = 0;
}

/* Collects a run of at most SCAN_CHUNKS chunks, SCAN_BLOCK at a time without
 * asking whether they are all needed: a mispredicted branch costs more.  What
 * the last chunk has too many of is made NaN, which is near nobody. */
static inline void collect_slots(struct scan *s, int from, int to)
{
    const int base = s->chunks * SCAN_WIDE, n = to - from;

    for (int k = 0; k < n; k += SCAN_BLOCK * SCAN_WIDE)
        for (int c = 0; c < SCAN_BLOCK; c++) {
            const int at = k + c * SCAN_WIDE;
            const scan_ints surplus = s->count_up >= n - at;

            s->slot[s->chunks + k / SCAN_WIDE + c] = from + at;
            for (int d = 0; d < DIM; d++) {
                const scan_floats x = offsets(s->place[d] + from + at, s->origin[d]);
                const scan_ints or_nan = (scan_ints)x | surplus;
                memcpy(s->x[d] + base + at, &or_nan, sizeof or_nan);
            }
        }
    s->chunks += (n + SCAN_WIDE - 1) / SCAN_WIDE;
    if (from >= s->group + LANES || to <= s->group)
        return;
    for (int l = 0; l < LANES; l++)
        if (s->group + l >= from && s->group + l < to)
            s->self[l] = base + s->group + l - from;
}

/* A run of any length. */
static inline void collect_run(struct scan *s, int from, int to)
{
    for (; to - from > SCAN_CHUNKS * SCAN_WIDE; from += SCAN_CHUNKS * SCAN_WIDE) {
        flush(s);
        collect_slots(s, from, from + SCAN_CHUNKS * SCAN_WIDE);
    }
    if (s->chunks + (to - from + SCAN_WIDE - 1) / SCAN_WIDE > SCAN_CHUNKS)
        flush(s);
    collect_slots(s, from, to);
}

/* Everybody in the window, in ascending slots. */
static void collect_window(struct scan *s, const struct cells *c, const struct cells_window *w)
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
                collect_run(s, start[0], start[more]);
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

/* The origin is at one owner; unused lanes stand there too. */
static void set_origin(struct scan *s, int lane)
{
    for (int d = 0; d < DIM; d++) {
        const double *x = s->place[d] + s->group;

        s->origin[d] = x[lane];
        for (int l = 0; l < LANES; l++)
            s->own[l][d] = (float)(x[l < s->owners ? l : lane] - x[lane]);
    }
}

/* Positions of the set bits of every mask, for compressing by table. */
static void make_hits(scan_ints *hit)
{
    for (int mask = 0; mask < SCAN_HITS; mask++) {
        int n = 0;

        hit[mask] = (scan_ints){ 0 };
        for (int bit = 0; bit < SCAN_WIDE; bit++)
            if (mask >> bit & 1)
                hit[mask][n++] = bit;
    }
}

void scan_start(struct scan *s, const struct list *list, int *near, size_t room)
{
    s->place = (const double *const *)list->own->place;
    s->reach = (list->def.support + list->def.skin) * WIDER;
    s->chunks = 0;
    memset(s->x, 0, sizeof s->x);
    for (int l = 0; l < LANES; l++) {
        s->near[l] = near + (size_t)l * room;
        s->self[l] = SCAN_NOWHERE;
    }
    make_hits(s->hit);
    s->count_up = s->hit[SCAN_HITS - 1];
}

void scan_group(struct scan *s, int group, int owners)
{
    s->group = group;
    s->owners = owners;
    set_origin(s, 0);
}

/* Owners so far apart that their common box holds too many: one by one. */
static void near_apart(struct scan *s, const struct cells *c)
{
    for (int l = 0; l < s->owners; l++) {
        double low[DIM], high[DIM];
        struct cells_window w;

        s->first = s->last = l;
        set_origin(s, l);
        box_of(s, low, high);
        if (cells_window(c, low, high, &w))
            collect_window(s, c, &w);
    }
    set_origin(s, 0);
}

void scan_near(struct scan *s, const struct cells *c)
{
    double low[DIM], high[DIM];
    struct cells_window w;

    memset(s->count, 0, sizeof s->count);
    s->first = 0;
    s->last = s->owners - 1;
    box_of(s, low, high);
    for (int d = 0; d < DIM; d++)
        if (high[d] - low[d] > 3 * s->reach) {
            near_apart(s, c);
            return;
        }
    if (cells_window(c, low, high, &w))
        collect_window(s, c, &w);
}
