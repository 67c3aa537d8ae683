/* vector.c -- our vector operations: right, NaN-safe, and the same bits on any
 * number of threads. */
#include "algebra/vector.h"
#include "base/status.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#ifdef _OPENMP
#include <omp.h>
#endif

enum { LONG = 70003 }; /* several threads, and a last block that is not full */

static SUNContext context;

/* Teams of threads that our own code asked for, where gcc compiled it. */
static int teams;
#ifdef _OPENMP
void __real_GOMP_parallel(void (*loop)(void *), void *data, unsigned threads, unsigned flags);
void __wrap_GOMP_parallel(void (*loop)(void *), void *data, unsigned threads, unsigned flags);

void __wrap_GOMP_parallel(void (*loop)(void *), void *data, unsigned threads, unsigned flags)
{
    teams++;
    __real_GOMP_parallel(loop, data, threads, flags);
}
#endif

static void use_threads(int n)
{
#ifdef _OPENMP
    omp_set_num_threads(n);
#else
    (void)n;
#endif
}

static double noise(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (double)*seed / UINT32_MAX - 0.5;
}

static N_Vector noisy(long n, enum vector_norm norm, unsigned seed)
{
    N_Vector v = vector_create(n, norm, context);

    assert_non_null(v);
    for (long i = 0; i < n; i++)
        vector_data(v)[i] = noise(&seed);
    return v;
}

static void near(double got, double want, double tolerance)
{
    if (!(fabs(got - want) <= tolerance * (fabs(want) + DBL_MIN)))
        fail_msg("%.17g instead of %.17g", got, want);
}

static void new_vectors_are_zero_and_clones_keep_the_norm(void **state)
{
    N_Vector v = vector_create(5, VECTOR_NORM_MAX, context), c = N_VClone(v), w = N_VClone(c);

    (void)state;
    assert_int_equal(N_VGetLength(c), 5);
    assert_int_equal(vector_largest(v), -1);
    N_VConst(2, w);
    for (int i = 0; i < 5; i++)
        assert_true(vector_data(c)[i] == 0);
    vector_data(c)[3] = -7;
    near(N_VWrmsNorm(c, w), 14, 0);
    assert_int_equal(vector_largest(v), 3);
    N_VDestroy(v);
    near(N_VWrmsNorm(c, w), 14, 0); /* what clones share outlives the first */
    N_VDestroy(c);
    N_VDestroy(w);
}

static void norms_are_what_they_say(void **state)
{
    const double v[4] = { 1, -3, 0, 2 }, w[4] = { 1, 1, 5, 0.5 };
    const double want[] = { 3, pow((1 + 6561 + 0 + 1) / 4.0, 0.125), sqrt((1 + 9 + 0 + 1) / 4.0) };

    (void)state;
    for (int k = 0; k < 3; k++) {
        N_Vector a = vector_create(4, (enum vector_norm)k, context), b = N_VClone(a);
        memcpy(vector_data(a), v, sizeof v);
        memcpy(vector_data(b), w, sizeof w);
        near(N_VWrmsNorm(a, b), want[k], 1e-15);
        assert_int_equal(vector_largest(a), 1);
        N_VDestroy(a);
        N_VDestroy(b);
    }
}

static void norms_have_names(void **state)
{
    (void)state;
    assert_int_equal(vector_norm_of("max"), VECTOR_NORM_MAX);
    assert_int_equal(vector_norm_of("p8"), VECTOR_NORM_P8);
    assert_int_equal(vector_norm_of("wrms"), VECTOR_NORM_WRMS);
    assert_int_equal(vector_norm_of("none of them"), VECTOR_NORM_MAX);
    assert_string_equal(vector_norm_words[0], "max"); /* a scene's first word is its default */
}

