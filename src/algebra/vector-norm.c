/* vector-norm.c -- the norms of error tests, with the sum that is asked about done in
 * the same pass. */
#include "algebra/vector-private.h"

#include "base/threads.h"
#include "ranks/ranks.h"

#include <float.h>
#include <math.h>

/* Largest e_i, infinite when one is not finite.  A maximum does not depend on
 * the order, so the compiler may take several at once. */
static inline __attribute__((always_inline)) double block_max(const double *x, const double *w,
                                                              int n)
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

static inline __attribute__((always_inline)) double power(double e, int eighth)
{
    const double e2 = e * e, e4 = e2 * e2;

    return eighth ? e4 * e4 : e2;
}

/* Four sums, whatever the registers hold. */
static inline __attribute__((always_inline)) double
block_sum(const double *x, const double *w, int n, int eighth)
{
    double sum[4] = { 0 };
    int i = 0;

    for (; i + 4 <= n; i += 4)
        for (int k = 0; k < 4; k++)
            sum[k] += power(x[i + k] * w[i + k], eighth);
    for (int k = 0; i + k < n; k++)
        sum[k] += power(x[i + k] * w[i + k], eighth);
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

typedef double block_norm(const double *x, const double *w, int n);

/* For one instruction set: norms_NAME[norm]. */
#define NORMS(name, target)                                                                \
    static target double block_max_##name(const double *x, const double *w, int n)         \
    {                                                                                      \
        return block_max(x, w, n);                                                         \
    }                                                                                      \
    static target double block_p8_##name(const double *x, const double *w, int n)          \
    {                                                                                      \
        return block_sum(x, w, n, 1);                                                      \
    }                                                                                      \
    static target double block_square_##name(const double *x, const double *w, int n)      \
    {                                                                                      \
        return block_sum(x, w, n, 0);                                                      \
    }                                                                                      \
    static block_norm *const norms_##name[] = {                                            \
        [VECTOR_NORM_MAX] = block_max_##name,                                              \
        [VECTOR_NORM_P8] = block_p8_##name,                                                \
        [VECTOR_NORM_WRMS] = block_square_##name                                           \
    };

NORMS(narrow, )
#ifdef VECTOR_WIDE
NORMS(wide, VECTOR_WIDE)
#define NORMS_WIDE norms_wide
#else
#define NORMS_WIDE norms_narrow
#endif

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

/* The largest of all ranks, and where: an infinite one is beyond all others.  Both in one message;
 * other: NULL, there is one. */
static void hear_others(const struct vector_family *f, struct vector_store *one,
                        struct vector_store *other)
{
    struct vector_store *store[RANKS_FIRSTS] = { one, other };
    struct {
        double norm;
        long largest;
    } most[RANKS_FIRSTS];
    double key[RANKS_FIRSTS];
    long order[RANKS_FIRSTS];
    const int n = other ? 2 : 1;
    int rank[RANKS_FIRSTS];

    for (int i = 0; i < n; i++) {
        key[i] = -fmin(store[i]->norm, DBL_MAX);
        order[i] = store[i]->largest;
        most[i].norm = store[i]->norm;
        most[i].largest = store[i]->largest;
    }
    ranks_firsts(n, key, order, most, sizeof *most, rank);
    for (int i = 0; i < n; i++) {
        store[i]->norm = most[i].norm;
        store[i]->largest = f->own.pieces > 0 ? f->own.here(f->own.self, most[i].largest)
                                              : most[i].largest;
    }
}

/* Keeps what the norm of a vector is here, from the shares of its blocks. */
static void conclude(const struct vector_content *v, const struct vector_store *weight,
                     const double *partial)
{
    const struct vector_family *f = v->family;
    const long count = vector_blocks(f->n), lead = leading_block(partial, count);
    const long at = lead * VECTOR_BLOCK;
    struct vector_store *s = v->store;
    double x[VECTOR_BLOCK], w[VECTOR_BLOCK];

    s->norm = finish(f->norm, partial, count, f->n, lead);
    s->by = weight->written;
    if (f->own.pieces > 0) {
        s->largest = vector_own_leading(f, s->data, weight->data, partial, lead);
        return;
    }
    s->largest = at + leading_entry(vector_in_order(f, s->data, lead, x),
                                    vector_in_order(f, weight->data, lead, w),
                                    vector_block_size(f->n, lead));
    if (f->order)
        s->largest = f->order[s->largest];
}

