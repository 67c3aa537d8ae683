/* single-row.h -- rows of neighbours in single precision, in registers: single_row(), of which
 * most else here is a part. */
#ifndef SPACE_SINGLE_ROW_H
#define SPACE_SINGLE_ROW_H

#include "space/single-rows.h"

#include <immintrin.h>
#include <stdbool.h>

/* What the records of LANES places hold; positions in counts. */
struct held {
    lanes_mask x[DIM];
    lanes v[DIM], rho, p2, m, irho;
};

/* Numbers of two rows of four-number blocks, as the instructions of each width have it. */
#if LANES == 16
#define LOW(a, b) (lanes)_mm512_unpacklo_ps((__m512)(a), (__m512)(b))
#define HIGH(a, b) (lanes)_mm512_unpackhi_ps((__m512)(a), (__m512)(b))
#define FIRSTS(a, b) (lanes)_mm512_shuffle_ps((__m512)(a), (__m512)(b), 0x44)
#define SECONDS(a, b) (lanes)_mm512_shuffle_ps((__m512)(a), (__m512)(b), 0xee)
#elif LANES == 8
#define LOW(a, b) (lanes)_mm256_unpacklo_ps((__m256)(a), (__m256)(b))
#define HIGH(a, b) (lanes)_mm256_unpackhi_ps((__m256)(a), (__m256)(b))
#define FIRSTS(a, b) (lanes)_mm256_shuffle_ps((__m256)(a), (__m256)(b), 0x44)
#define SECONDS(a, b) (lanes)_mm256_shuffle_ps((__m256)(a), (__m256)(b), 0xee)
#else
#define LOW(a, b) (lanes)_mm_unpacklo_ps((__m128)(a), (__m128)(b))
#define HIGH(a, b) (lanes)_mm_unpackhi_ps((__m128)(a), (__m128)(b))
#define FIRSTS(a, b) (lanes)_mm_shuffle_ps((__m128)(a), (__m128)(b), 0x44)
#define SECONDS(a, b) (lanes)_mm_shuffle_ps((__m128)(a), (__m128)(b), 0xee)
#endif

/* Rows a to d of four numbers become columns, in each block of four lanes. */
LANES_INLINE void turn(lanes a, lanes b, lanes c, lanes d, lanes *to)
{
    const lanes ab = LOW(a, b), cd = LOW(c, d), ab2 = HIGH(a, b), cd2 = HIGH(c, d);

    to[0] = FIRSTS(ab, cd);
    to[1] = SECONDS(ab, cd);
    to[2] = FIRSTS(ab2, cd2);
    to[3] = SECONDS(ab2, cd2);
}

#if LANES == 16
/* Eight numbers of two records. */
LANES_INLINE lanes join(const float *a, const float *b)
{
    const __m512d low = _mm512_castpd256_pd512(_mm256_loadu_pd((const double *)a));

    return (lanes)_mm512_insertf64x4(low, _mm256_loadu_pd((const double *)b), 1);
}

/* The first eight numbers of each record, lane by lane. */
LANES_INLINE void fetch_eight(const float *const of[LANES], lanes *to)
{
    lanes near[4], far[4];

    turn(join(of[0], of[4]), join(of[1], of[5]), join(of[2], of[6]), join(of[3], of[7]), near);
    turn(join(of[8], of[12]), join(of[9], of[13]), join(of[10], of[14]), join(of[11], of[15]),
         far);
    for (int i = 0; i < 4; i++) {
        to[i] = (lanes)_mm512_shuffle_f32x4((__m512)near[i], (__m512)far[i], 0x88);
        to[4 + i] = (lanes)_mm512_shuffle_f32x4((__m512)near[i], (__m512)far[i], 0xdd);
    }
}

/* Four numbers from `at` on. */
LANES_INLINE lanes join_four(const float *const of[LANES], int k, int at)
{
    __m512 r = _mm512_castps128_ps512(_mm_load_ps(of[k] + at));

    r = _mm512_insertf32x4(r, _mm_load_ps(of[k + 4] + at), 1);
    r = _mm512_insertf32x4(r, _mm_load_ps(of[k + 8] + at), 2);
    return (lanes)_mm512_insertf32x4(r, _mm_load_ps(of[k + 12] + at), 3);
}
#elif LANES == 8
LANES_INLINE lanes join_four(const float *const of[LANES], int k, int at)
{
    const __m256 r = _mm256_castps128_ps256(_mm_load_ps(of[k] + at));

    return (lanes)_mm256_insertf128_ps(r, _mm_load_ps(of[k + 4] + at), 1);
}
#else
LANES_INLINE lanes join_four(const float *const of[LANES], int k, int at)
{
    return (lanes)_mm_load_ps(of[k] + at);
}
#endif

LANES_INLINE void fetch_four(const float *const of[LANES], int at, lanes *to)
{
    turn(join_four(of, 0, at), join_four(of, 1, at), join_four(of, 2, at), join_four(of, 3, at),
         to);
}

