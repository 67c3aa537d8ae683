/* band.c -- tests of src/algebra/band: banded matrices against dense arithmetic. */
#include "algebra/band.h"
#include "base/status.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>

enum { MOST = 40 };

static double noise(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 8) / 8388608.0 - 1;
}

static struct band *made(int n, int half)
{
    struct band *b = NULL;

    assert_int_equal(band_create(n, half, &b), STATUS_DONE);
    return b;
}

/* Random entries, `diagonal` added to the main one. */
static struct band *filled(int n, int half, double diagonal, unsigned seed)
{
    struct band *b = made(n, half);

    for (int i = 0; i < n; i++)
        for (int j = i; j >= 0 && j >= i - half; j--)
            band_add(b, i, j, noise(&seed) + (i == j ? diagonal : 0));
    return b;
}

static void check_close(double found, double expected, double tolerance, const char *what)
{
    if (!(fabs(found - expected) <= tolerance))
        fail_msg("%s: found %.17g, expected %.17g within %g", what, found, expected, tolerance);
}

static void entries_are_kept_once_for_both_sides(void **state)
{
    struct band *b = made(5, 2);

    (void)state;
    band_add(b, 1, 3, 2);
    band_add(b, 3, 1, 0.5);
    band_add(b, 4, 4, 7);
    check_close(band_at(b, 3, 1), 2.5, 0, "(3, 1)");
    check_close(band_at(b, 1, 3), 2.5, 0, "(1, 3)");
    check_close(band_at(b, 4, 4), 7, 0, "(4, 4)");
    check_close(band_at(b, 0, 3), 0, 0, "outside the band");
    band_free(&b);
    assert_null(b);
    band_free(&b);
}

static void product_and_form_are_those_of_the_dense_matrix(void **state)
{
    (void)state;
    for (int half = 0; half <= 4; half++) {
        const int n = 9;
        struct band *b = filled(n, half, 0, 3u + (unsigned)half);
        double x[MOST], y[MOST], form = 0;
        unsigned seed = 11;
        for (int i = 0; i < n; i++)
            x[i] = noise(&seed);
        band_multiply(b, x, y);
        for (int i = 0; i < n; i++) {
            double sum = 0;
            for (int j = 0; j < n; j++)
                sum += band_at(b, i, j) * x[j];
            check_close(y[i], sum, 1e-14, "B x");
            form += x[i] * sum;
        }
        check_close(band_form(b, x), form, 1e-14, "x . B x");
        band_free(&b);
    }
}

/* Residual of B x = r with known r; says whether Cholesky had to give way. */
static void check_solve(int n, int half, double diagonal, bool definite)
{
    struct band *b = filled(n, half, diagonal, 77u);
    struct band_factor *f = NULL;
    double r[MOST], x[MOST], back[MOST];
    unsigned seed = 5;

    assert_int_equal(band_factor_create(n, half, &f), STATUS_DONE);
    assert_int_equal(band_factor_definite(f, b), definite);
    assert_int_equal(band_factor_set(f, b), STATUS_DONE);
    for (int i = 0; i < n; i++)
        r[i] = x[i] = noise(&seed);
    band_factor_solve(f, x);
    band_multiply(b, x, back);
    for (int i = 0; i < n; i++)
        check_close(back[i], r[i], 1e-11, "B x - r");
    band_factor_free(&f);
    assert_null(f);
    band_free(&b);
}

static void solves_by_cholesky(void **state)
{
    (void)state;
    for (int half = 0; half <= 5; half++)
        for (int n = 1; n <= MOST; n += 3)
            check_solve(n, half, 2.0 * half + 2, true);
}

static void solves_by_lu_what_is_not_definite(void **state)
{
    (void)state;
    for (int half = 1; half <= 5; half++)
        for (int n = 2; n <= MOST; n += 3)
            check_solve(n, half, -2.0 * half - 2, false);
    check_solve(12, 3, 0.1, false); /* needs row exchanges */
}