/* One such entry, whatever its weight: no error test lets it pass.  All weights are 1. */
static void sees(N_Vector v, N_Vector w, long at, double bad)
{
    static const double weight[] = { 1, 1e-12, 0 };
    const double before = vector_data(v)[at];

    vector_data(v)[at] = bad;
    for (int k = 0; k < 3; k++) {
        vector_data(w)[at] = weight[k];
        assert_true(N_VWrmsNorm(v, w) == VECTOR_NOT_FINITE);
        assert_int_equal(vector_largest(v), at);
    }
    assert_int_equal(vector_first_bad(N_VGetLength(v), vector_data(v)), at);
    vector_data(w)[at] = 1e-12; /* that of a quadrature */
    vector_data(v)[at] = 1e6;   /* but finite: it does not matter */
    assert_true(N_VWrmsNorm(v, w) <= 0.5);
    assert_int_equal(vector_first_bad(N_VGetLength(v), vector_data(v)), -1);
    vector_data(v)[at] = before;
    vector_data(w)[at] = 1;
}

/* In vectors of length n, at places of a list that ends with -1, on that many threads. */
static void all_norms_see(long n, const long *at, int threads)
{
    use_threads(threads);
    for (int norm = 0; norm < 3; norm++) {
        N_Vector v = noisy(n, (enum vector_norm)norm, 1), w = N_VClone(v);

        N_VConst(1, w);
        for (int k = 0; at[k] >= 0; k++) {
            sees(v, w, at[k], NAN);
            sees(v, w, at[k], INFINITY);
            sees(v, w, at[k], -INFINITY);
        }
        N_VDestroy(v);
        N_VDestroy(w);
    }
    use_threads(1);
}

/* The first, the middle and the last entry, of all and of blocks. */
static void norms_see_what_is_not_finite(void **state)
{
    const long at[] = { 0, 1023, 1024, LONG / 2, LONG - 1, -1 };

    (void)state;
    for (int threads = 1; threads <= 3; threads++)
        all_norms_see(LONG, at, threads);
}

/* Lengths that fill no register, and every place in them. */
static void norms_of_short_vectors_see_it_too(void **state)
{
    (void)state;
    for (long n = 1; n <= 11; n++)
        for (long i = 0; i < n; i++)
            all_norms_see(n, (const long[]){ i, -1 }, 1);
}

/* An error that is finite by itself, but not its square or eighth power. */
static void norms_let_no_overflow_pass(void **state)
{
    (void)state;
    for (int norm = 0; norm < 3; norm++) {
        N_Vector v = noisy(LONG, (enum vector_norm)norm, 1), w = N_VClone(v);

        N_VConst(1, w);
        vector_data(v)[40000] = 1e200;
        assert_true(N_VWrmsNorm(v, w) == VECTOR_NOT_FINITE);
        assert_int_equal(vector_largest(v), 40000);
        N_VDestroy(v);
        N_VDestroy(w);
    }
}

static void combinations_equal_the_serial_ones(void **state)
{
    const double c[5] = { 1, 0.25, 0, -3, 1e-3 };
    N_Vector x[5], z;

    (void)state;
    for (int k = 0; k < 5; k++)
        x[k] = noisy(2500, VECTOR_NORM_MAX, 7u + (unsigned)k);
    z = N_VClone(x[0]);
    assert_int_equal(N_VLinearCombination(5, (double *)c, x, z), 0);
    for (int i = 0; i < 2500; i++) {
        double want = 0;
        for (int k = 0; k < 5; k++)
            want += c[k] * vector_data(x[k])[i];
        if (!(fabs(vector_data(z)[i] - want) < 1e-15))
            fail_msg("entry %d", i);
    }
    vector_data(x[2])[9] = NAN; /* its coefficient is zero: it is left out */
    assert_int_equal(N_VLinearCombination(5, (double *)c, x, x[0]), 0); /* in place */
    assert_memory_equal(vector_data(x[0]), vector_data(z), 2500 * sizeof(double));
    N_VLinearSum(2, z, -1, z, x[1]);
    N_VScale(1, z, x[2]);
    N_VScale(-2, z, x[3]);
    for (int i = 0; i < 2500; i++)
        if (vector_data(x[1])[i] != vector_data(z)[i] || vector_data(x[2])[i] != vector_data(z)[i]
            || vector_data(x[3])[i] != -2 * vector_data(z)[i])
            fail_msg("entry %d", i);
    for (int k = 0; k < 5; k++)
        N_VDestroy(x[k]);
    N_VDestroy(z);
}

