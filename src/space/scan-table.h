/* scan-table.h -- a part of scan.c: compares runs of candidates with two or four owners
 * at a time; what is near is looked up by the mask of the comparison. */
#ifndef SPACE_SCAN_TABLE_H
#define SPACE_SCAN_TABLE_H

#include "space/scan.h"

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

/* Appends those of the chunks that are near to what each lane has got. */
static void flush(struct scan *s)
{
    int *const *place = s->list->own->place;
    const scan_ints bound = s->bound - (scan_ints){ 0 };
    scan_places owner[LANES][LIST_WORDS];
    int *end[LANES];

    memcpy(owner, s->work.owner, sizeof owner);
    for (int l = 0; l < LANES; l++)
        end[l] = s->near[l] + s->count[l];
    for (int c = 0; c < s->work.chunks; c++) {
        const int at = s->work.slot[c];

        for (int l = 0; l < LANES; l++) {
            scan_sums r2 = (scan_sums)squares(scan_places_at(place[0] + at) - owner[l][0]);
            for (int w = 1; w < LIST_WORDS; w++) /* of one far away it may wrap */
                r2 += (scan_sums)squares(scan_places_at(place[w] + at) - owner[l][w]);
            const unsigned hits = below((scan_ints)r2, bound) & s->work.there[c][l];
            const scan_ints slots = s->work.hit[hits] + at;

            memcpy(end[l], &slots, sizeof slots);
            end[l] += bits(hits);
        }
    }
    for (int l = 0; l < LANES; l++)
        s->count[l] = (int)(end[l] - s->near[l]);
    s->work.chunks = 0;
}

/* No particle is its own neighbour: takes owners out of a run from place `from` on
 * that was collected last, in chunks from number `first` on. */
static void leave_out_owners(struct scan *s, int from, int first)
{
    for (int l = 0; l < LANES; l++) {
        const int at = s->group + l - from, c = first + at / SCAN_WIDE;

        if (at >= 0 && c < s->work.chunks)
            s->work.there[c][l] &= (unsigned char)~(1u << at % SCAN_WIDE);
    }
}

/* Collects the places from..to-1, SCAN_BLOCK chunks at a time without asking
 * whether they are all needed: a mispredicted branch costs more. */
static inline void collect(struct scan *s, int from, int to)
{
    const int first = s->work.chunks;
    const unsigned char last = (SCAN_HITS - 1) >> (-(unsigned)(to - from) % SCAN_WIDE);

    for (int at = from; at < to; at += SCAN_BLOCK * SCAN_WIDE, s->work.chunks += SCAN_BLOCK)
        for (int c = 0; c < SCAN_BLOCK; c++) {
            s->work.slot[s->work.chunks + c] = at + c * SCAN_WIDE;
            memcpy(s->work.there[s->work.chunks + c], s->work.looks, LANES);
        }
    s->work.chunks = first + (to - from + SCAN_WIDE - 1) / SCAN_WIDE;
    for (int l = 0; l < LANES; l++)
        s->work.there[s->work.chunks - 1][l] &= last;
    if (from < s->group + LANES && to > s->group)
        leave_out_owners(s, from, first);
}

/* The places from..to-1, in ascending runs. */
static inline void take_run(struct scan *s, int from, int to)
{
    enum { MOST = SCAN_CHUNKS * SCAN_WIDE };

    if (from >= to)
        return;
    if (s->work.chunks + (to - from) / SCAN_WIDE + 1 > SCAN_CHUNKS)
        flush(s);
    for (; to - from > MOST; from += MOST) {
        collect(s, from, from + MOST);
        flush(s);
    }
    collect(s, from, to);
}

/* After the last run. */
static void take_rest(struct scan *s)
{
    if (s->work.chunks > 0)
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

static void prepare(struct scan *s)
{
    s->work.chunks = 0;
    make_hits(s->work.hit);
}

/* After the lanes that look have changed. */
static void set_lanes(struct scan *s)
{
    for (int l = 0; l < LANES; l++) {
        for (int w = 0; w < LIST_WORDS; w++)
            s->work.owner[l][w] = scan_owner(s, l, w);
        s->work.looks[l] = l >= s->first && l < s->last ? SCAN_HITS - 1 : 0;
    }
}

#endif