/* Against products of both halves: (b + s) x with s(i, j) = -s(j, i), no diagonal. */
static void solves_what_is_not_symmetric(void **state)
{
    enum { N = 15, HALF = 3 };
    struct band *b = filled(N, HALF, 1, 5), *s = filled(N, HALF, 8, 6);
    struct band_factor *f = NULL;
    double x[N], r[N], back[N];
    unsigned seed = 2;

    (void)state;
    for (int i = 0; i < N; i++)
        x[i] = r[i] = noise(&seed);
    assert_int_equal(band_factor_create(N, HALF, &f), STATUS_DONE);
    assert_int_equal(band_factor_set_skew(f, b, s), STATUS_DONE);
    band_factor_solve(f, x);
    band_multiply(b, x, back);
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++)
            back[i] += (i > j) * band_at(s, i, j) * x[j] - (i < j) * band_at(s, i, j) * x[j];
        check_close(back[i], r[i], 1e-11, "(b + s) x - r");
    }
    band_factor_free(&f);
    band_free(&b);
    band_free(&s);
}

static void nothing_times_nothing_is_harmless(void **state)
{
    struct band *b = made(0, 3);
    struct band_factor *f = NULL;
    double x = 42;

    (void)state;
    assert_int_equal(band_factor_create(0, 3, &f), STATUS_DONE);
    assert_int_equal(band_factor_set(f, b), STATUS_DONE);
    band_factor_solve(f, &x);
    band_multiply(b, &x, &x);
    check_close(band_form(b, &x), 0, 0, "form");
    check_close(x, 42, 0, "untouched");
    band_factor_free(&f);
    band_free(&b);
}

static void singular_and_nan_are_refused_not_aborted(void **state)
{
    struct band *b = made(4, 1);
    struct band_factor *f = NULL;

    (void)state;
    status_clear();
    assert_int_equal(band_factor_create(4, 1, &f), STATUS_DONE);
    assert_int_equal(band_factor_set(f, b), STATUS_FAILED);
    assert_true(status_message()[0] != '\0');
    for (int i = 0; i < 4; i++)
        band_add(b, i, i, i == 2 ? NAN : 1);
    assert_int_equal(band_factor_set(f, b), STATUS_FAILED);
    status_clear();
    band_factor_free(&f);
    band_free(&b);
}

static void held_unknown_stands_alone(void **state)
{
    struct band *b = filled(6, 3, 9, 21u);

    (void)state;
    band_hold(b, 2, 1.5);
    for (int j = 0; j < 6; j++)
        check_close(band_at(b, 2, j), j == 2 ? 1.5 : 0, 0, "row of a held unknown");
    assert_true(band_at(b, 1, 3) != 0);
    band_free(&b);
}

static void sum_and_blocks_add_up(void **state)
{
    const double e[9] = { 1, 2, 3, 2, 4, 5, 3, 5, 6 };
    struct band *a = made(5, 2), *b = made(5, 2), *to = made(5, 2);

    (void)state;
    band_add_block(a, 0, 3, e);
    band_add_block(a, 2, 3, e);
    band_add_block(b, 1, 3, e);
    check_close(band_at(a, 2, 2), 7, 0, "overlap of two blocks");
    check_close(band_at(a, 2, 0), 3, 0, "corner of the first");
    check_close(band_at(a, 4, 3), 5, 0, "last row of the second");
    band_sum(to, 2, a, -3, b);
    for (int i = 0; i < 5; i++)
        for (int j = 0; j <= i; j++)
            check_close(band_at(to, i, j), 2 * band_at(a, i, j) - 3 * band_at(b, i, j), 0, "sum");
    band_free(&a);
    band_free(&b);
    band_free(&to);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(entries_are_kept_once_for_both_sides),
        cmocka_unit_test(product_and_form_are_those_of_the_dense_matrix),
        cmocka_unit_test(solves_by_cholesky),
        cmocka_unit_test(solves_by_lu_what_is_not_definite),
        cmocka_unit_test(solves_what_is_not_symmetric),
        cmocka_unit_test(nothing_times_nothing_is_harmless),
        cmocka_unit_test(singular_and_nan_are_refused_not_aborted),
        cmocka_unit_test(held_unknown_stands_alone),
        cmocka_unit_test(sum_and_blocks_add_up),
    };

    return cmocka_run_group_tests_name("band", tests, NULL, NULL);
}