/* Sums wait until they are read, copies share: neither may be seen. */
static void what_waits_is_what_was_asked_for(void **state)
{
    const double c[3] = { 1, 0.5, -2 };
    N_Vector v[6];
    double x[3][2500], want;

    (void)state;
    v[0] = noisy(2500, VECTOR_NORM_MAX, 1);
    for (int k = 1; k < 6; k++)
        v[k] = N_VClone(v[0]);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 2500; i++)
            vector_overwrite(v[k])[i] = x[k][i] = i * (k + 1) + 0.25 * k;
    }
    N_VLinearCombination(3, (double *)c, v, v[3]);
    N_VScale(1, v[0], v[4]);
    vector_data(v[0])[7] = 1e9; /* neither the sum nor the copy is to see it */
    N_VConst(5, v[1]);
    N_VScale(1, v[5], v[2]);
    N_VLinearSum(3, v[4], -3, v[1], v[5]);
    for (int i = 0; i < 2500; i++) {
        want = x[0][i] + (0.5 * x[1][i] - 2 * x[2][i]);
        if (vector_read(v[3])[i] != want || vector_read(v[4])[i] != x[0][i]
            || vector_read(v[2])[i] != 0 || vector_read(v[1])[i] != 5
            || vector_read(v[5])[i] != 3 * x[0][i] - 15)
            fail_msg("entry %d", i);
    }
    assert_true(vector_read(v[0])[7] == 1e9);
    for (int k = 0; k < 6; k++)
        N_VDestroy(v[k]);
}

/* The sum asked about, and the result of the step beside it, are right after the one
 * pass that does both; a norm that is known is not believed after a change. */
static void norms_of_sums(void **state)
{
    for (int norm = 0; norm < 3; norm++) {
        N_Vector y = noisy(LONG, (enum vector_norm)norm, 1), f[2], w, next, error;
        double c[3] = { 1, 0.5, -2 }, first;

        (void)state;
        f[0] = N_VClone(y), f[1] = N_VClone(y), w = N_VClone(y);
        next = N_VClone(y), error = N_VClone(y);
        for (long i = 0; i < LONG; i++) {
            vector_overwrite(f[0])[i] = sin((double)i);
            vector_overwrite(f[1])[i] = cos((double)i);
        }
        N_VConst(2, w);
        N_VLinearCombination(3, c, (N_Vector[]){ y, f[0], f[1] }, next);
        N_VLinearCombination(2, c + 1, f, error);
        first = N_VWrmsNorm(error, w);
        for (long i = 0; i < LONG; i++) {
            const double e = 0.5 * sin((double)i) - 2 * cos((double)i);
            if (vector_read(error)[i] != e || vector_read(next)[i] != vector_read(y)[i] + e)
                fail_msg("entry %ld", i);
        }
        assert_true(N_VWrmsNorm(error, w) == first);
        assert_int_equal(vector_bad(next), -1);
        first = N_VWrmsNorm(next, w);
        N_VConst(1, w);
        near(N_VWrmsNorm(next, w), first / 2, 1e-14);
        vector_data(next)[LONG - 2] = NAN;
        assert_true(N_VWrmsNorm(next, w) == VECTOR_NOT_FINITE);
        assert_int_equal(vector_bad(next), LONG - 2);
        N_VDestroy(y), N_VDestroy(f[0]), N_VDestroy(f[1]);
        N_VDestroy(w), N_VDestroy(next), N_VDestroy(error);
    }
}

