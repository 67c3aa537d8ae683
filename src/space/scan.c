/* scan.c -- finds neighbours by comparing with all who are in the cells around.
 *
 * Places are whole numbers of 16 bits, so that one instruction squares and adds
 * two differences of each of SCAN_WIDE candidates.  They count modulo 8 radii:
 * those in the cells around are nearer than 4, and where cells had to be coarse
 * somebody far away may be listed, which changes no sum.  The radius is widened
 * by more than all roundings together, so no pair is ever missed. */
#include "space/scan.h"

#include <float.h>
#include <limits.h>
#include <string.h>
#if LANES > 2 || defined(__SSE2__)
#include <immintrin.h>
#endif

/* a[2i]^2 + a[2i+1]^2 */
static inline scan_ints squares(scan_places a)
{
#if LANES > 2
    return (scan_ints)_mm256_madd_epi16((__m256i)a, (__m256i)a);
#elif defined(__SSE2__)
    return (scan_ints)_mm_madd_epi16((__m128i)a, (__m128i)a);
#else
    scan_ints sum;

    for (int i = 0; i < SCAN_WIDE; i++) { /* differences wrap, and have signs */
        const int u = (short)a[2 * i], v = (short)a[2 * i + 1];
        sum[i] = (int)((unsigned)(u * u) + (unsigned)(v * v));
    }
    return sum;
#endif
}

/* Bit i of the answer: a[i] < bound. */
static inline unsigned below(scan_ints a, scan_ints bound)
{
#if LANES > 2
    return (unsigned)_mm256_movemask_ps((__m256)(a < bound));
#elif defined(__SSE2__)
    return (unsigned)_mm_movemask_ps((__m128)(a < bound));
#else
    unsigned mask = 0;

    for (int i = 0; i < SCAN_WIDE; i++)
        mask |= (unsigned)(a[i] < bound[i]) << i;
    return mask;
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

static inline scan_places places_at(const int *place)
{
    scan_places p;

    memcpy(&p, place, sizeof p);
    return p;
}

/* Appends those of the chunks that are near to what each lane has got. */
static void flush(struct scan *s)
{
    int *const *place = s->list->own->place;
    const scan_ints bound = s->bound - (scan_ints){ 0 };
    scan_places owner[SCAN_OWNERS][LIST_WORDS];
    int *end[SCAN_OWNERS];

    memcpy(owner, s->owner, sizeof owner);
    for (int l = 0; l < SCAN_OWNERS; l++)
        end[l] = s->near[l] + s->count[l];
    for (int c = 0; c < s->chunks; c++) {
        const int at = s->slot[c];

        for (int l = 0; l < SCAN_OWNERS; l++) {
            scan_sums r2 = (scan_sums)squares(places_at(place[0] + at) - owner[l][0]);
            for (int w = 1; w < LIST_WORDS; w++) /* of somebody far away it may wrap */
                r2 += (scan_sums)squares(places_at(place[w] + at) - owner[l][w]);
            const unsigned hits = below((scan_ints)r2, bound) & s->there[c][l];
            const scan_ints slots = s->hit[hits] + at;

            memcpy(end[l], &slots, sizeof slots);
            end[l] += bits(hits);
        }
    }
    for (int l = 0; l < SCAN_OWNERS; l++)
        s->count[l] = (int)(end[l] - s->near[l]);
    s->chunks = 0;
}

/* Nobody is his own neighbour: takes owners out of a run from slot `from` on
 * that was collected last, in chunks from number `first` on. */
static void leave_out_owners(struct scan *s, int from, int first)
{
    for (int l = 0; l < SCAN_OWNERS; l++) {
        const int at = s->group + l - from, c = first + at / SCAN_WIDE;

        if (at >= 0 && c < s->chunks)
            s->there[c][l] &= (unsigned char)~(1u << at % SCAN_WIDE);
    }
}

/* Collects the slots from..to-1, SCAN_BLOCK chunks at a time without asking
 * whether they are all needed: a mispredicted branch costs more. */
static inline void collect(struct scan *s, int from, int to)
{
    const int first = s->chunks;
    const unsigned char last = (SCAN_HITS - 1) >> (-(unsigned)(to - from) % SCAN_WIDE);

    for (int at = from; at < to; at += SCAN_BLOCK * SCAN_WIDE, s->chunks += SCAN_BLOCK)
        for (int c = 0; c < SCAN_BLOCK; c++) {
            s->slot[s->chunks + c] = at + c * SCAN_WIDE;
            memcpy(s->there[s->chunks + c], s->looks, SCAN_OWNERS);
        }
    s->chunks = first + (to - from + SCAN_WIDE - 1) / SCAN_WIDE;
    for (int l = 0; l < SCAN_OWNERS; l++)
        s->there[s->chunks - 1][l] &= last;
    if (from < s->group + SCAN_OWNERS && to > s->group)
        leave_out_owners(s, from, first);
}

/* Collects a run of any length. */
static inline void collect_run(struct scan *s, int from, int to)
{
    enum { MOST = SCAN_CHUNKS * SCAN_WIDE };

    if (s->chunks + (to - from) / SCAN_WIDE + 1 > SCAN_CHUNKS)
        flush(s);
    for (; to - from > MOST; from += MOST) {
        collect(s, from, from + MOST);
        flush(s);
    }
    collect(s, from, to);
}

/* Everybody in the window, in ascending slots. */
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

            if (start[0] < start[more])
                collect_run(s, start[0], start[more]);
        }
    }
    if (s->chunks > 0)
        flush(s);
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

