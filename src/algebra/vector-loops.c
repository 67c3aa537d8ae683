/* vector-loops.c -- loops over y, block by block, that any room may use. */
#include "algebra/vector.h"

#include "algebra/vector-blocks.h"
#include <float.h>
#include <math.h>
#include <string.h>

static void combine_block(int terms, const double *c, const double *const *x, long from, int n,
                          double *to)
{
    const int unit = terms > 1 && c[0] == 1; /* x[0] is added last */
    double sum[VECTOR_BLOCK];

    memset(sum, 0, sizeof sum);
    for (int k = unit; k < terms; k++) {
        const double ck = c[k], *xk = x[k] + from;
        if (ck == 0)
            continue;
#pragma omp simd
        for (int i = 0; i < n; i++)
            sum[i] += ck * xk[i];
    }
    if (unit) {
        const double *x0 = x[0] + from;
#pragma omp simd
        for (int i = 0; i < n; i++)
            sum[i] = x0[i] + sum[i];
    }
    memcpy(to + from, sum, (size_t)n * sizeof *sum);
}

void vector_combine(int terms, const double *c, const double *const *x, long n, double *to)
{
#pragma omp parallel for schedule(static) if (n > VECTOR_LONG)
    for (long b = 0; b < vector_blocks(n); b++)
        combine_block(terms, c, x, b * VECTOR_BLOCK, vector_block_size(n, b), to);
}

void vector_copy(long n, const double *x, double *to)
{
#pragma omp parallel for schedule(static) if (n > VECTOR_LONG)
    for (long b = 0; b < vector_blocks(n); b++)
        memcpy(to + b * VECTOR_BLOCK, x + b * VECTOR_BLOCK,
               (size_t)vector_block_size(n, b) * sizeof *x);
}

static bool block_bad(const double *x, int n)
{
    int bad = 0;

#pragma omp simd reduction(| : bad)
    for (int i = 0; i < n; i++)
        bad |= !(fabs(x[i]) <= DBL_MAX);
    return bad;
}

long vector_first_bad(long n, const double *x)
{
    long first = n;

#pragma omp parallel for schedule(static) reduction(min : first) if (n > VECTOR_LONG)
    for (long b = 0; b < vector_blocks(n); b++)
        if (b * VECTOR_BLOCK < first && block_bad(x + b * VECTOR_BLOCK, vector_block_size(n, b)))
            first = b * VECTOR_BLOCK;
    while (first < n && fabs(x[first]) <= DBL_MAX)
        first++;
    return first < n ? first : -1;
}