/* A stage as ARKStep solves it, with ranges and without: the same bits. */
static void stage(int ranges, double result[2][LONG])
{
    static const long range[2][2] = { { 30000, 61000 }, { 5, 1030 } };
    const double gamma = 0.125, c[3] = { 1, 0.3, 0.7 };
    N_Vector y = noisy(LONG, VECTOR_NORM_MAX, 1), f = N_VClone(y), stiff = N_VClone(y);
    N_Vector guess = N_VClone(y), data = N_VClone(y), correction = N_VClone(y), z = N_VClone(y);
    N_Vector rates = N_VClone(y);
    double *to;

    assert_int_equal(vector_ranges(y, ranges, range), 0);
    for (long i = 0; i < LONG; i++) {
        const bool inside = (i >= 5 && i < 1030) || (i >= 30000 && i < 61000);
        vector_overwrite(f)[i] = sin((double)i);
        vector_overwrite(stiff)[i] = inside ? cos((double)i) : 0;
    }
    vector_only_inside(stiff);
    N_VScale(1, y, guess);
    N_VLinearSum(1, y, -1, guess, data);
    N_VLinearCombination(3, (double *)c, (N_Vector[]){ data, f, stiff }, data);
    N_VConst(0, correction);
    if (ranges == 0)
        vector_read(data);
    to = vector_like(data, correction);
    for (int k = 0; k < 2; k++)
        for (long i = range[k][0]; i < range[k][1]; i++)
            to[i] = 0.75 * vector_inside(data)[i] - 0.1 * vector_inside(guess)[i];
    N_VLinearSum(1, correction, 1, guess, z);
    N_VConst(9, rates); /* what it held outside must not come back */
    N_VLinearSum(1 / gamma, correction, -1 / gamma, data, rates);
    memcpy(result[0], vector_read(z), LONG * sizeof(double));
    N_VLinearCombination(3, (double *)c, (N_Vector[]){ y, f, rates }, z);
    memcpy(result[1], vector_read(z), LONG * sizeof(double));
    assert_true(vector_read(rates)[0] == 0 && vector_read(rates)[5] != 0);
    N_VDestroy(y), N_VDestroy(f), N_VDestroy(stiff), N_VDestroy(guess);
    N_VDestroy(data), N_VDestroy(correction), N_VDestroy(z), N_VDestroy(rates);
}

static void ranges_change_no_bit(void **state)
{
    static double plain[2][LONG], ranged[2][LONG];

    (void)state;
    stage(0, plain);
    for (int threads = 1; threads <= 4; threads++) {
        use_threads(threads);
        stage(2, ranged);
        assert_memory_equal(plain, ranged, sizeof plain);
    }
    use_threads(1);
}

static void wide_registers_change_no_bit(void **state)
{
    const double *x[8];
    double c[8];
    N_Vector v[8], narrow, wide;

    (void)state;
    for (int k = 0; k < 8; k++) {
        v[k] = noisy(2500, VECTOR_NORM_MAX, 3u + (unsigned)k);
        x[k] = vector_read(v[k]);
        c[k] = 0.3 * k - 1;
    }
    narrow = N_VClone(v[0]), wide = N_VClone(v[0]);
    for (int terms = 1; terms <= 8; terms++) {
        vector_combine(terms, c, x, 2500, vector_overwrite(wide));
        setenv("STIFFWATER_LANES", "2", 1);
        vector_combine(terms, c, x, 2500, vector_overwrite(narrow));
        unsetenv("STIFFWATER_LANES");
        assert_true(vector_same(narrow, wide));
    }
    for (int k = 0; k < 8; k++)
        N_VDestroy(v[k]);
    N_VDestroy(narrow), N_VDestroy(wide);
}

/* y + (a + b) with the small terms first: a last stage and the step's result
 * then have the same bits where the method says they are the same number. */
