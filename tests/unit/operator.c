/* operator.c -- tests of implicit/operator.h with the operator of a pressure that is solved
 * for, a beam as its rectangular block, and with small matrices. */
#include "operator-pressure.h"

#include "../physics/tank.h"
#include "base/status.h"

#include <float.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

#define PHYSICS TANK_EFFECTS "kernel = { type = \"wendland-c2\"; support = 3.0; };"

/* A tank of water with a pressure to solve for; stiffness: c tau/dx. */
struct wet {
    struct tank t;
    struct pressure p;
};

static void make_of(struct wet *w, const char *water, const char *beam, double stiffness,
                    double gamma)
{
    tank_make(&w->t, water, tank_frame, beam, PHYSICS, NULL);
    tank_shake(&w->t, 4, 0.2, 1, 0.01);
    pressure_make(&w->p, w->t.moment, w->t.y, stiffness, beam[0] != 0, gamma);
}

static void make(struct wet *w, bool beam, double stiffness, double gamma)
{
    make_of(w, beam ? tank_parted_water : tank_bare_water, beam ? tank_beam : "", stiffness,
            gamma);
}

static void drop(struct wet *w)
{
    pressure_free(&w->p);
    tank_free(&w->t);
}

static double *numbers(long n, unsigned seed)
{
    double *x = test_calloc((size_t)n, sizeof *x);

    for (long i = 0; i < n && seed; i++)
        x[i] = tank_random(&seed);
    return x;
}

static double dot(int n, const double *x, const double *y)
{
    double sum = 0;

    for (int i = 0; i < n; i++)
        sum += x[i] * y[i];
    return sum;
}

static void check_symmetric(bool beam, double gamma)
{
    struct wet w;

    make(&w, beam, 15, gamma);
    const int n = w.p.n;
    double *a = numbers(n, 0), *b = numbers(n, 0);
    for (unsigned seed = 1; seed < 20; seed += 2) {
        double *x = numbers(n, seed), *y = numbers(n, seed + 1);
        operator_apply(&w.p.operator, x, a);
        operator_apply(&w.p.operator, y, b);
        const double size = sqrt(dot(n, a, a) * dot(n, y, y));
        check(fabs(dot(n, y, a) - dot(n, x, b)) < 1e-14 * size, "not symmetric: %g and %g of %g",
              dot(n, y, a), dot(n, x, b), size);
        check(dot(n, x, a) >= w.p.least * dot(n, x, x), "x A x is %g, x x/(rho0 c^2) %g",
              dot(n, x, a), w.p.least * dot(n, x, x));
        test_free(x);
        test_free(y);
    }
    test_free(a);
    test_free(b);
    drop(&w);
}

static void pressure_is_symmetric_and_positive(void **state)
{
    (void)state;
    check_symmetric(false, 0);
    if (DIM == 2) {
        check_symmetric(true, 0);
        check_symmetric(true, 1e-3);
    }
}

/* Adds c J_k J_k^T, column by column of J, for those that move by themselves. */
static void add_fluid(const struct pressure *p, gsl_matrix *a)
{
    double *at = numbers(p->n * DIM, 0), *column = numbers(p->n, 0);

    for (int k = 0; k < p->list->start[KIND_FLUID + 1] * DIM; k++) {
        memset(column, 0, (size_t)p->n * sizeof *column);
        at[k] = 1;
        pressure_up(p, p->tau / sqrt(p->rho0), at, column);
        at[k] = 0;
        gsl_vector_view c = gsl_vector_view_array(column, (size_t)p->n);
        gsl_blas_dsyr(CblasLower, 1, &c.vector, a);
    }
    test_free(at);
    test_free(column);
}