#if LANES == 8
LANES_INLINE void fetch_eight(const float *const of[LANES], lanes *to)
{
    lanes near[4], far[4], r[8];

    for (int l = 0; l < 8; l++)
        r[l] = (lanes)_mm256_loadu_ps(of[l]); /* records of 12 floats are not aligned to 32 bytes */
    turn(r[0], r[1], r[2], r[3], near);
    turn(r[4], r[5], r[6], r[7], far);
    for (int i = 0; i < 4; i++) {
        to[i] = (lanes)_mm256_permute2f128_ps((__m256)near[i], (__m256)far[i], 0x20);
        to[4 + i] = (lanes)_mm256_permute2f128_ps((__m256)near[i], (__m256)far[i], 0x31);
    }
}
#elif LANES != 16
LANES_INLINE void fetch_eight(const float *const of[LANES], lanes *to)
{
    fetch_four(of, 0, to);
    fetch_four(of, 4, to + 4);
}
#endif

#if DIM == 2
enum { SHORT = false };

LANES_INLINE void whole(const float *const of[LANES], bool alike, real mass, struct held *h)
{
    lanes n[8];

    (void)alike;
    (void)mass;
    fetch_eight(of, n);
    *h = (struct held){
        .x = { (lanes_mask)n[0], (lanes_mask)n[1] }, .v = { n[2], n[3] },
        .rho = n[4], .p2 = n[5], .m = n[6], .irho = n[7],
    };
}
#else
enum { SHORT = true }; /* records may be */

/* alike: masses are `mass`, a constant, so that what is not needed is not formed. */
LANES_INLINE void whole(const float *const of[LANES], bool alike, real mass, struct held *h)
{
    lanes n[8], rest[4];

    fetch_eight(of, n);
    *h = (struct held){
        .x = { (lanes_mask)n[0], (lanes_mask)n[1], (lanes_mask)n[2] },
        .v = { n[4], n[5], n[6] }, .rho = n[3], .p2 = n[7],
    };
    if (alike) {
        h->m = lanes_where(n[3] > 0, lanes_all(mass));
        h->irho = 1 / n[3];
        return;
    }
    fetch_four(of, 8, rest);
    h->m = rest[0];
    h->irho = rest[1];
}
#endif

LANES_INLINE lanes dot(const lanes *a, const lanes *b)
{
    lanes sum = a[0] * b[0];

    for (int d = 1; d < DIM; d++)
        sum += a[d] * b[d];
    return sum;
}

typedef unsigned circle __attribute__((vector_size(sizeof(lanes_mask))));

/* From b to a, the short way around the circle. */
LANES_INLINE lanes_mask way(lanes_mask a, lanes_mask b)
{
    return (lanes_mask)((circle)a - (circle)b);
}

/* The record that an entry of a row names. */
LANES_INLINE const float *at_entry(const float *record, int entry, size_t floats)
{
    return (const float *)list_at((const double *)record, entry, (int)floats / 2);
}

/* Where the records of a row are: entries of both halves. */
LANES_INLINE void single_find(const struct single_records *all, bool alike, const int *first,
                              const int *second, const float **of)
{
    const size_t floats = alike || DIM == 2 ? 8 : 12;

    for (int l = 0; l < SINGLE_HALF; l++) {
        of[l] = at_entry(all->record, first[l], floats);
        of[SINGLE_HALF + l] = at_entry(all->record, second[l], floats);
    }
}

/* Of records at `of`; `alike` is a constant. */
LANES_INLINE void single_row_at(const float *const of[LANES], const struct single_records *all,
                                bool alike, const struct single_side *own, struct whole_row *to)
{
    struct row *row = &to->pair;
    struct held h;

    whole(of, alike, all->mass, &h);
    for (int d = 0; d < DIM; d++) {
        row->x[d] = all->count * __builtin_convertvector(way(own->x[d], h.x[d]), lanes);
        row->v[d] = own->a.v[d] - h.v[d];
    }
    row->r2 = dot(row->x, row->x);
    row->xv = dot(row->x, row->v);
    row->rho = h.rho;
    row->p2 = h.p2;
    row->irho = h.irho;
    to->r = lanes_sqrt(row->r2);
    to->mm = own->a.m * h.m;
    to->m = h.m;
}

/* Rows of both halves for the owners at hand. */
struct pairs_source {
    const struct single_records *all;
    struct single_places from[2];
    const struct single_side *own;
};

/* Row k of those; `alike` is a constant. */
LANES_INLINE void single_row(const struct pairs_source *rows, bool alike, int k,
                             struct whole_row *to)
{
    const struct single_places *from = rows->from;
    const float *of[LANES];

    single_find(rows->all, alike, from[0].j + (size_t)k * from[0].step,
                from[1].j + (size_t)k * from[1].step, of);
    single_row_at(of, rows->all, alike, rows->own, to);
}

/* Are these records without masses? */
LANES_INLINE bool single_alike(const struct single_records *all)
{
    return SHORT && all->mass > 0;
}

#endif
