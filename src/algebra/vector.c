/* vector.c -- the operations of a step: blocked, threaded, with fixed bits. */
#include "algebra/vector.h"

#include "algebra/vector-blocks.h"
#include "base/status.h"
#include <float.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdlib.h>
#include <string.h>

/* What all clones of a vector share. */
struct family {
    enum vector_norm norm;
    long largest;
    double *partial; /* [blocks] of a reduction */
    int members;
};

struct content {
    struct _N_VectorContent_Serial serial; /* first: serial operations see this */
    struct family *family;
};

static struct content *content(N_Vector v)
{
    return v->content;
}

static long length(N_Vector v)
{
    return (long)content(v)->serial.length;
}

double *vector_data(N_Vector v)
{
    return content(v)->serial.data;
}

/* --- linear combinations ------------------------------------------------- */

static int linear_combination(int terms, sunrealtype *c, N_Vector *v, N_Vector z)
{
    const double *x[64];

    if (terms < 1 || terms > 64)
        return -1;
    for (int k = 0; k < terms; k++)
        x[k] = vector_data(v[k]);
    vector_combine(terms, c, x, length(z), vector_data(z));
    return 0;
}

static void linear_sum(sunrealtype a, N_Vector x, sunrealtype b, N_Vector y, N_Vector z)
{
    const double c[2] = { a, b }, *const v[2] = { vector_data(x), vector_data(y) };

    vector_combine(2, c, v, length(z), vector_data(z));
}

static void scale(sunrealtype c, N_Vector x, N_Vector z)
{
    const double *const v[1] = { vector_data(x) };

    if (c != 1)
        vector_combine(1, &c, v, length(z), vector_data(z));
    else if (x != z)
        vector_copy(length(z), v[0], vector_data(z));
}

static void constant(sunrealtype c, N_Vector z)
{
    double *to = vector_data(z);
    const long n = length(z);

#pragma omp parallel for schedule(static) if (n > VECTOR_LONG)
    for (long b = 0; b < vector_blocks(n); b++)
        for (int i = 0; i < vector_block_size(n, b); i++)
            to[b * VECTOR_BLOCK + i] = c;
}

/* --- norms --------------------------------------------------------------- */

/* Largest e_i, infinite when one is not finite.  A maximum does not depend on
 * the order, so the compiler may take several at once. */
static double block_max(const double *x, const double *w, int n)
{
    double most = 0;
    int bad = 0;

#pragma omp simd reduction(max : most) reduction(| : bad)
    for (int i = 0; i < n; i++) {
        const double e = fabs(x[i] * w[i]);
        most = e > most ? e : most;
        bad |= !(e <= DBL_MAX);
    }
    return bad ? INFINITY : most;
}

static double eighth(double e)
{
    const double e2 = e * e, e4 = e2 * e2;

    return e4 * e4;
}

