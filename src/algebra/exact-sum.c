/* exact-sum.c -- long fixed-point numbers, filled a block of terms at a time.
 *
 * Adding c = 1.5 2^(52 + g) and taking it off again rounds a term to a multiple of 2^g,
 * and what is left of it is exact.  g is chosen so that the rounded parts of a whole
 * block add up without rounding, in any order; then only their sum, a double, goes to
 * the digits.  What is left is cut again, 2^44 times finer (Demmel and Nguyen, "Fast
 * reproducible floating-point summation", 2013, but until nothing is left; the digits
 * are the small superaccumulator of Neal, "Fast exact summation", 2015). */
#include "algebra/exact-sum.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

static const double beyond = 0x1p1000; /* c has no room above such terms       */

enum {
    BLOCK = 1024,          /* terms                                            */
    FIRST = 52 - 10,       /* g below the exponent of the largest term: BLOCK parts
                              add up to less than 2^(g + 53)                   */
    NEXT = 54 - 10,        /* the next g below it: what is left is 2^(g - 1) at most */
    BIAS = 1023,           /* of a double's exponent                           */
    LEAST = -1074,         /* exponent of the least double                     */
    HEADROOM = 64,         /* of terms of the next rows over those of the last */
    FULL = 1 << 29         /* additions to a digit that are safe               */
};

typedef unsigned __int128 wide;

/* --- digits -------------------------------------------------------------- */

static uint64_t bits_of(double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    return bits;
}

void exact_sum_carry(struct exact_sum *s)
{
    for (int k = 0; k + 1 < EXACT_SUM_DIGITS; k++) {
        s->word[k + 1] += s->word[k] >> 32;
        s->word[k] &= UINT32_MAX;
    }
    s->full = 1;
}

static void add_one(struct exact_sum *s, double x)
{
    const uint64_t bits = bits_of(x), mantissa = bits & ((UINT64_C(1) << 52) - 1);
    const int exponent = (int)(bits >> 52 & 0x7ff), normal = exponent > 0;
    const int at = exponent - normal; /* 2^at times the least double is bit 0 */
    const int64_t sign = bits >> 63 ? -1 : 1;
    const wide m = (wide)(mantissa | (uint64_t)normal << 52) << (at & 31);
    int64_t *to = s->word + (at >> 5);

    if (exponent == 0x7ff) {
        s->word[mantissa ? EXACT_SUM_NAN : sign > 0 ? EXACT_SUM_PLUS : EXACT_SUM_MINUS]++;
        return;
    }
    if (s->full >= FULL)
        exact_sum_carry(s);
    s->full++;
    to[0] += sign * (int64_t)(m & UINT32_MAX);
    to[1] += sign * (int64_t)(m >> 32 & UINT32_MAX);
    to[2] += sign * (int64_t)(m >> 64);
}

void exact_sum_merge(struct exact_sum *to, const struct exact_sum *from)
{
    if (to->full + from->full >= FULL)
        exact_sum_carry(to);
    for (int k = 0; k < EXACT_SUM_WORDS; k++)
        to->word[k] += from->word[k];
    to->full += from->full;
}

/* --- blocks -------------------------------------------------------------- */

/* What the constants of a block cut off, one after the other. */
struct cut {
    double c[3], part[3];
    bool left;             /* something is left of a term                      */
};

static inline __attribute__((always_inline)) double largest(const double *x, int n)
{
    double most = 0;

#pragma omp simd reduction(max : most)
    for (int i = 0; i < n; i++) {
        const double e = fabs(x[i]);
        most = e > most ? e : most;
    }
    return most;
}

/* No sum of parts rounds, so the compiler may take any number of them at once. */
static inline __attribute__((always_inline)) void cut_twice(const double *x, int n,
                                                            struct cut *cut, double *left)
{
    const double c0 = cut->c[0], c1 = cut->c[1];
    double high = 0, low = 0, rest = 0;

#pragma omp simd reduction(+ : high, low, rest)
    for (int i = 0; i < n; i++) {
        const double part = (x[i] + c0) - c0, finer = x[i] - part;
        const double next = (finer + c1) - c1;

        high += part;
        low += next;
        left[i] = finer - next;
        rest += fabs(finer - next);
    }
    cut->part[0] = high;
    cut->part[1] = low;
    cut->left = rest > 0;
}

static inline __attribute__((always_inline)) void cut_once(int n, struct cut *cut, double *left)
{
    const double c = cut->c[2];
    double sum = 0, rest = 0;

#pragma omp simd reduction(+ : sum, rest)
    for (int i = 0; i < n; i++) {
        const double part = (left[i] + c) - c;

        sum += part;
        left[i] -= part;
        rest += fabs(left[i]);
    }
    cut->part[2] = sum;
    cut->left = rest > 0;
}

