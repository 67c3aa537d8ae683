/* bounded.c -- tests of implicit/bounded.h: against all faces tried one by one, and against
 * problems that are made of their solution. */
#include "base/status.h"
#include "implicit/bounded.h"

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

enum { SMALL = 7, LONG = 5000, MOST = 20000 };

/* Dense, or, without numbers, a string of beads: 2.1 and -1 beside it, times weights that go
 * from 1 to 100 along it. */
struct matrix {
    int n;
    const double *a; /* [n][n] */
};

static double noise(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 8) / 8388608.0 - 1;
}

static double weight(const struct matrix *m, int i)
{
    return pow(10, (double)i / m->n);
}

static double entry(const struct matrix *m, int i, int j)
{
    if (m->a)
        return m->a[i * m->n + j];
    return (i == j ? 2.1 : -1) * weight(m, i) * weight(m, j);
}

static void apply(void *self, const double *x, double *to)
{
    const struct matrix *m = self;

    for (int i = 0; i < m->n; i++) {
        const int from = m->a || i < 1 ? 0 : i - 1, end = m->a || i > m->n - 2 ? m->n : i + 2;
        to[i] = 0;
        for (int j = from; j < end; j++)
            to[i] += entry(m, i, j) * x[j];
    }
}

/* C C^T + 0.1, with rows of very different size. */
static void fill(double *a, int n, unsigned *seed)
{
    double c[SMALL * SMALL];

    for (int i = 0; i < n * n; i++)
        c[i] = noise(seed) * pow(10, i / n % 3);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            a[i * n + j] = i == j ? 0.1 : 0;
            for (int k = 0; k < n; k++)
                a[i * n + j] += c[i * n + k] * c[j * n + k];
        }
}

/* From x on, within bounds, to a residual of `share` of b; products. */
static int solve(struct matrix *m, const double *b, const double *least, double share, double *x)
{
    double *diagonal = test_calloc((size_t)m->n, sizeof *x), square = 0;
    double *residual = test_calloc((size_t)m->n, sizeof *x);
    struct operator a = { .self = m, .n = m->n, .width = 1, .diagonal = diagonal,
                          .apply = apply };
    struct operator_report report;
    struct bounded_solver *s;

    apply(m, x, residual);
    for (int i = 0; i < m->n; i++) {
        diagonal[i] = entry(m, i, i);
        residual[i] = b[i] - residual[i];
        square += b[i] * b[i];
    }
    a.near = share * sqrt(square);
    assert_int_equal(bounded_solver_create(m->n, MOST, &s), STATUS_DONE);
    if (bounded_solve(s, &a, least, x, residual, &report) != STATUS_DONE)
        fail_msg("%d unknowns: cause %d after %d products, %g of the first residual is left",
                 m->n, report.cause, report.products, report.residual);
    bounded_solver_free(&s);
    assert_null(s);
    test_free(diagonal);
    test_free(residual);
    return report.products;
}

/* Gauss on the unknowns of a face; false: some x or g of those that are bounded is negative
 * there, or one that is free is not on it. */
static bool try_face(const struct matrix *m, const double *b, unsigned face, unsigned loose,
                     double *x)
{
    double a[SMALL][SMALL], g[SMALL];
    bool good = true;

    for (int i = 0; i < m->n; i++) {
        const bool open = face >> i & 1;
        x[i] = open ? b[i] : 0;
        for (int j = 0; j < m->n; j++)
            a[i][j] = open && face >> j & 1 ? entry(m, i, j) : i == j;
    }
    for (int k = 0; k < m->n; k++)
        for (int i = 0; i < m->n; i++) {
            const double share = i == k ? 0 : a[i][k] / a[k][k];
            for (int j = k; j < m->n; j++)
                a[i][j] -= share * a[k][j];
            x[i] -= share * x[k];
        }
    for (int i = 0; i < m->n; i++)
        x[i] /= a[i][i];
    apply((void *)m, x, g);
    for (int i = 0; i < m->n; i++)
        good = good && (face >> i & 1 ? loose >> i & 1 || x[i] >= 0
                                      : !(loose >> i & 1) && g[i] >= b[i]);
    return good;
}

/* In one trial of two some unknowns are free. */
static void small_ones_have_the_face_that_fits(void **state)
{
    double a[SMALL * SMALL], b[SMALL], x[SMALL], is[SMALL], least[SMALL];
    unsigned seed = 1, faces = 0;

    (void)state;
    for (int trial = 0; trial < 2000; trial++) {
        struct matrix m = { .n = 1 + trial % SMALL, .a = a };
        const unsigned loose = trial % 2 ? (unsigned)(trial / 2 * 37) % 128 : 0;
        unsigned face = 0;
        fill(a, m.n, &seed);
        for (int i = 0; i < m.n; i++) {
            b[i] = noise(&seed) * sqrt(a[i * m.n + i]);
            x[i] = trial % 3 ? fmax(0, noise(&seed)) : 0;
            least[i] = loose >> i & 1 ? -INFINITY : 0;
        }
        while (face < 1u << m.n && !try_face(&m, b, face, loose, is))
            face++;
        assert_true(face < 1u << m.n);
        faces |= 1u << (face % 32);
        solve(&m, b, loose ? least : NULL, 1e-13, x);
        for (int i = 0; i < m.n; i++)
            if (!(fabs(x[i] - is[i]) <= 1e-8 * (1 + fabs(is[i]))))
                fail_msg("trial %d, face %u: x[%d] = %.12g, should be %.12g", trial, face, i, x[i],
                         is[i]);
    }
    assert_true(faces == 0xffffffffu);
}