static void the_first_term_is_added_last(void **state)
{
    const double x0 = 1, x1 = 1e-16, x2 = 1e-16, c[3] = { 1, 1, 1 };
    const double *const x[3] = { &x0, &x1, &x2 };
    double sum;

    (void)state;
    vector_combine(3, c, x, 1, &sum);
    assert_true(sum == 1 + 2e-16 && sum > 1);
}

static void bits_do_not_depend_on_threads(void **state)
{
    static const int threads[] = { 1, 2, 3, 4 };
    double first[4] = { 0 };
    N_Vector sum = NULL;

    (void)state;
    for (int k = 0; k < 4; k++) {
        double got[4];
        use_threads(threads[k]);
        for (int norm = 0; norm < 3; norm++) {
            N_Vector v = noisy(LONG, (enum vector_norm)norm, 3), w = noisy(LONG, 0, 4);
            got[norm] = N_VWrmsNorm(v, w);
            N_VLinearSum(0.3, v, 0.7, w, w);
            got[3] = (double)vector_largest(v);
            if (norm == 2 && !sum) {
                sum = w;
                w = N_VClone(v);
            } else if (norm == 2) {
                assert_memory_equal(vector_data(w), vector_data(sum), LONG * sizeof(double));
            }
            N_VDestroy(v);
            N_VDestroy(w);
        }
        if (k == 0)
            memcpy(first, got, sizeof got);
        assert_memory_equal(first, got, sizeof got);
    }
    N_VDestroy(sum);
    use_threads(1);
}

/* Teams that operations on vectors of this length ask for. */
static int teams_for(long n, int threads)
{
    const double c[2] = { 2, -1 };
    N_Vector x = noisy(n, VECTOR_NORM_MAX, 3), y = N_VClone(x), z = N_VClone(x);
    N_Vector both[2] = { x, y };

    use_threads(threads);
    teams = 0;
    N_VDestroy(N_VClone(x));
    N_VConst(1, y);
    assert_int_equal(N_VLinearCombination(2, (double *)c, both, z), 0);
    near(N_VDotProd(y, y), (double)n, 1e-14);
    assert_true(N_VWrmsNorm(z, y) > 0);
    assert_int_equal(vector_first_bad(n, vector_data(z)), -1);
    vector_copy(n, vector_data(z), vector_data(x));
    assert_memory_equal(vector_data(x), vector_data(z), (size_t)n * sizeof(double));
    use_threads(1);
    N_VDestroy(x);
    N_VDestroy(y);
    N_VDestroy(z);
    return teams;
}

/* A team of one costs more than a loop over a beam's entries. */
static void one_thread_needs_no_team(void **state)
{
    const int needed = teams_for(LONG, 2);

    (void)state;
    if (needed > 0 && needed < 6)
        fail_msg("%d teams of two threads for six operations on a long vector", needed);
    assert_int_equal(teams_for(LONG, 1), 0);
    assert_int_equal(teams_for(100, 2), 0);
}

static int open_context(void **state)
{
    (void)state;
    return sundials_open(&context);
}

static int close_context(void **state)
{
    (void)state;
    sundials_close(&context);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(norms_have_names),
        cmocka_unit_test(new_vectors_are_zero_and_clones_keep_the_norm),
        cmocka_unit_test(norms_are_what_they_say),
        cmocka_unit_test(norms_see_what_is_not_finite),
        cmocka_unit_test(norms_of_short_vectors_see_it_too),
        cmocka_unit_test(norms_let_no_overflow_pass),
        cmocka_unit_test(combinations_equal_the_serial_ones),
        cmocka_unit_test(what_waits_is_what_was_asked_for),
        cmocka_unit_test(norms_of_sums),
        cmocka_unit_test(ranges_change_no_bit),
        cmocka_unit_test(wide_registers_change_no_bit),
        cmocka_unit_test(the_first_term_is_added_last),
        cmocka_unit_test(bits_do_not_depend_on_threads),
        cmocka_unit_test(one_thread_needs_no_team),
    };

    return cmocka_run_group_tests(tests, open_context, close_context);
}