/* 1.5 2^e of a normal number, by its bits: ldexp() would cost as much as cutting. */
static double one_and_a_half(int e)
{
    const uint64_t bits = (uint64_t)(e + BIAS) << 52 | UINT64_C(1) << 51;
    double x;

    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Exponents of parts: 2^g and finer.  Terms that are all subnormal have exponent -BIAS
 * here, which is below theirs, but then g is LEAST anyhow. */
static void choose(double most, struct cut *cut)
{
    int g = (int)(bits_of(most) >> 52) - BIAS - FIRST;

    for (int k = 0; k < 3; k++, g -= NEXT)
        cut->c[k] = one_and_a_half(52 + (g > LEAST ? g : LEAST));
}

/* The block's parts (NaN, if a term is) and what is left of its terms; false: to be
 * added one by one. */
static inline __attribute__((always_inline)) bool cut_up(const double *x, int n, struct cut *cut,
                                                         double *left)
{
    const double most = largest(x, n);

    *cut = (struct cut){ .left = false };
    if (most >= beyond)
        return false;
    if (most > 0)
        choose(most, cut);
    cut_twice(x, n, cut, left);
    if (cut->left)
        cut_once(n, cut, left);
    return true;
}

typedef bool cut_block(const double *x, int n, struct cut *cut, double *left);

static bool cut_narrow(const double *x, int n, struct cut *cut, double *left)
{
    return cut_up(x, n, cut, left);
}

#if defined __x86_64__ && defined __GNUC__
static __attribute__((target("avx2"))) bool cut_wide(const double *x, int n, struct cut *cut,
                                                     double *left)
{
    return cut_up(x, n, cut, left);
}

static cut_block *cut_best(void)
{
    return __builtin_cpu_supports("avx2") ? cut_wide : cut_narrow;
}
#else
static cut_block *cut_best(void)
{
    return cut_narrow;
}
#endif

void exact_sum_terms(struct exact_sum *s, int n, const double *x)
{
    for (int i = 0; i < n; i++)
        if (x[i] != 0)
            add_one(s, x[i]);
}

void exact_sum_add(struct exact_sum *s, long n, const double *x)
{
    cut_block *const cut_them = cut_best();
    double left[BLOCK];

    for (; n > 0; n -= BLOCK, x += BLOCK) {
        const int size = n < BLOCK ? (int)n : BLOCK;
        struct cut cut;

        if (!cut_them(x, size, &cut, left)) {
            exact_sum_terms(s, size, x);
            continue;
        }
        exact_sum_terms(s, 3, cut.part);
        if (cut.left)
            exact_sum_terms(s, size, left);
    }
}

/* --- rows ---------------------------------------------------------------- */

void exact_sum_choose(struct exact_cut *cut, double most)
{
    struct cut at;

    if (!(most > 0) || most >= beyond / HEADROOM)
        return;
    choose(HEADROOM * most, &at);
    *cut = (struct exact_cut){ at.c[0], at.c[1], HEADROOM * most };
}

/* --- the value ----------------------------------------------------------- */

/* The digits from `high` down, rounded once; they are not negative. */
static double rounded(const int64_t *digit, int high)
{
    bool more = false; /* below the three highest */
    wide m = 0;

    for (int k = high; k > high - 3; k--)
        m = m << 32 | (uint64_t)(k >= 0 ? digit[k] : 0);
    for (int k = 0; k <= high - 3; k++)
        more |= digit[k] != 0;
    const int drop = 64 - __builtin_clzll((uint64_t)(m >> 64)) + 64 - 53;
    const wide rest = m & (((wide)1 << drop) - 1), half = (wide)1 << (drop - 1);
    uint64_t q = (uint64_t)(m >> drop);
    q += rest > half || (rest == half && (more || q & 1));
    return ldexp((double)q, drop + 32 * (high - 2) + LEAST);
}

double exact_sum_value(const struct exact_sum *s)
{
    struct exact_sum sum = *s;
    int high = EXACT_SUM_DIGITS - 1;
    double sign = 1;

    if (s->word[EXACT_SUM_NAN] || (s->word[EXACT_SUM_PLUS] && s->word[EXACT_SUM_MINUS]))
        return NAN;
    if (s->word[EXACT_SUM_PLUS] || s->word[EXACT_SUM_MINUS])
        return s->word[EXACT_SUM_PLUS] ? INFINITY : -INFINITY;
    exact_sum_carry(&sum);
    if (sum.word[high] < 0) {
        sign = -1;
        for (int k = 0; k < EXACT_SUM_DIGITS; k++)
            sum.word[k] = -sum.word[k];
        exact_sum_carry(&sum);
    }
    while (high >= 0 && sum.word[high] == 0)
        high--;
    return high < 0 ? 0 : sign * rounded(sum.word, high);
}
