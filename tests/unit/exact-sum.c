/* exact-sum.c -- sums that do not depend on the order of their terms, and are exact. */
#include "algebra/exact-sum.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

enum { TERMS = 5000 };

static uint64_t seed = 1;

static uint64_t chance(void)
{
    seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return seed ^ seed >> 31;
}

static long below(long n)
{
    return (long)((chance() >> 16) % (uint64_t)n);
}

/* Any double between 2^-range and 2^range, of either sign. */
static double term(int range)
{
    const double m = 1 + (double)(chance() >> 12) * 0x1p-52;

    return ldexp(chance() >> 40 & 1 ? m : -m, (int)below(2L * range) - range);
}

static double sum_of(long n, const double *x)
{
    struct exact_sum s = { 0 };

    exact_sum_add(&s, n, x);
    return exact_sum_value(&s);
}

/* Bit by bit; any NaN is as good as another. */
static void same(double got, double want)
{
    if (memcmp(&got, &want, sizeof got) != 0 && !(isnan(got) && isnan(want)))
        fail_msg("%.17g (%a) instead of %.17g (%a)", got, got, want, want);
}

/* Against whole numbers of 128 bits, which the compiler rounds. */
static void sums_are_exact(void **state)
{
    static double x[TERMS];

    (void)state;
    for (int times = 0; times < 2000; times++) {
        const int n = 1 + (int)below(times % 10 ? 60 : TERMS), wide = 1 + (int)below(60);
        const int at = (int)below(1900) - 1070;
        __int128 whole = 0;

        for (int i = 0; i < n; i++) {
            const double m = (double)(chance() >> (11 + below(53)));
            x[i] = ldexp(below(2) ? m : -m, (int)below(wide) + at);
        }
        for (int i = 0; i < n / 2 && times % 2; i++) /* nearly all cancels */
            x[n - 1 - i] = -x[i];
        for (int i = 0; i < n; i++)
            whole += (__int128)ldexp(x[i], -at);
        same(sum_of(n, x), ldexp((double)whole, at));
    }
}

/* What is left of many terms is all of one sign, and small terms lie far below. */
static void blocks_have_room(void **state)
{
    enum { MANY = 1024 };
    static double x[MANY];

    (void)state;
    for (int times = 0; times < 3000; times++) {
        const double v = 1 + (double)below(1L << (times % 52 + 1)) * DBL_EPSILON;
        const int few = 1 + (int)below(3);
        __int128 whole = 0;

        for (int i = 0; i < MANY; i++) {
            x[i] = i < MANY - few ? v : ldexp((double)(chance() >> 11), -110 + (int)below(40));
            whole += (__int128)ldexp(x[i], 110);
        }
        same(sum_of(MANY, x), ldexp((double)whole, -110));
        for (int i = 0; i < MANY - few; i++) /* only the small ones stay */
            whole -= (__int128)ldexp(v, 110);
        struct exact_sum s = { 0 };
        exact_sum_add(&s, MANY, x);
        for (int i = 0; i < MANY - few; i++)
            exact_sum_add(&s, 1, (double[]){ -v });
        same(exact_sum_value(&s), ldexp((double)whole, -110));
    }
}

static void shuffle(long n, double *x)
{
    for (long i = n - 1; i > 0; i--) {
        const long k = below(i + 1);
        const double swap = x[i];
        x[i] = x[k];
        x[k] = swap;
    }
}

/* In parts of any length, merged in any way. */
static double in_parts(long n, const double *x)
{
    enum { PARTS = 7 };
    struct exact_sum s[PARTS] = { { { 0 }, 0 } };

    while (n > 0) {
        const long some = 1 + below(n < 1500 ? n : 1500);

        exact_sum_add(&s[below(PARTS)], some, x);
        n -= some;
        x += some;
    }
    for (int k = PARTS - 1; k > 0; k--) {
        struct exact_sum *to = &s[below(k)];

        if (below(2))
            exact_sum_carry(&s[k]);
        exact_sum_merge(to, &s[k]);
    }
    return exact_sum_value(&s[0]);
}

static void order_and_parts_change_nothing(void **state)
{
    static const int ranges[] = { 1, 20, 60, 150, 1020 };
    static double x[TERMS];

    (void)state;
    for (int r = 0; r < 5; r++)
        for (int times = 0; times < 20; times++) {
            double want;

            for (int i = 0; i < TERMS; i++)
                x[i] = below(10) ? term(ranges[r]) : 0;
            want = sum_of(TERMS, x);
            for (int again = 0; again < 5; again++) {
                shuffle(TERMS, x);
                same(sum_of(TERMS, x), want);
                same(in_parts(TERMS, x), want);
            }
        }
}

/* Words may be added one by one, as other machines' are. */
static void words_of_many_add_up(void **state)
{
    enum { MACHINES = 16 };
    static double x[TERMS];
    struct exact_sum all = { 0 }, s;

    (void)state;
    for (int i = 0; i < TERMS; i++)
        x[i] = term(200);
    for (int m = 0; m < MACHINES; m++) {
        const int from = TERMS * m / MACHINES;

        s = (struct exact_sum){ 0 };
        exact_sum_add(&s, TERMS * (m + 1) / MACHINES - from, x + from);
        exact_sum_carry(&s);
        for (int k = 0; k < EXACT_SUM_DIGITS - 1; k++)
            assert_true(s.word[k] >= 0 && s.word[k] <= UINT32_MAX);
        for (int k = 0; k < EXACT_SUM_WORDS; k++)
            all.word[k] += s.word[k];
    }
    same(exact_sum_value(&all), sum_of(TERMS, x));
}

