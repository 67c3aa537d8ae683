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
#if LANES == 4
#include <immintrin.h>
#endif

/* Fields at and at + 1 of the records of LANES slots. */
LANES_INLINE void pair_of_fields(const double *record, const int *j, int at, lanes *first,
                                  lanes *second)
{
    const double *of[LANES];

    for (int l = 0; l < LANES; l++)
        of[l] = record + (size_t)j[l] * RECORD + at;
#if LANES == 4
    const __m256d e = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(of[0])),
                                           _mm_load_pd(of[2]), 1);
    const __m256d o = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(of[1])),
                                           _mm_load_pd(of[3]), 1);
    *first = (lanes)_mm256_unpacklo_pd(e, o);
    *second = (lanes)_mm256_unpackhi_pd(e, o);
#else
    lanes a, b;

    memcpy(&a, of[0], sizeof a);
    memcpy(&b, of[1], sizeof b);
    *first = __builtin_shufflevector(a, b, 0, 2);
    *second = __builtin_shufflevector(a, b, 1, 3);
#endif
}

/* Everything that a record holds. */
LANES_INLINE void whole(const double *record, const int *j, struct side *s)
{
    pair_of_fields(record, j, RECORD_X, &s->x[0], &s->x[1]);
    pair_of_fields(record, j, RECORD_V, &s->v[0], &s->v[1]);
    pair_of_fields(record, j, RECORD_M, &s->m, &s->irho);
#if DIM == 2
    pair_of_fields(record, j, RECORD_RHO, &s->rho, &s->p2);
#else
    pair_of_fields(record, j, RECORD_Z, &s->x[2], &s->rho);
    pair_of_fields(record, j, RECORD_VZ, &s->v[2], &s->p2);
#endif
}

LANES_INLINE lanes dot(const lanes *a, const lanes *b)
{
    lanes sum = a[0] * b[0];

    for (int d = 1; d < DIM; d++)
        sum += a[d] * b[d];
    return sum;
}

/* One row; `needs` is a constant, so what is not needed is not even loaded. */
LANES_INLINE void gather_row(const double *record, const int *j, const struct side *a,
                              struct block *b, int k, unsigned needs)
{
    struct side of;
    lanes x[DIM], v[DIM];

    whole(record, j, &of);
    gather_separation(a->x, of.x, x);
    b->r2[k] = dot(x, x);
    b->m[k] = of.m;
    for (int d = 0; d < DIM; d++)
        b->x[d][k] = x[d];
    if (needs & NEED_V) {
        for (int d = 0; d < DIM; d++)
            b->v[d][k] = v[d] = a->v[d] - of.v[d];
        b->xv[k] = dot(x, v);
    }
    if (needs & NEED_RHO) {
        b->rho[k] = of.rho;
        b->p2[k] = of.p2;
        b->irho[k] = of.irho;
    }
}

#define GATHER(name, needs)                                                                \
    static void name(const double *record, const int *j, int n, const struct side *a,      \
                     struct block *b)                                                      \
    {                                                                                      \
        for (int k = 0; k < n; k++, j += LANES)                                            \
            gather_row(record, j, a, b, k, needs);                                         \
    }

GATHER(gather_place, 0)
GATHER(gather_motion, NEED_V)
GATHER(gather_matter, NEED_RHO)
GATHER(gather_all, NEED_V | NEED_RHO)

gather_rows *gather_choose(unsigned needs)
{
    const bool motion = needs & (NEED_V | NEED_XV);
    const bool matter = needs & (NEED_RHO | NEED_P2 | NEED_IRHO);

    if (motion)
        return matter ? gather_all : gather_motion;
    return matter ? gather_matter : gather_place;
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

/* m_a m_b first, so that both sides of a pair get the same bits. */
static void times_masses(int n, lanes m, const lanes *of, lanes *g)
{
    for (int k = 0; k < n; k++)
        g[k] = m * of[k] * g[k];
}

void gather_kernel(unsigned needs, const struct kernel_use *use, const struct side *a,
                   struct block *b)
{
    if (needs & NEED_GRADW) {
        use->kernel->gradient(use->support, use->scale, b->n, b->r2, b->gw);
        times_masses(b->n, a->m, b->m, b->gw);
    }
    if (needs & NEED_W) {
        use->kernel->value(use->support, use->scale, b->n, b->r2, b->w);
        times_masses(b->n, a->m, b->m, b->w);
    }
}
