/* running.c -- unit tests of running means: exact for lines whatever the steps, for a known
 * signal as good as the trapezoidal rule, and without memory beyond the window. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/status.h"
#include "measure/running.h"

#include <math.h>

/* Steps that differ by a factor of thirty, the same at every call. */
static double step(int i)
{
    return 1e-3 * (1 + 29 * fabs(sin(7.3 * i)));
}

static void assert_close(double seen, double wanted, double most)
{
    if (!(fabs(seen - wanted) <= most))
        fail_msg("%.17g is not %.17g", seen, wanted);
}

static struct running *make(int columns, const double *window)
{
    struct running *r;

    assert_int_equal(running_create(columns, window, &r), STATUS_DONE);
    return r;
}

/* p = 5 + 2 t: the mean over the last w is p(t - w/2); before w has passed, p(t/2).  Rows
 * fall anywhere within the last step. */
static void test_line(void **state)
{
    const double window[] = { 0.05, 0.4 };
    struct running *r = make(2, window);
    double t = 0;

    (void)state;
    assert_true(isnan(running_mean(r, 0, 0)));
    for (int i = 0; i < 500; i++) {
        const double h = step(i);
        assert_int_equal(running_add(r, t, (double[]){ 5 + 2 * t, -t }), STATUS_DONE);
        for (int k = 1; i > 0 && k <= 3; k++) {
            const double at = t - step(i - 1) * (1 - k / 3.0);
            const double half = fmin(at, window[0]) / 2, wide = fmin(at, window[1]) / 2;
            assert_close(running_mean(r, 0, at), 5 + 2 * (at - half), 1e-12);
            assert_close(running_mean(r, 1, at), -(at - wide), 1e-12);
        }
        t += h;
    }
    running_free(&r);
    assert_null(r);
}

/* sin(w t): the exact mean is (cos w(t - T) - cos w t)/(w T); the trapezoidal rule is off
 * by h^2 w^2/12 at most. */
static void test_signal(void **state)
{
    const double window = 0.3, omega = 9;
    struct running *r = make(1, &window);
    double t = 0, before = 0;

    (void)state;
    for (int i = 0; i < 400; i++) {
        const double value = sin(omega * t);
        assert_int_equal(running_add(r, t, &value), STATUS_DONE);
        if (before > window) {
            const double at = (before + t) / 2;
            const double exact = (cos(omega * (at - window)) - cos(omega * at)) / (omega * window);
            assert_close(running_mean(r, 0, at), exact, 0.03 * 0.03 * omega * omega / 12);
        }
        before = t;
        t += step(i);
    }
    running_free(&r);
}

/* A value that stands for a moment counts for that moment: with short steps in it and long
 * ones around, a plain mean of readings would be far off. */
static void test_weights(void **state)
{
    const double window = 1;
    struct running *r = make(1, &window);

    (void)state;
    for (int i = 0; i <= 100; i++) { /* 100 in the last tenth, one before */
        const double t = i == 0 ? 0 : 0.9 + 0.001 * i, p = i == 0 ? 0 : 10;
        assert_int_equal(running_add(r, t, &p), STATUS_DONE);
    }
    assert_close(running_mean(r, 0, 1), 0.901 * 5 + 0.099 * 10, 1e-12);
    running_free(&r);
}

/* What a checkpoint may leave out: readings before the window change no bit. */
static void test_short_memory(void **state)
{
    const double window = 0.1;
    struct running *all = make(1, &window), *late = make(1, &window);
    double t = 0;

    (void)state;
    for (int i = 0; i < 1000; i++) {
        const double value = exp(sin(11 * t)) + 3e5 * (i < 200);
        assert_int_equal(running_add(all, t, &value), STATUS_DONE);
        if (i >= 500)
            assert_int_equal(running_add(late, t, &value), STATUS_DONE);
        if (i >= 700)
            assert_true(running_mean(all, 0, t) == running_mean(late, 0, t));
        t += step(i);
    }
    running_free(&all);
    running_free(&late);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_line),
        cmocka_unit_test(test_signal),
        cmocka_unit_test(test_weights),
        cmocka_unit_test(test_short_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