/* b of a long one with the solution `is`; for each third both x and g are 0. */
static double *long_one(const struct matrix *m, unsigned seed, double *is)
{
    double *b = test_calloc((size_t)m->n, sizeof *b);

    for (int i = 0; i < m->n; i++)
        is[i] = i % 3 ? fmax(0, noise(&seed)) / weight(m, i) : 0;
    apply((void *)m, is, b);
    for (int i = 0; i < m->n; i++)
        b[i] -= is[i] == 0 && i % 3 ? fabs(noise(&seed)) : 0;
    return b;
}

static void long_and_degenerate_ones_have_their_solution(void **state)
{
    struct matrix m = { .n = LONG };
    double *is = test_calloc(LONG, sizeof *is), *b = long_one(&m, 5, is);
    double *x = test_calloc(LONG, sizeof *x), worst = 0;

    (void)state;
    for (int start = 0; start < 2; start++) {
        for (int i = 0; i < LONG; i++)
            x[i] = start;
        const int products = solve(&m, b, NULL, 1e-12, x);
        for (int i = 0; i < LONG; i++) {
            assert_true(x[i] >= 0);
            worst = fmax(worst, fabs(x[i] - is[i]) * weight(&m, i));
        }
        print_message("# from %d: %d products, off by %.2g\n", start, products, worst);
        assert_true(worst < 1e-9);
    }
    test_free(is);
    test_free(b);
    test_free(x);
}

/* Away from bounds they are conjugate gradients: the scaled matrix has a condition of 41, so
 * sqrt(41)/2 ln(2e10) = 76 products do; steepest descent takes 41/4 ln(1e20) = 470. */
static void far_from_bounds_they_are_conjugate_gradients(void **state)
{
    struct matrix m = { .n = LONG };
    double *is = test_calloc(LONG, sizeof *is), *b = test_calloc(LONG, sizeof *b);
    double *x = test_calloc(LONG, sizeof *x);
    unsigned seed = 3;

    (void)state;
    for (int i = 0; i < LONG; i++) {
        is[i] = (30 + noise(&seed)) / weight(&m, i);
        x[i] = 30 / weight(&m, i);
    }
    apply(&m, is, b);
    const int products = solve(&m, b, NULL, 1e-12, x);
    print_message("# %d products\n", products);
    assert_in_range(products, 2, 100);
    test_free(is);
    test_free(b);
    test_free(x);
}

static void threads_change_no_bit(void **state)
{
    struct matrix m = { .n = LONG };
    double *is = test_calloc(LONG, sizeof *is), *b = long_one(&m, 9, is), *x[2];

    (void)state;
    for (int k = 0; k < 2; k++) {
        x[k] = test_calloc(LONG, sizeof *x[k]);
#ifdef _OPENMP
        omp_set_num_threads(k + 1);
#endif
        solve(&m, b, NULL, 1e-3, x[k]);
    }
    assert_memory_equal(x[0], x[1], LONG * sizeof *x[0]);
    test_free(x[0]);
    test_free(x[1]);
    test_free(is);
    test_free(b);
}

static void what_is_not_positive_is_refused(void **state)
{
    const double a[3][4] = { { 1, 3, 3, 1 }, { 1, NAN, NAN, 1 }, { 2, -1, -1, 2 } };
    const enum operator_cause cause[] = { OPERATOR_NOT_POSITIVE, OPERATOR_NOT_FINITE,
                                          OPERATOR_TOO_MANY };
    const double diagonal[2] = { 1, 1 };

    (void)state;
    for (int k = 0; k < 3; k++) {
        struct matrix m = { .n = 2, .a = a[k] };
        struct operator op = { .self = &m, .n = 2, .width = 1, .diagonal = diagonal,
                               .apply = apply, .near = 1e-13 };
        double x[2] = { 0.5, 0.25 }, residual[2] = { -1, 1.5 };
        struct operator_report report;
        struct bounded_solver *s;
        assert_int_equal(bounded_solver_create(2, k < 2 ? 100 : 1, &s), STATUS_DONE);
        assert_int_equal(bounded_solve(s, &op, NULL, x, residual, &report), STATUS_FAILED);
        assert_int_equal(report.cause, cause[k]);
        assert_true(x[0] == 0.5 && x[1] == 0.25);
        bounded_solver_free(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(small_ones_have_the_face_that_fits),
        cmocka_unit_test(long_and_degenerate_ones_have_their_solution),
        cmocka_unit_test(far_from_bounds_they_are_conjugate_gradients),
        cmocka_unit_test(threads_change_no_bit),
        cmocka_unit_test(what_is_not_positive_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
