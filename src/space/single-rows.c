/* single-rows.c -- fetches records of single precision and forms rows. */
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

#if LANES != 16
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

/* Where the records of one half's owners are. */
LANES_INLINE void find_owners(const struct single_owners *at, int half, const float *record,
                              size_t floats, const float **of)
{
    const int first = at->first[half];

    if (first + SINGLE_HALF <= at->end)
        for (int l = 0; l < SINGLE_HALF; l++)
            of[l] = record + ((size_t)first + (size_t)l) * floats;
    else
        for (int l = 0; l < SINGLE_HALF; l++)
            of[l] = record + (size_t)(first + l < at->end ? first + l : at->dummy) * floats;
}

/* `alike` is a constant, as for rows. */
LANES_INLINE void fill_side(const struct single_records *all, bool alike,
                            const struct single_owners *at, struct single_side *own)
{
    const float *of[LANES];
    struct held h;

    for (int half = 0; half < 2; half++)
        find_owners(at, half, all->record, alike || DIM == 2 ? 8 : 12, of + half * SINGLE_HALF);
    whole(of, alike, all->mass, &h);
    for (int d = 0; d < DIM; d++) {
        own->x[d] = h.x[d];
        own->a.v[d] = h.v[d];
    }
    own->a.rho = h.rho;
    own->a.p2 = h.p2;
    own->a.m = h.m;
    own->a.irho = h.irho;
}

void single_rows_side(const struct single_records *all, const struct single_owners *at,
                      struct single_side *own)
{
    if (SHORT && all->mass > 0)
        fill_side(all, SHORT, at, own);
    else
        fill_side(all, false, at, own);
}

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

/* Row k; `needs` and `alike` are constants, as in gather.c. */
LANES_INLINE void fill_row(const float *const of[LANES], const struct single_records *all,
                           bool alike, const struct single_side *own, unsigned needs,
                           struct block *b, int k)
{
    const struct side *a = &own->a;
    struct held h;
    lanes x[DIM], v[DIM];

    whole(of, alike, all->mass, &h);
    for (int d = 0; d < DIM; d++) {
        x[d] = all->count * __builtin_convertvector(way(own->x[d], h.x[d]), lanes);
        v[d] = a->v[d] - h.v[d];
    }
    const lanes r2 = dot(x, x);
    b->r2[k] = r2;
    b->r[k] = lanes_sqrt(r2);
    b->mm[k] = a->m * h.m;
    for (int d = 0; d < DIM; d++) {
        b->x[d][k] = x[d];
        if (needs & NEED_V)
            b->v[d][k] = v[d];
    }
    if (needs & NEED_XV)
        b->xv[k] = dot(x, v);
    if (needs & NEED_RHO) {
        b->rho[k] = h.rho;
        b->p2[k] = h.p2;
    }
    if (needs & NEED_IRHO)
        b->irho[k] = h.irho;
    if (needs & NEED_MASS)
        b->m[k] = h.m;
}

LANES_INLINE void fill(const struct single_records *all, bool alike,
                       const struct single_places *from, int n, const struct single_side *own,
                       unsigned needs, struct block *b, int at)
{
    const size_t floats = alike || DIM == 2 ? 8 : 12;
    const int *first = from->j[0], *second = from->j[1];

    for (int k = at; k < at + n; k++) {
        const float *of[LANES];

        for (int l = 0; l < SINGLE_HALF; l++) {
            of[l] = all->record + (size_t)(unsigned)first[l] * floats;
            of[SINGLE_HALF + l] = all->record + (size_t)(unsigned)second[l] * floats;
        }
        fill_row(of, all, alike, own, needs, b, k);
        first += from->step[0];
        second += from->step[1];
    }
}

/* Fewer kinds of rows than in double precision: a needless store costs less here. */
void single_rows_fill(const struct single_records *all, const struct single_places *from, int n,
                      const struct single_side *own, unsigned needs, struct block *b, int at)
{
    enum { PLAIN = NEED_XV | NEED_RHO, USUAL = PLAIN | NEED_IRHO,
           ALL = USUAL | NEED_V | NEED_MASS };
    const bool alike = SHORT && all->mass > 0;

    if (alike && !(needs & (NEED_MASS | NEED_V | NEED_IRHO)))
        fill(all, SHORT, from, n, own, PLAIN, b, at);
    else if (alike && !(needs & (NEED_MASS | NEED_V)))
        fill(all, SHORT, from, n, own, USUAL, b, at);
    else if (alike)
        fill(all, SHORT, from, n, own, ALL, b, at);
    else if (needs & (NEED_MASS | NEED_V))
        fill(all, false, from, n, own, ALL, b, at);
    else
        fill(all, false, from, n, own, USUAL, b, at);
}
