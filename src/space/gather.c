/* gather.c -- fetches records two fields at a time and forms the rows.
 *
 * Loads of 16 bytes put together with inserts and unpacks beat the generic
 * shuffles of the compiler (15 against 23 ns per particle with 20 neighbours)
 * and the machine's own gather instruction. */
#include "space/gather.h"
#include "space/record.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>
#if LANES > 2
#include <immintrin.h>
#endif

#if LANES == 8
/* Two fields of four records. */
LANES_INLINE __m512d join_two(const double *a, const double *b, const double *c,
                              const double *d)
{
    const __m256d ab = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(a)),
                                            _mm_load_pd(b), 1);
    const __m256d cd = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(c)),
                                            _mm_load_pd(d), 1);

    return _mm512_insertf64x4(_mm512_castpd256_pd512(ab), cd, 1);
}

/* Four fields of two records. */
LANES_INLINE __m512d join_four(const double *a, const double *b)
{
    return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(a)), _mm256_loadu_pd(b),
                              1);
}
#endif

/* Two fields of the LANES records `of`.  Integer unpacks have twice as many
 * ports as those of doubles. */
LANES_INLINE void pair_of_fields(const double *const of[LANES], int at, lanes *first,
                                 lanes *second)
{
#if LANES == 8
    const __m512d e = join_two(of[0] + at, of[2] + at, of[4] + at, of[6] + at);
    const __m512d o = join_two(of[1] + at, of[3] + at, of[5] + at, of[7] + at);
    *first = _mm512_unpacklo_pd(e, o);
    *second = _mm512_unpackhi_pd(e, o);
#elif LANES == 4
    const __m256d e = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(of[0] + at)),
                                           _mm_load_pd(of[2] + at), 1);
    const __m256d o = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(of[1] + at)),
                                           _mm_load_pd(of[3] + at), 1);
    *first = (lanes)_mm256_unpacklo_epi64((__m256i)e, (__m256i)o);
    *second = (lanes)_mm256_unpackhi_epi64((__m256i)e, (__m256i)o);
#else
    lanes a, b;

    memcpy(&a, of[0] + at, sizeof a);
    memcpy(&b, of[1] + at, sizeof b);
    *first = __builtin_shufflevector(a, b, 0, 2);
    *second = __builtin_shufflevector(a, b, 1, 3);
#endif
}

/* Four fields that stand together. */
LANES_INLINE void four_fields(const double *const of[LANES], int at, lanes *first,
                              lanes *second, lanes *third, lanes *fourth)
{
#if LANES == 8
    const __m512d a = join_four(of[0] + at, of[2] + at), b = join_four(of[1] + at, of[3] + at);
    const __m512d c = join_four(of[4] + at, of[6] + at), d = join_four(of[5] + at, of[7] + at);
    const __m512d ab = _mm512_unpacklo_pd(a, b), ab2 = _mm512_unpackhi_pd(a, b);
    const __m512d cd = _mm512_unpacklo_pd(c, d), cd2 = _mm512_unpackhi_pd(c, d);
    *first = _mm512_shuffle_f64x2(ab, cd, 0x88);
    *second = _mm512_shuffle_f64x2(ab2, cd2, 0x88);
    *third = _mm512_shuffle_f64x2(ab, cd, 0xdd);
    *fourth = _mm512_shuffle_f64x2(ab2, cd2, 0xdd);
#else
    pair_of_fields(of, at, first, second);
    pair_of_fields(of, at + 2, third, fourth);
#endif
}

/* Everything that the records of LANES slots hold. */
LANES_INLINE void whole(const double *record, const int *j, struct side *s)
{
    const double *of[LANES];

    for (int l = 0; l < LANES; l++)
        of[l] = record + (size_t)(unsigned)j[l] * RECORD;
#if DIM == 2
    four_fields(of, RECORD_X, &s->x[0], &s->x[1], &s->v[0], &s->v[1]);
    four_fields(of, RECORD_RHO, &s->rho, &s->p2, &s->m, &s->irho);
#else
    four_fields(of, RECORD_X, &s->x[0], &s->x[1], &s->x[2], &s->rho);
    four_fields(of, RECORD_V, &s->v[0], &s->v[1], &s->v[2], &s->p2);
    pair_of_fields(of, RECORD_M, &s->m, &s->irho);
#endif
}

