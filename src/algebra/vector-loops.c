/* vector-loops.c -- loops over y, block by block, that any room may use. */
#include "algebra/vector.h"

#include "algebra/vector-blocks.h"
#include <float.h>
#include <math.h>
#include <string.h>

/* Terms that one pass adds up: more passes wait longer for memory. */
enum { TOGETHER = 6 };

/* to = unit + (c[0] x[0] + c[1] x[1] + ...); fast with a constant number of terms. */
static inline __attribute__((always_inline)) void
add_up(int terms, const double *c, const double *const *x, const double *unit, int n, double *to)
{
#pragma omp simd
    for (int i = 0; i < n; i++) {
        double sum = 0;

        for (int k = 0; k < terms; k++)
            sum += c[k] * x[k][i];
        to[i] = unit ? unit[i] + sum : sum;
    }
}

#define ADD_UP(name, terms)                                                                \
    static void name(const double *c, const double *const *x, const double *unit, int n,   \
                     double *to)                                                           \
    {                                                                                      \
        if (unit)                                                                          \
            add_up(terms, c, x, unit, n, to);                                              \
        else                                                                               \
            add_up(terms, c, x, NULL, n, to);                                              \
    }

ADD_UP(add_up_1, 1)
ADD_UP(add_up_2, 2)
ADD_UP(add_up_3, 3)
ADD_UP(add_up_4, 4)
ADD_UP(add_up_5, 5)
ADD_UP(add_up_6, 6)

typedef void add_up_terms(const double *c, const double *const *x, const double *unit, int n,
                          double *to);

static add_up_terms *const together[TOGETHER + 1] = {
    NULL, add_up_1, add_up_2, add_up_3, add_up_4, add_up_5, add_up_6
};

/* As many terms as there may be, in passes over a block that stays near. */
static void add_up_many(int terms, const double *c, const double *const *x, const double *unit,
                        int n, double *to)
{
    double sum[VECTOR_BLOCK];

    memset(sum, 0, sizeof sum);
    for (int k = 0; k < terms; k++) {
        const double ck = c[k], *xk = x[k];
#pragma omp simd
        for (int i = 0; i < n; i++)
            sum[i] += ck * xk[i];
    }
    for (int i = 0; i < n; i++)
        to[i] = unit ? unit[i] + sum[i] : sum[i];
}

static void combine_block(int terms, const double *c, const double *const *x, long from, int n,
                          double *to)
{
    const int unit = terms > 1 && c[0] == 1; /* x[0] is added last */
    const double *xk[64], *first = unit ? x[0] + from : NULL;
    double ck[64];
    int m = 0;

    for (int k = unit; k < terms; k++)
        if (c[k] != 0) {
            ck[m] = c[k];
            xk[m++] = x[k] + from;
        }
    if (m > 0 && m <= TOGETHER)
        together[m](ck, xk, first, n, to + from);
    else
        add_up_many(m, ck, xk, first, n, to + from);
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