static double block_p8(const double *x, const double *w, int n)
{
    double sum[4] = { 0 };

    for (int i = 0; i < n; i++)
        sum[i % 4] += eighth(x[i] * w[i]);
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

static double block_square(const double *x, const double *w, int n)
{
    double sum[4] = { 0 };

    for (int i = 0; i < n; i++)
        sum[i % 4] += (x[i] * w[i]) * (x[i] * w[i]);
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

typedef double block_norm(const double *x, const double *w, int n);

static block_norm *const block_norms[] = {
    [VECTOR_NORM_MAX] = block_max, [VECTOR_NORM_P8] = block_p8, [VECTOR_NORM_WRMS] = block_square
};

/* The first block with the largest share (NaN: larger than any). */
static long leading_block(const double *partial, long n)
{
    long lead = 0;

    for (long b = 0; b < n && partial[lead] <= DBL_MAX; b++)
        if (!(partial[b] <= partial[lead]))
            lead = b;
    return lead;
}

static long leading_entry(const double *x, const double *w, int n)
{
    double most = -1;
    int lead = 0;

    for (int i = 0; i < n && most <= DBL_MAX; i++) {
        const double e = fabs(x[i] * w[i]);
        if (!(e <= most)) {
            most = e <= DBL_MAX ? e : INFINITY;
            lead = i;
        }
    }
    return lead;
}

static double finish(enum vector_norm norm, const double *partial, long count, long n, long lead)
{
    double sum = 0;

    if (norm == VECTOR_NORM_MAX)
        return partial[lead];
    for (long b = 0; b < count; b++)
        sum += partial[b];
    return norm == VECTOR_NORM_P8 ? pow(sum / (double)n, 0.125) : sqrt(sum / (double)n);
}

static sunrealtype error_norm(N_Vector v, N_Vector weight)
{
    struct family *f = content(v)->family;
    const double *x = vector_data(v), *w = vector_data(weight);
    const long n = length(v), count = vector_blocks(n);
    double norm;
    long lead, at;

    if (n == 0)
        return 0;
#pragma omp parallel for schedule(static) if (n > VECTOR_LONG)
    for (long b = 0; b < count; b++) {
        const long from = b * VECTOR_BLOCK;
        f->partial[b] = block_norms[f->norm](x + from, w + from, vector_block_size(n, b));
    }
    lead = leading_block(f->partial, count);
    at = lead * VECTOR_BLOCK;
    f->largest = at + leading_entry(x + at, w + at, vector_block_size(n, lead));
    norm = finish(f->norm, f->partial, count, n, lead);
    return norm <= VECTOR_NOT_FINITE ? norm : VECTOR_NOT_FINITE;
}

long vector_largest(N_Vector v)
{
    return content(v)->family->largest;
}

/* --- life ---------------------------------------------------------------- */

static void leave(struct family *f)
{
    if (--f->members > 0)
        return;
    free(f->partial);
    free(f);
}

static void destroy(N_Vector v)
{
    struct content *c = v->content;

    if (c) {
        leave(c->family);
        free(c->serial.data);
        free(c);
    }
    v->content = NULL;
    N_VFreeEmpty(v);
}

/* Zeroes by all threads: each gets its part into memory near it. */
static bool fill(N_Vector v, long n, struct family *f)
{
    struct content *c = calloc(1, sizeof *c);
    const size_t bytes = ((size_t)(n > 0 ? n : 1) * sizeof(double) + 63) / 64 * 64;

    v->content = c;
    if (!c)
        return false;
    c->serial.length = n;
    c->serial.data = aligned_alloc(64, bytes);
    c->family = f;
    f->members++;
    if (c->serial.data)
        constant(0, v);
    return c->serial.data;
}

static N_Vector clone(N_Vector v)
{
    N_Vector w = N_VNewEmpty(v->sunctx);

    if (!w)
        return NULL;
    if (N_VCopyOps(v, w) != 0 || !fill(w, length(v), content(v)->family)) {
        destroy(w);
        return NULL;
    }
    return w;
}

static void replace_operations(N_Vector v)
{
    v->ops->nvclone = clone;
    v->ops->nvdestroy = destroy;
    v->ops->nvlinearcombination = linear_combination;
    v->ops->nvlinearsum = linear_sum;
    v->ops->nvscale = scale;
    v->ops->nvconst = constant;
    v->ops->nvwrmsnorm = error_norm;
}

/* v, an empty serial vector, becomes one of ours with n entries. */
static bool adopt(N_Vector v, long n, struct family *f)
{
    free(v->content);
    v->content = NULL;
    replace_operations(v);
    f->partial = status_alloc((unsigned long)vector_blocks(n), sizeof *f->partial);
    return f->partial && fill(v, n, f);
}

N_Vector vector_create(long n, enum vector_norm norm, SUNContext context)
{
    struct family *f = status_alloc(1, sizeof *f);
    N_Vector v = f ? N_VNewEmpty_Serial(0, context) : NULL;

    if (!f)
        return NULL;
    *f = (struct family){ .norm = norm, .largest = -1, .members = 1 };
    if (!v || !adopt(v, n, f)) {
        status_fail(STATUS_FAILED, "out of memory: a vector of %ld numbers cannot be had; use "
                                   "fewer particles (a larger spacing)", n);
        if (v)
            destroy(v);
        v = NULL;
    }
    leave(f); /* from now on only vectors keep it */
    return v;
}