static bool known(const struct vector_content *v, const struct vector_store *weight)
{
    return v->outside == VECTOR_HERE && v->store->by == weight->written;
}

/* The norm is a maximum where a rank has a part of y. */
static double share_here(const struct vector_content *v, const struct vector_store *weight, long b)
{
    const struct vector_family *f = v->family;
    block_norm *const norm = (f->wide ? NORMS_WIDE : norms_narrow)[VECTOR_NORM_MAX];
    const long to = b * VECTOR_BLOCK + vector_block_size(f->n, b);
    long from = b * VECTOR_BLOCK, end;
    double most = 0;

    for (; vector_piece(f, &from, to, &end); from = end)
        most = fmax(most, norm(v->store->data + from, weight->data + from, (int)(end - from)));
    return most;
}

static double share(const struct vector_content *v, const struct vector_store *weight, long b)
{
    const struct vector_family *f = v->family;
    block_norm *const *norms = f->wide ? NORMS_WIDE : norms_narrow;
    double x[VECTOR_BLOCK], w[VECTOR_BLOCK];

    if (f->own.pieces > 0)
        return share_here(v, weight, b);
    return norms[f->norm](vector_in_order(f, v->store->data, b, x),
                          vector_in_order(f, weight->data, b, w), vector_block_size(f->n, b));
}

static void measure_blocks(struct vector_content *v, struct vector_content *other,
                           const struct vector_store *weight, bool later)
{
    const struct vector_family *f = v->family;
    const long count = vector_blocks(f->n);

#pragma omp for schedule(static) nowait
    for (long b = 0; b < count; b++) {
        if (later)
            vector_sum_block(v, b);
        f->partial[b] = share(v, weight, b);
        if (other) {
            vector_sum_block(other, b);
            f->partial[count + b] = share(other, weight, b);
        }
    }
}

/* v and, where it is not NULL, another one that reads the same stores: what is put
 * off is done block by block, so that a block is read once for both. */
static void measure(struct vector_content *v, struct vector_content *other,
                    const struct vector_store *weight)
{
    const struct vector_family *f = v->family;
    const long count = vector_blocks(f->n);
    const bool later = v->outside == VECTOR_LATER;

    THREADS(f->n > VECTOR_LONG, measure_blocks(v, other, weight, later));
    if (later)
        vector_summed(v);
    conclude(v, weight, f->partial);
    if (other) {
        vector_summed(other);
        conclude(other, weight, f->partial + count);
    }
    hear_others(f, v->store, other ? other->store : NULL);
}

static bool has(const struct vector_sum *s, const struct vector_store *x)
{
    for (int k = 0; k < s->terms; k++)
        if (s->x[k] == x)
            return true;
    return false;
}

/* A result of a step beside its error: a sum put off that starts from a state and
 * reads all that v does. */
static struct vector_content *companion(const struct vector_content *v)
{
    const struct vector_family *f = v->family;

    for (int k = 0; k < f->sums && v->outside == VECTOR_LATER; k++) {
        struct vector_content *c = f->put_off[k];
        bool all = c != v && c->sum.unit;
        for (int i = 0; i < v->sum.terms && all; i++)
            all = has(&c->sum, v->sum.x[i]);
        if (all)
            return c;
    }
    return NULL;
}

sunrealtype vector_norm_weighted(N_Vector of, N_Vector weight)
{
    struct vector_content *v = vector_content(of), *w = vector_content(weight);
    const struct vector_store *s = v->store;

    if (v->family->n == 0)
        return 0;
    vector_settle(w);
    if (v->outside == VECTOR_ZERO || v->family->order) /* a sum's blocks are as it stands */
        vector_settle(v);
    if (!known(v, w->store))
        measure(v, companion(v), w->store);
    v->family->largest = s->largest;
    return s->norm <= VECTOR_NOT_FINITE ? s->norm : VECTOR_NOT_FINITE;
}

long vector_largest(N_Vector v)
{
    return vector_content(v)->family->largest;
}
