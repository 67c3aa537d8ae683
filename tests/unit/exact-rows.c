/* exact-rows.c -- rows cut at guessed places against sums that look at all terms first. */
#define LANES 2 /* of every machine; exact-rows.h is for files compiled per width */
#include "algebra/exact-rows.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { TERMS = EXACT_ROWS * LANES, TIMES = 3000 };

/* -1 to 1. */
static double chance(void)
{
    static uint64_t seed = 7;

    seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(int64_t)seed * 0x1p-63;
}

static void add_rows(const double *x, struct exact_cut *cut, struct exact_sum *sum)
{
    struct exact_rows rows;

    exact_rows_open(&rows);
    for (int n = 0; n < TERMS; n += LANES)
        exact_rows_add(&rows, (lanes){ x[n], x[n + 1] });
    exact_rows_close(&rows, cut, sum);
}

/* Digits, not only the value, which hides what is small. */
static void same(const struct exact_sum *got, const struct exact_sum *want, int times)
{
    struct exact_sum a = *got, b = *want;

    exact_sum_carry(&a);
    exact_sum_carry(&b);
    if (memcmp(a.word, b.word, sizeof a.word) != 0)
        fail_msg("rows %d: %a instead of %a", times, exact_sum_value(&a), exact_sum_value(&b));
}

/* Terms of 2^-range to 1, times what drifts by 2^drift from rows to rows. */
static void compare(int range, int drift)
{
    struct exact_sum got = { 0 }, want = { 0 };
    struct exact_cut cut = { 0 };
    double x[TERMS], scale = 1;

    for (int times = 0; times < TIMES; times++) {
        for (int n = 0; n < TERMS; n++)
            x[n] = ldexp(scale * chance(), -(int)(range * fabs(chance())));
        scale = ldexp(1, (int)(drift * chance()));
        add_rows(x, &cut, &got);
        exact_sum_add(&want, TERMS, x);
        same(&got, &want, times);
    }
}

static void rows_lose_no_bit(void **state)
{
    (void)state;
    compare(0, 0);
    compare(30, 4);
    compare(200, 0);
    compare(5, 300);
    compare(1040, 1000);
}

static void odd_rows_are_kept(void **state)
{
    static const double odd[] = { NAN, INFINITY, -INFINITY, 1.7e308, 4.9e-324, 0 };

    (void)state;
    for (size_t k = 0; k < sizeof odd / sizeof *odd; k++) {
        struct exact_sum got = { 0 }, want = { 0 };
        struct exact_cut cut = { 0 };
        double x[TERMS] = { 1, 2, 3 };

        for (int times = 0; times < 3; times++, x[5] = odd[k]) {
            add_rows(x, &cut, &got);
            exact_sum_add(&want, TERMS, x);
            same(&got, &want, times);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_lose_no_bit),
        cmocka_unit_test(odd_rows_are_kept),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