/* Adds C B^-1 C^T: the beam's matrices and its modes at the skin, one after the other. */
static void add_beam(struct pressure *p, double gamma, gsl_matrix *a)
{
    struct moment_body *b = &p->moment->body[0];
    const int n = p->body.n, from = p->moment->particles->object[b->object].from;
    gsl_matrix *block = gsl_matrix_calloc((size_t)n, (size_t)n);
    gsl_matrix *c = gsl_matrix_calloc((size_t)p->n, (size_t)n);
    double *mode = numbers(n, 0), *row = numbers(n, 0), *at = numbers(p->n * DIM, 0);
    double *column = numbers(p->n, 0);

    for (int k = 0; k < n; k++) {
        memset(mode, 0, (size_t)n * sizeof *mode);
        memset(at, 0, (size_t)p->n * DIM * sizeof *at);
        memset(column, 0, (size_t)p->n * sizeof *column);
        mode[k] = 1;
        b->kind->role.coupled->inertia(b->body, b->work, gamma, mode, row);
        b->kind->role.coupled->drift(b->body, mode, p->points);
        for (int j = 0; j < b->skin; j++)
            if (p->list->slot[from + j] >= 0)
                memcpy(at + p->list->slot[from + j] * DIM, p->points[j], sizeof p->points[j]);
        pressure_up(p, p->tau * sqrt(p->volume), at, column);
        for (int i = 0; i < n; i++)
            gsl_matrix_set(block, (size_t)i, (size_t)k, row[i]);
        for (int i = 0; i < p->n && k > 1; i++) /* w and its slope are held at the root */
            gsl_matrix_set(c, (size_t)i, (size_t)k, column[i]);
    }
    assert_int_equal(gsl_linalg_cholesky_decomp1(block), 0);
    gsl_blas_dtrsm(CblasRight, CblasLower, CblasTrans, CblasNonUnit, 1, block, c);
    gsl_blas_dsyrk(CblasLower, CblasNoTrans, 1, c, 1, a);
    test_free(mode);
    test_free(row);
    test_free(at);
    test_free(column);
    gsl_matrix_free(block);
    gsl_matrix_free(c);
}

/* A of the formula in operator-pressure.h, factored. */
static gsl_matrix *dense(struct pressure *p, bool beam, double gamma)
{
    gsl_matrix *a = gsl_matrix_calloc((size_t)p->n, (size_t)p->n);

    gsl_matrix_set_identity(a);
    gsl_matrix_scale(a, p->least);
    add_fluid(p, a);
    if (beam)
        add_beam(p, gamma, a);
    assert_int_equal(gsl_linalg_cholesky_decomp1(a), 0);
    return a;
}

/* Solves A x = b from x = 0, or from the guess that x holds. */
static struct operator_report run(struct operator *a, const double *b, bool warm, double near,
                                  double *x)
{
    const int n = operator_size(a);
    double *residual = numbers(n, 0);
    struct operator_solver *solver;
    struct operator_report report;

    assert_int_equal(operator_solver_create(n, 1000, &solver), 0);
    if (warm)
        operator_apply(a, x, residual);
    else
        memset(x, 0, (size_t)n * sizeof *x);
    for (int i = 0; i < n; i++)
        residual[i] = b[i] - residual[i];
    a->near = near * sqrt(dot(n, b, b));
    const int status = operator_solve(solver, a, x, residual, &report);
    char why[160];
    operator_refusal(&report, why, sizeof why);
    check(status == STATUS_DONE, "%s", why);
    check(sqrt(dot(n, residual, residual)) <= a->near, "says it is solved: %g is left of %g",
          sqrt(dot(n, residual, residual)), a->near);
    operator_apply(a, x, residual);
    for (int i = 0; i < n; i++)
        residual[i] -= b[i];
    check(sqrt(dot(n, residual, residual)) <= a->near + 1e-12 * sqrt(dot(n, b, b)),
          "A x is off by %g", sqrt(dot(n, residual, residual)));
    test_free(residual);
    operator_solver_free(&solver);
    return report;
}

static void check_dense(bool beam, double gamma)
{
    struct wet w;

    make(&w, beam, 6, gamma);
    const int n = w.p.n;
    double *b = numbers(n, 7), *x = numbers(n, 0), *right = numbers(n, 7);
    gsl_matrix *a = dense(&w.p, beam, gamma);
    gsl_vector_view at = gsl_vector_view_array(right, (size_t)n);
    double off = 0;
    run(&w.p.operator, b, false, 1e-13, x);
    gsl_linalg_cholesky_svx(a, &at.vector);
    for (int i = 0; i < n; i++)
        off = fmax(off, fabs(x[i] - right[i]));
    check(off < 1e-9 * sqrt(dot(n, right, right)), "off by %g of %g", off,
          sqrt(dot(n, right, right)));
    test_free(b);
    test_free(x);
    test_free(right);
    gsl_matrix_free(a);
    drop(&w);
}

static void pressure_is_that_of_the_dense_matrix(void **state)
{
    (void)state;
    check_dense(false, 0);
    if (DIM == 2) {
        check_dense(true, 0);
        check_dense(true, 1e-3);
    }
}

static void set_threads(int n)
{
#ifdef _OPENMP
    omp_set_num_threads(n);
#else
    (void)n;
#endif
}

/* The solution by row, which no lane width changes. */
static double *solution(bool beam, size_t *bytes)
{
    struct wet w;

    make(&w, beam, 15, 1e-3);
    double *b = numbers(w.p.n, 7), *x = numbers(w.p.n, 0);
    double *by_row = numbers(w.p.list->n, 0);
    run(&w.p.operator, b, false, 1e-2, x);
    for (int s = 0; s < w.p.n; s++)
        by_row[w.p.list->order[s]] = x[s];
    *bytes = (size_t)w.p.list->n * sizeof *by_row;
    test_free(b);
    test_free(x);
    drop(&w);
    return by_row;
}

