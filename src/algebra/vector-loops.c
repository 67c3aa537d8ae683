/* vector-loops.c -- loops over y, block by block, that any room may use. */
#include "algebra/vector-private.h"

#include "base/threads.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Terms that one pass adds up: more passes wait longer for memory. */
enum { TOGETHER = 6 };

/* to = unit + (c[0] x[0] + c[1] x[1] + ...), for a constant number of terms: written
 * out, as a loop over them stays a loop inside of the other. */
static inline __attribute__((always_inline)) void
add_up(int terms, const double *c, const double *const *x, const double *unit, int n, double *to)
{
    const double *const x0 = x[0], *const x1 = x[terms > 1 ? 1 : 0],
                 *const x2 = x[terms > 2 ? 2 : 0], *const x3 = x[terms > 3 ? 3 : 0],
                 *const x4 = x[terms > 4 ? 4 : 0], *const x5 = x[terms > 5 ? 5 : 0];
    const double c0 = c[0], c1 = c[terms > 1 ? 1 : 0], c2 = c[terms > 2 ? 2 : 0],
                 c3 = c[terms > 3 ? 3 : 0], c4 = c[terms > 4 ? 4 : 0], c5 = c[terms > 5 ? 5 : 0];

#pragma omp simd
    for (int i = 0; i < n; i++) {
        double sum = c0 * x0[i];

        sum = terms > 1 ? sum + c1 * x1[i] : sum;
        sum = terms > 2 ? sum + c2 * x2[i] : sum;
        sum = terms > 3 ? sum + c3 * x3[i] : sum;
        sum = terms > 4 ? sum + c4 * x4[i] : sum;
        sum = terms > 5 ? sum + c5 * x5[i] : sum;
        to[i] = unit ? unit[i] + sum : sum;
    }
}

typedef void add_up_terms(const double *c, const double *const *x, const double *unit, int n,
                          double *to);

#define ADD_UP(name, terms, target)                                                        \
    static target void name(const double *c, const double *const *x, const double *unit,   \
                            int n, double *to)                                             \
    {                                                                                      \
        if (unit)                                                                          \
            add_up(terms, c, x, unit, n, to);                                              \
        else                                                                               \
            add_up(terms, c, x, NULL, n, to);                                              \
    }

/* For one instruction set: together_NAME[terms]. */
#define ADD_UPS(name, target)                                                              \
    ADD_UP(add_up_1_##name, 1, target)                                                     \
    ADD_UP(add_up_2_##name, 2, target)                                                     \
    ADD_UP(add_up_3_##name, 3, target)                                                     \
    ADD_UP(add_up_4_##name, 4, target)                                                     \
    ADD_UP(add_up_5_##name, 5, target)                                                     \
    ADD_UP(add_up_6_##name, 6, target)                                                     \
    static add_up_terms *const together_##name[TOGETHER + 1] = {                           \
        NULL,            add_up_1_##name, add_up_2_##name, add_up_3_##name,                \
        add_up_4_##name, add_up_5_##name, add_up_6_##name                                  \
    };

ADD_UPS(narrow, )
#ifdef VECTOR_WIDE
ADD_UPS(wide, VECTOR_WIDE)
#define TOGETHER_WIDE together_wide
#else
#define TOGETHER_WIDE together_narrow
#endif

bool vector_wide(void)
{
#ifdef VECTOR_WIDE
    const char *lanes = getenv("STIFFWATER_LANES");

    return __builtin_cpu_supports("avx2") && !(lanes && strcmp(lanes, "2") == 0);
#else
    return false;
#endif
}

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

void vector_add_up(bool wide, const double *unit, int terms, const double *c,
                   const double *const *x, long from, int n, double *to)
{
    add_up_terms *const *together = wide ? TOGETHER_WIDE : together_narrow;
    const double *part[VECTOR_TERMS], *first = unit ? unit + from : NULL;

    for (int k = 0; k < terms; k++)
        part[k] = x[k] + from;
    if (terms > 0 && terms <= TOGETHER)
        together[terms](c, part, first, n, to + from);
    else
        add_up_many(terms, c, part, first, n, to + from);
}

/* Blocks of this thread. */
static void combine_blocks(const double *unit, int terms, const double *c,
                           const double *const *x, long n, double *to)
{
    const bool wide = vector_wide();

#pragma omp for schedule(static) nowait
    for (long b = 0; b < vector_blocks(n); b++)
        vector_add_up(wide, unit, terms, c, x, b * VECTOR_BLOCK, vector_block_size(n, b), to);
}

void vector_combine(int terms, const double *c, const double *const *x, long n, double *to)
{
    const int unit = terms > 1 && c[0] == 1; /* x[0] is added last */
    const double *xk[VECTOR_TERMS];
    double ck[VECTOR_TERMS];
    int m = 0;

    for (int k = unit; k < terms; k++)
        if (c[k] != 0) {
            ck[m] = c[k];
            xk[m++] = x[k];
        }
    THREADS(n > VECTOR_LONG, combine_blocks(unit ? x[0] : NULL, m, ck, xk, n, to));
}

static void copy_blocks(long n, const double *x, double *to)
{
#pragma omp for schedule(static) nowait
    for (long b = 0; b < vector_blocks(n); b++)
        memcpy(to + b * VECTOR_BLOCK, x + b * VECTOR_BLOCK,
               (size_t)vector_block_size(n, b) * sizeof *x);
}

void vector_copy(long n, const double *x, double *to)
{
    THREADS(n > VECTOR_LONG, copy_blocks(n, x, to));
}

void vector_own_copy(const struct vector_family *f, const double *x, double *to)
{
    long from = 0, end;

    for (; vector_piece(f, &from, f->n, &end); from = end)
        vector_copy(end - from, x + from, to + from);
}

static bool block_bad(const double *x, int n)
{
    int bad = 0;

#pragma omp simd reduction(| : bad)
    for (int i = 0; i < n; i++)
        bad |= !(fabs(x[i]) <= DBL_MAX);
    return bad;
}

static void keep_earlier(long *first, long mine)
{
    if (mine < *first)
        *first = mine;
}

/* Where the first bad one of this thread's blocks begins. */
static void look_for_bad(long n, const double *x, long *first)
{
    const struct threads_part part = threads_part((int)vector_blocks(n));
    long b = part.from;

    while (b < part.to && !block_bad(x + b * VECTOR_BLOCK, vector_block_size(n, b)))
        b++;
    if (b < part.to)
        THREADS_IN_TURN(keep_earlier(first, b * VECTOR_BLOCK));
}

long vector_first_bad(long n, const double *x)
{
    long first = n;

    THREADS(n > VECTOR_LONG, look_for_bad(n, x, &first));
    while (first < n && fabs(x[first]) <= DBL_MAX)
        first++;
    return first < n ? first : -1;
}
