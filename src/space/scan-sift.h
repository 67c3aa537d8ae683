/* scan-sift.h -- a part of scan.c: sifts what is near the owners' box out of all
 * candidates, and compares the rest with one owner after the other. */
#ifndef SPACE_SCAN_SIFT_H
#define SPACE_SCAN_SIFT_H

#include "space/scan.h"

#include <immintrin.h>

/* What candidates are compared with before all others: the box around the owners. */
struct sieve {
    int *const *places;                               /* of all places       */
    scan_places centre[LIST_WORDS], half[LIST_WORDS]; /* of the box; half its size */
    scan_ints bound;                                  /* see scan.h          */
};

/* a[2i]^2 + a[2i+1]^2 */
static inline scan_ints squares(scan_places a)
{
    return (scan_ints)_mm512_madd_epi16((__m512i)a, (__m512i)a);
}

/* Bit i of the answer: a[i] < bound. */
static inline __mmask16 below(scan_sums a, scan_ints bound)
{
    return _mm512_cmplt_epi32_mask((__m512i)a, (__m512i)bound);
}

/* Appends the numbers of bits that are set. */
static inline void keep(int *to, scan_ints numbers, __mmask16 hits)
{
    const __m512i kept = _mm512_maskz_compress_epi32(hits, (__m512i)numbers);

    memcpy(to, &kept, sizeof kept);
}

/* Appends those of the first n that were sifted and are near an owner to its neighbours;
 * none is its own. */
static void compare(struct scan *s, int lane, int n)
{
    const struct scan_work *of = &s->work;
    const scan_ints bound = s->bound - (scan_ints){ 0 };
    const scan_ints self = s->group + lane - (scan_ints){ 0 };
    int *end = s->near[lane] + s->count[lane];
    scan_places owner[LIST_WORDS];

    for (int w = 0; w < LIST_WORDS; w++)
        owner[w] = scan_owner(s, lane, w);
    for (int at = 0; at < n; at += SCAN_WIDE) {
        const scan_ints slot = (scan_ints)scan_places_at(of->slot + at);
        scan_sums r2 = { 0 };

        for (int w = 0; w < LIST_WORDS; w++) /* of one far away it may wrap */
            r2 += (scan_sums)squares(scan_places_at(of->place[w] + at) - owner[w]);
        const __mmask16 hits = _mm512_mask_cmpneq_epi32_mask(below(r2, bound), (__m512i)slot,
                                                             (__m512i)self);
        keep(end, slot, hits);
        end += __builtin_popcount(hits);
    }
    s->count[lane] = (int)(end - s->near[lane]);
}

/* Registers are filled up with one far away: after the last of n. */
static void compare_all(struct scan *s, const struct sieve *sieve, int n)
{
    const scan_places far = sieve->centre[0] ^ (scan_places)((1 << 15) - (scan_ints){ 0 });

    memcpy(s->work.place[0] + n, &far, sizeof far);
    for (int w = 1; w < LIST_WORDS; w++)
        memcpy(s->work.place[w] + n, &sieve->centre[w], sizeof far);
    for (int l = s->first; l < s->last; l++)
        compare(s, l, n);
}

/* How far places are from the box, coordinate by coordinate. */
static inline scan_places outside(scan_places place, scan_places centre, scan_places half)
{
    return (scan_places)_mm512_subs_epu16(_mm512_abs_epi16((__m512i)(place - centre)),
                                          (__m512i)half);
}

static const scan_ints counting = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15 };

/* Of SCAN_WIDE places from `at` on, but before `end`, those near the box become
 * number n and following; returns the next n. */
static inline int sift(struct scan_work *to, const struct sieve *sieve, int at, int end, int n)
{
    scan_places place[LIST_WORDS];
    scan_sums r2 = { 0 };

    for (int w = 0; w < LIST_WORDS; w++) {
        place[w] = scan_places_at(sieve->places[w] + at);
        r2 += (scan_sums)squares(outside(place[w], sieve->centre[w], sieve->half[w]));
    }
    const __mmask16 hits = _mm512_mask_cmplt_epi32_mask(below(r2, sieve->bound), (__m512i)counting,
                                                        (__m512i)(end - at - (scan_ints){ 0 }));
    const __m512i hit = _mm512_maskz_compress_epi32(hits, (__m512i)counting);
    const scan_ints slot = (scan_ints)hit + at;

    memcpy(to->slot + n, &slot, sizeof slot);
    for (int w = 0; w < LIST_WORDS; w++) {
        const __m512i sifted = _mm512_permutexvar_epi32(hit, (__m512i)place[w]);
        memcpy(to->place[w] + n, &sifted, sizeof sifted);
    }
    return n + __builtin_popcount(hits);
}

/* In units; a word has two coordinates, or one if no more are left. */
static scan_places word(const double *x, int left)
{
    const unsigned low = (unsigned)(long long)x[0];
    const unsigned high = left > 1 ? (unsigned)(long long)x[1] : 0;

    return (scan_places)((int)(high << 16 | (low & 0xffff)) - (scan_ints){ 0 });
}

/* A little wider than the box, by what places are rounded. */
static struct sieve sieve_of(const struct scan *s)
{
    const double unit = s->list->own->per_metre;
    struct sieve sieve = { .places = s->list->own->place, .bound = s->bound - (scan_ints){ 0 } };
    double centre[DIM], half[DIM];

    for (int d = 0; d < DIM; d++) {
        centre[d] = 0.5 * (s->low[d] + s->high[d]) * unit;
        half[d] = 0.5 * (s->high[d] - s->low[d]) * unit + s->wide - LIST_UNITS;
    }
    for (int w = 0; w < LIST_WORDS; w++) {
        sieve.centre[w] = word(centre + 2 * w, DIM - 2 * w);
        sieve.half[w] = word(half + 2 * w, DIM - 2 * w);
    }
    return sieve;
}

/* Two chunks at a time without asking whether both are needed: a mispredicted branch
 * costs more. */
static void take_runs(struct scan *s)
{
    enum { BLOCK = 2 * SCAN_WIDE };
    const struct sieve sieve = sieve_of(s);
    int n = 0;

    for (int r = 0; r < s->work.runs; r++) {
        const struct scan_run run = s->work.run[r];

        for (int at = run.from; at < run.to; at += BLOCK) {
            if (n > SCAN_MOST - BLOCK) {
                compare_all(s, &sieve, n);
                n = 0;
            }
            n = sift(&s->work, &sieve, at, run.to, n);
            n = sift(&s->work, &sieve, at + SCAN_WIDE, run.to, n);
        }
    }
    compare_all(s, &sieve, n);
    s->work.runs = 0;
}

/* The places from..to-1, in ascending runs. */
static inline void take_run(struct scan *s, int from, int to)
{
    if (s->work.runs == SCAN_RUNS)
        take_runs(s);
    s->work.run[s->work.runs] = (struct scan_run){ from, to };
    s->work.runs += from < to;
}

/* After the last run. */
static void take_rest(struct scan *s)
{
    if (s->work.runs > 0)
        take_runs(s);
}

static void prepare(struct scan *s)
{
    s->work.runs = 0;
}

static void set_lanes(struct scan *s)
{
    (void)s;
}

#endif