static void check_bits(bool beam)
{
    static const char *const lanes[] = { "2", "4", "8" };
    double *first = NULL;
    size_t bytes;

    for (int l = 0; l < 3; l++)
        for (int threads = 1; threads <= 2; threads++) {
            setenv("STIFFWATER_LANES", lanes[l], 1);
            set_threads(threads);
            double *x = solution(beam, &bytes);
            if (first) {
                assert_memory_equal(first, x, bytes);
                test_free(x);
            } else {
                first = x;
            }
        }
    test_free(first);
    unsetenv("STIFFWATER_LANES");
    set_threads(2);
}

static void threads_and_lanes_do_not_matter(void **state)
{
    (void)state;
    check_bits(false);
    if (DIM == 2)
        check_bits(true);
}

/* A column of 1,600 particles before it falls. */
static const char *const column =
    "dimension = 2; until = 1.0; spacing = 2.5e-3; gravity = [0.0, -9.81];"
    "domain = { from = [0.0, 0.0]; to = [0.2, 0.12]; };"
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0]; to = [0.1, 0.1]; }; };";

/* Products from p = 0 to a hundredth of a right side that is rough, and from what was found
 * when that grows by a fiftieth. */
static void count(struct wet *w, int *cold, int *warm)
{
    double *b = numbers(w->p.n, 9), *x = numbers(w->p.n, 0);

    *cold = run(&w->p.operator, b, false, 1e-2, x).products;
    for (int i = 0; i < w->p.n; i++)
        b[i] *= 1.02;
    *warm = run(&w->p.operator, b, true, 1e-2, x).products;
    test_free(b);
    test_free(x);
    drop(w);
}

/* 2.3 c tau/dx products from nothing, 0.7 c tau/dx from a guess, whatever the size. */
static void products_grow_with_stiffness(void **state)
{
    static const double stiffness[] = { 6, 15, 30 };

    (void)state;
    for (int k = 0; k < 3 && DIM == 2; k++) {
        struct wet w;
        int cold, warm;
        make_of(&w, column, "", stiffness[k], 0);
        count(&w, &cold, &warm);
        check(cold <= 2.3 * stiffness[k] && cold >= 1.9 * stiffness[k],
              "%d products at c tau/dx = %g", cold, stiffness[k]);
        check(warm <= 0.7 * stiffness[k], "%d products from a guess at c tau/dx = %g", warm,
              stiffness[k]);
    }
}

/* Products beside a beam of this density. */
static int beside(const char *density, bool tempered)
{
    const char *at = strstr(tank_beam, "1200.0");
    char text[512];
    int cold, warm;
    struct wet w;

    snprintf(text, sizeof text, "%.*s%s%s", (int)(at - tank_beam), tank_beam, density, at + 6);
    make_of(&w, tank_parted_water, text, 15, 0);
    if (tempered)
        pressure_temper(&w.p, 0);
    count(&w, &cold, &warm);
    return cold;
}

/* A beam adds few, and one that is a hundred thousand times lighter than the water that it
 * pushes away no more: when the preconditioner knows of it. */
static void light_beam_takes_no_more_products(void **state)
{
    int none, warm;
    struct wet w;

    (void)state;
    if (DIM != 2)
        return;
    make_of(&w, tank_parted_water, "", 15, 0);
    count(&w, &none, &warm);
    const int heavy = beside("1200.0", true), light = beside("0.0100", true);
    check(heavy <= 1.1 * none, "%d products, %d without a beam", heavy, none);
    check(light <= heavy + 1, "%d products, %d when it is heavy", light, heavy);
    check(beside("0.0100", false) > 3 * light, "%d products by the diagonal alone",
          beside("0.0100", false));
}

/* A small matrix, [A0 C; C^T B], C [3][2]. */
static double small_a0[3] = { 4, 5, 6 };
static double small_b[2] = { 3, 2 };
static const double small_c[3][2] = { { 0.5, 0.25 }, { -1, 0.5 }, { 0.125, 1 } };

static void small_apply(void *self, const double *x, double *to)
{
    (void)self;
    for (int i = 0; i < 3; i++)
        to[i] = small_a0[i] * x[i];
}

static void small_block(void *self, const double *x, double *to)
{
    (void)self;
    for (int k = 0; k < 2; k++)
        to[k] = small_b[k] * x[k];
}

