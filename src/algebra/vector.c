/* vector.c -- the operations of a step: blocked, threaded, with fixed bits. */
#include "algebra/vector.h"

#include "base/status.h"
#include <float.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdlib.h>
#include <string.h>

enum {
    BLOCK = 1024,    /* entries whose partial results belong together        */
    LONG_ONE = 20000 /* from this length on a second thread pays             */
};

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

static long blocks(long n)
{
    return (n + BLOCK - 1) / BLOCK;
}

static int block_size(long n, long b)
{
    return n - b * BLOCK < BLOCK ? (int)(n - b * BLOCK) : BLOCK;
}

/* --- linear combinations ------------------------------------------------- */

static void combine_block(int terms, const double *c, const double *const *x, long from, int n,
                          double *to)
{
    const int unit = terms > 1 && c[0] == 1; /* x[0] is added last */
    double sum[BLOCK];

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
#pragma omp parallel for schedule(static) if (n > LONG_ONE)
    for (long b = 0; b < blocks(n); b++)
        combine_block(terms, c, x, b * BLOCK, block_size(n, b), to);
}

void vector_copy(long n, const double *x, double *to)
{
#pragma omp parallel for schedule(static) if (n > LONG_ONE)
    for (long b = 0; b < blocks(n); b++)
        memcpy(to + b * BLOCK, x + b * BLOCK, (size_t)block_size(n, b) * sizeof *x);
}

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

#pragma omp parallel for schedule(static) if (n > LONG_ONE)
    for (long b = 0; b < blocks(n); b++)
        for (int i = 0; i < block_size(n, b); i++)
            to[b * BLOCK + i] = c;
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
    const long n = length(v), count = blocks(n);
    double norm;
    long lead;

    if (n == 0)
        return 0;
#pragma omp parallel for schedule(static) if (n > LONG_ONE)
    for (long b = 0; b < count; b++)
        f->partial[b] = block_norms[f->norm](x + b * BLOCK, w + b * BLOCK, block_size(n, b));
    lead = leading_block(f->partial, count);
    f->largest = lead * BLOCK
               + leading_entry(x + lead * BLOCK, w + lead * BLOCK, block_size(n, lead));
    norm = finish(f->norm, f->partial, count, n, lead);
    return norm <= VECTOR_NOT_FINITE ? norm : VECTOR_NOT_FINITE;
}

long vector_largest(N_Vector v)
{
    return content(v)->family->largest;
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

#pragma omp parallel for schedule(static) reduction(min : first) if (n > LONG_ONE)
    for (long b = 0; b < blocks(n); b++)
        if (b * BLOCK < first && block_bad(x + b * BLOCK, block_size(n, b)))
            first = b * BLOCK;
    while (first < n && fabs(x[first]) <= DBL_MAX)
        first++;
    return first < n ? first : -1;
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
    f->partial = status_alloc((unsigned long)blocks(n), sizeof *f->partial);
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