/* Places are whole, so a distance is off by 2 sqrt(3) units at most; products of
 * coordinates are rounded. */
void scan_start(struct scan *s, const struct list *list, int *near, size_t room)
{
    const double radius = list->def.support + list->def.skin;
    const double wide = LIST_UNITS * (1 + 4 * DBL_EPSILON * list->own->farthest / radius) + 4;

    s->list = list;
    s->chunks = 0;
    s->reach = radius * wide / LIST_UNITS;
    s->bound = wide * wide < INT_MAX ? (int)(wide * wide) : INT_MAX;
    for (int l = 0; l < SCAN_OWNERS; l++)
        s->near[l] = near + (size_t)l * room;
    make_hits(s->hit);
}

static const double *position(const struct scan *s, int lane)
{
    return s->list->own->stand + (size_t)DIM * (size_t)s->list->order[s->group + lane];
}

/* From now on lanes from..to-1 look for neighbours. */
static void let_look(struct scan *s, int from, int to)
{
    for (int l = 0; l < SCAN_OWNERS; l++)
        s->looks[l] = l >= from && l < to ? SCAN_HITS - 1 : 0;
}

/* The box of lanes from..to-1, widened by the reach. */
static void set_box(struct scan *s, int from, int to)
{
    for (int d = 0; d < DIM; d++) {
        double low = position(s, from)[d], high = low;

        for (int l = from + 1; l < to; l++) {
            const double x = position(s, l)[d];

            low = x < low ? x : low;
            high = x > high ? x : high;
        }
        s->low[d] = low - s->reach;
        s->high[d] = high + s->reach;
    }
}

static void set_owners(struct scan *s)
{
    for (int l = 0; l < SCAN_OWNERS; l++)
        for (int w = 0; w < LIST_WORDS; w++)
            s->owner[l][w] = (scan_places)(s->list->own->place[w][s->group + l] - (scan_ints){ 0 });
}

void scan_group(struct scan *s, int group, int owners)
{
    s->group = group;
    s->owners = owners;
    if (owners == 0)
        return;
    set_owners(s);
    let_look(s, 0, owners);
    set_box(s, 0, owners);
    s->apart = false;
    for (int d = 0; d < DIM; d++)
        s->apart |= s->high[d] - s->low[d] > 3 * s->reach;
}

static void take_box(struct scan *s, const struct cells *c)
{
    struct cells_window w;

    if (cells_window(c, s->low, s->high, &w))
        take_window(s, c, &w);
}

/* Owners so far apart that their common box holds too many: one by one. */
static void take_apart(struct scan *s, const struct cells *c)
{
    for (int l = 0; l < s->owners; l++) {
        let_look(s, l, l + 1);
        set_box(s, l, l + 1);
        take_box(s, c);
    }
    let_look(s, 0, s->owners);
}

void scan_near(struct scan *s, const struct cells *c, const struct cells *images)
{
    memset(s->count, 0, sizeof s->count);
    if (s->owners == 0)
        return;
    for (; c; c = c == images ? NULL : images)
        if (s->apart)
            take_apart(s, c);
        else
            take_box(s, c);
}