static void small_solve(void *self, double *v)
{
    (void)self;
    for (int k = 0; k < 2; k++)
        v[k] /= small_b[k];
}

static double small_largest(void *self, const double *v)
{
    (void)self;
    return fmax(fabs(v[0]), fabs(v[1]));
}

static void small_spread(void *self, const double *v, double *to)
{
    (void)self;
    for (int i = 0; i < 3; i++)
        to[i] += small_c[i][0] * v[0] + small_c[i][1] * v[1];
}

static void small_gather(void *self, const double *x, double *v)
{
    (void)self;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++)
            v[k] += small_c[i][k] * x[i];
}

/* modes: the body is eliminated. */
static struct operator small(struct operator_body *body, double *modes)
{
    *body = (struct operator_body){
        .n = 2, .eliminated = modes != NULL, .apply = small_block, .solve = small_solve,
        .largest = small_largest, .spread = small_spread, .gather = small_gather,
    };
    return (struct operator){
        .n = 3, .width = 1, .diagonal = small_a0, .bodies = 1, .body = body,
        .modes = modes, .apply = small_apply,
    };
}

/* Unknowns that stay in x and such that are eliminated, against both matrices. */
static void bodies_stay_or_are_eliminated(void **state)
{
    struct operator_body body;
    double modes[2], x[5];
    const double b[5] = { 1, 2, 3, -4, 5 };

    (void)state;
    struct operator a = small(&body, NULL);
    assert_int_equal(operator_size(&a), 5);
    assert_int_equal(run(&a, b, false, 1e-14, x).products, 5);
    for (int i = 0; i < 3; i++)
        assert_float_equal(small_a0[i] * x[i] + small_c[i][0] * x[3] + small_c[i][1] * x[4], b[i],
                           1e-12);
    for (int k = 0; k < 2; k++)
        assert_float_equal(small_b[k] * x[3 + k] + small_c[0][k] * x[0] + small_c[1][k] * x[1]
                           + small_c[2][k] * x[2], b[3 + k], 1e-12);
    a = small(&body, modes);
    assert_int_equal(operator_size(&a), 3);
    run(&a, b, false, 1e-14, x);
    for (int i = 0; i < 3; i++) {
        double sum = small_a0[i] * x[i];
        for (int k = 0; k < 2; k++)
            for (int j = 0; j < 3; j++)
                sum += small_c[i][k] / small_b[k] * small_c[j][k] * x[j];
        assert_float_equal(sum, b[i], 1e-12);
    }
}

/* Not exact enough with so few products, or with such numbers: why, and x as it was. */
static void check_refusal(const struct operator *a, int most, enum operator_cause cause,
                          const char *word)
{
    const int n = operator_size(a);
    double *x = numbers(n, 3), *as_before = numbers(n, 3), *residual = numbers(n, 4);
    struct operator_solver *solver;
    struct operator_report report;
    char why[160];

    status_clear();
    assert_int_equal(operator_solver_create(n, most, &solver), 0);
    assert_int_equal(operator_solve(solver, a, x, residual, &report), STATUS_FAILED);
    assert_int_equal(report.cause, cause);
    operator_refusal(&report, why, sizeof why);
    check(strstr(why, word), "%s", why);
    assert_memory_equal(x, as_before, (size_t)n * sizeof *x);
    assert_string_equal(status_message(), "");
    test_free(x);
    test_free(as_before);
    test_free(residual);
    operator_solver_free(&solver);
    assert_null(solver);
}

static void refusals_tell_their_cause(void **state)
{
    struct operator_body body;
    double modes[2];
    struct operator a = small(&body, modes);

    (void)state;
    a.near = 1e-12;
    check_refusal(&a, 2, OPERATOR_TOO_MANY, "after 2 products its residual is 0.");
    small_a0[1] = -5;
    check_refusal(&a, 20, OPERATOR_NOT_POSITIVE, "positive");
    small_a0[1] = NAN;
    check_refusal(&a, 20, OPERATOR_NOT_FINITE, "finite");
    small_a0[1] = 5;
    small_b[0] = -0.01;
    a.diagonal = (const double[]){ 1, 1, 1 };
    check_refusal(&a, 20, OPERATOR_NOT_POSITIVE, "positive");
    small_b[0] = 3;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pressure_is_symmetric_and_positive),
        cmocka_unit_test(pressure_is_that_of_the_dense_matrix),
        cmocka_unit_test(threads_and_lanes_do_not_matter),
        cmocka_unit_test(products_grow_with_stiffness),
        cmocka_unit_test(light_beam_takes_no_more_products),
        cmocka_unit_test(bodies_stay_or_are_eliminated),
        cmocka_unit_test(refusals_tell_their_cause),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
