/* vector-dot.c -- x . y, the same on any number of threads: four sums a block, blocks in
 * their order; and the largest product of two entries, of all ranks. */
#include "algebra/vector-private.h"

#include "base/threads.h"
#include "ranks/ranks.h"

#include <math.h>

static double block_dot(const double *x, const double *y, int n)
{
    double sum[4] = { 0 };
    int i = 0;

    for (; i + 4 <= n; i += 4)
        for (int k = 0; k < 4; k++)
            sum[k] += x[i + k] * y[i + k];
    for (int k = 0; i + k < n; k++)
        sum[k] += x[i + k] * y[i + k];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

static double add_blocks(long n, const double *partial)
{
    double sum = 0;

    for (long b = 0; b < vector_blocks(n); b++)
        sum += partial[b];
    return sum;
}

/* Of this thread's blocks. */
static void dot_blocks(long n, const double *x, const double *y, double *partial)
{
#pragma omp for schedule(static) nowait
    for (long b = 0; b < vector_blocks(n); b++)
        partial[b] = block_dot(x + b * VECTOR_BLOCK, y + b * VECTOR_BLOCK,
                               vector_block_size(n, b));
}

double vector_dot(long n, const double *x, const double *y, double *partial)
{
    THREADS(n > VECTOR_LONG, dot_blocks(n, x, y, partial));
    return add_blocks(n, partial);
}

static void dot_blocks_in_order(const struct vector_family *f, const double *x, const double *y)
{
#pragma omp for schedule(static) nowait
    for (long b = 0; b < vector_blocks(f->n); b++) {
        double xb[VECTOR_BLOCK], yb[VECTOR_BLOCK];

        f->partial[b] = block_dot(vector_in_order(f, x, b, xb), vector_in_order(f, y, b, yb),
                                  vector_block_size(f->n, b));
    }
}

static double dot_in_order(const struct vector_family *f, const double *x, const double *y)
{
    THREADS(f->n > VECTOR_LONG, dot_blocks_in_order(f, x, y));
    return add_blocks(f->n, f->partial);
}

sunrealtype vector_dot_product(N_Vector x, N_Vector y)
{
    const struct vector_family *f = vector_content(x)->family;

    if (f->order)
        return dot_in_order(f, vector_read(x), vector_read(y));
    return vector_dot(f->n, vector_read(x), vector_read(y), f->partial);
}

double vector_most(long n, const double *x, const double *weight)
{
    double most = 0;

    for (long i = 0; i < n; i++)
        most = fmax(most, fabs(x[i] * weight[i]));
    ranks_most(1, &most);
    return most;
}