LANES_INLINE lanes dot(const lanes *a, const lanes *b)
{
    lanes sum = a[0] * b[0];

    for (int d = 1; d < DIM; d++)
        sum += a[d] * b[d];
    return sum;
}

/* One row; `needs` is a constant, so what is not needed is not even loaded.
 * The root is taken here because here it hides behind the loads. */
LANES_INLINE void gather_row(const double *record, const int *j, const struct side *a,
                             struct block *b, int k, unsigned needs)
{
    struct side of;
    lanes x[DIM], v[DIM];

    whole(record, j, &of);
    gather_separation(a->x, of.x, x);
    const lanes r2 = dot(x, x);
    b->r2[k] = r2;
    b->r[k] = lanes_sqrt(r2);
    b->mm[k] = a->m * of.m;
    for (int d = 0; d < DIM; d++) {
        b->x[d][k] = x[d];
        v[d] = a->v[d] - of.v[d];
        if (needs & NEED_V)
            b->v[d][k] = v[d];
    }
    if (needs & NEED_XV)
        b->xv[k] = dot(x, v);
    if (needs & NEED_RHO) {
        b->rho[k] = of.rho;
        b->p2[k] = of.p2;
    }
    if (needs & NEED_IRHO)
        b->irho[k] = of.irho;
    if (needs & NEED_MASS)
        b->m[k] = of.m;
}

#define GATHER(name, needs)                                                                \
    static void name(const double *record, const int *j, int n, const struct side *a,      \
                     struct block *b)                                                      \
    {                                                                                      \
        for (int k = 0; k < n; k++, j += LANES)                                            \
            gather_row(record, j, a, b, k, needs);                                         \
    }

GATHER(gather_place, 0)
GATHER(gather_place_rho, NEED_RHO)
GATHER(gather_approach, NEED_XV)
GATHER(gather_approach_rho, NEED_XV | NEED_RHO)
GATHER(gather_approach_all_rho, NEED_XV | NEED_RHO | NEED_IRHO)
GATHER(gather_all, NEED_XV | NEED_RHO | NEED_V | NEED_IRHO | NEED_MASS)

gather_rows *gather_choose(unsigned needs)
{
    const bool rho = needs & (NEED_RHO | NEED_P2);

    if (needs & (NEED_MASS | NEED_V))
        return gather_all;
    if (needs & NEED_IRHO)
        return gather_approach_all_rho;
    if (needs & NEED_XV)
        return rho ? gather_approach_rho : gather_approach;
    return rho ? gather_place_rho : gather_place;
}

void gather_side(const double *record, int first, int end, int dummy, struct side *a)
{
    int j[LANES];

    for (int l = 0; l < LANES; l++)
        j[l] = first + l < end ? first + l : dummy;
    whole(record, j, a);
    for (int l = 0; l < LANES; l++)
        for (int d = 0; d < DIM; d++)
            if (j[l] == dummy)
                a->x[d][l] = -a->x[d][l];
}

/* One division for all laws that soften 1/r^2. */
static void soften(double support, struct block *b)
{
    const double eta2 = kernel_softening(support);

    for (int k = 0; k < b->n; k++)
        b->gw_r2[k] = b->gw[k] / (b->r2[k] + eta2);
}

void gather_kernel(unsigned needs, const struct kernel_use *use, struct block *b)
{
    const struct kernel_rows *kernel = use->kernel->rows;

    if ((needs & NEED_GRADW_R2) && kernel->both)
        kernel->both(use->support, use->scale, b->n, b->r, b->r2, b->mm, b->gw, b->gw_r2);
    else if (needs & (NEED_GRADW | NEED_GRADW_R2))
        kernel->gradient(use->support, use->scale, b->n, b->r, b->mm, b->gw);
    if ((needs & NEED_GRADW_R2) && !kernel->both)
        soften(use->support, b);
    if (needs & NEED_W)
        kernel->value(use->support, use->scale, b->n, b->r, b->mm, b->w);
    if (needs & NEED_LAPW)
        kernel->laplacian(use->support, use->scale, b->n, b->r, b->mm, b->lw);
}