#define SUM(want, ...)                                                                     \
    same(sum_of(sizeof (double[]){ __VA_ARGS__ } / sizeof(double), (double[]){ __VA_ARGS__ }), \
         want)

static void cancelling_leaves_what_is_left(void **state)
{
    (void)state;
    SUM(1.0, 1e300, 1, -1e300);
    SUM(DBL_TRUE_MIN, 1e300, -1, DBL_TRUE_MIN, 1, -1e300);
    SUM(0x1p-1000, 0x1p1023, 0x1p-1000, -0x1p1023);
    SUM(0.0, 1e17, 3.5, -1e17, -3.5);
    SUM(0.0, -0.0, -0.0);
    SUM(-3 * DBL_TRUE_MIN, -DBL_TRUE_MIN, -DBL_TRUE_MIN, -DBL_TRUE_MIN);
    SUM(DBL_MIN - DBL_TRUE_MIN, DBL_MIN, -DBL_TRUE_MIN);
    same(sum_of(0, NULL), 0.0);
}

static void rounding_is_to_nearest_even(void **state)
{
    (void)state;
    SUM(0x1p53, 0x1p53, 1);
    SUM(0x1p53 + 2, 0x1p53, 1, DBL_TRUE_MIN);
    SUM(0x1p53, 0x1p53, 1, -DBL_TRUE_MIN);
    SUM(0x1p53 + 4, 0x1p53, 3);
    SUM(-0x1p53 - 4, -0x1p53, -3);
    SUM(0x1p54, 0x1p54 - 2, 1, 0.5, 0.5);
    SUM(0x1p54, 0x1p54 - 2, 1);
}

static void overflow_is_of_the_sum_alone(void **state)
{
    (void)state;
    SUM(DBL_MAX, DBL_MAX, DBL_MAX, -DBL_MAX);
    SUM((double)INFINITY, DBL_MAX, DBL_MAX);
    SUM(-(double)INFINITY, -DBL_MAX, 0, -DBL_MAX);
    SUM((double)INFINITY, DBL_MAX, 0x1p970);
    SUM(DBL_MAX, DBL_MAX, 0x1p969);
}

static void what_is_not_finite_shows(void **state)
{
    static double x[3000];

    (void)state;
    SUM((double)NAN, 1, NAN, 2);
    SUM((double)NAN, INFINITY, 1, -INFINITY);
    SUM((double)INFINITY, INFINITY, DBL_MAX, -DBL_MAX, INFINITY);
    SUM(-(double)INFINITY, -INFINITY, DBL_MAX, DBL_MAX);
    SUM((double)NAN, NAN, INFINITY);
    for (int times = 0; times < 300; times++) {
        const long bad = below(3000);

        for (int i = 0; i < 3000; i++)
            x[i] = term(40);
        x[bad] = NAN;
        same(in_parts(3000, x), NAN);
        x[bad] = -INFINITY;
        same(in_parts(3000, x), -INFINITY);
        x[bad] = times % 2 ? 1e302 : -DBL_MAX;
        same(in_parts(3000, x), sum_of(3000, x));
    }
}

/* 2^61 terms, by doubling: digits pass on what they cannot hold. */
static void digits_do_not_overflow(void **state)
{
    static const double terms[] = { 1 + DBL_EPSILON, -DBL_TRUE_MIN, -1.9999999999999998e300,
                                    0x1.fffffffffffffp31 };

    (void)state;
    for (int k = 0; k < 4; k++) {
        struct exact_sum s = { 0 };

        exact_sum_add(&s, 1, &terms[k]);
        for (int times = 1; times <= 61; times++) {
            const struct exact_sum twin = s;

            exact_sum_merge(&s, &twin);
            same(exact_sum_value(&s), ldexp(terms[k], times));
        }
    }
}

/* --- time ---------------------------------------------------------------- */

static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

/* The least of several tries [ns a term]. */
static double time_of(int chunk, int range)
{
    enum { TRIES = 30, ROUNDS = 200 };
    static double x[1024];
    struct exact_sum s = { 0 };
    double least = INFINITY;

    for (int i = 0; i < 1024; i++)
        x[i] = term(range);
    for (int k = 0; k < TRIES; k++) {
        const double begun = now();

        for (int round = 0; round < ROUNDS; round++)
            for (int i = 0; i < 1024; i += chunk)
                exact_sum_add(&s, chunk, x + i);
        least = fmin(least, (now() - begun) / (ROUNDS * 1024));
    }
    return least;
}

static void time_is_told(void **state)
{
    (void)state;
    print_message("ns a term, chunks of 128 and 1024: within 10^5 %.2f %.2f, within 10^20 %.2f "
                  "%.2f, within 10^60 %.2f %.2f\n", time_of(128, 8), time_of(1024, 8),
                  time_of(128, 33), time_of(1024, 33), time_of(128, 100), time_of(1024, 100));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_are_exact),
        cmocka_unit_test(blocks_have_room),
        cmocka_unit_test(order_and_parts_change_nothing),
        cmocka_unit_test(words_of_many_add_up),
        cmocka_unit_test(cancelling_leaves_what_is_left),
        cmocka_unit_test(rounding_is_to_nearest_even),
        cmocka_unit_test(overflow_is_of_the_sum_alone),
        cmocka_unit_test(what_is_not_finite_shows),
        cmocka_unit_test(digits_do_not_overflow),
        cmocka_unit_test(time_is_told),
    };

    return cmocka_run_group_tests_name("exact sums", tests, NULL, NULL);
}
