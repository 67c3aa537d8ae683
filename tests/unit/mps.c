/* mps.c -- what MPS computes with: constants of the lattice, number densities and surfaces
 * against plain loops, the Poisson matrix against a dense one, IC(0). */
#include "../physics/tank.h"
#include "eval/inside.h"
#include "solved/cholesky.h"
#include "solved/mps-inside.h"
#include "solved/poisson.h"
#include "solved/weights.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <string.h>

#define WALLS "walls = \"own-density\";"

/* By hand, l0 = 1: sums over neighbours of the square and the cubic lattice. */
static void constants_are_those_of_the_lattice(void **state)
{
    static const struct { double re, n0, lambda, kappa; } row[] = {
#if DIM == 2
        { 2.1, 6.5397, 1.3884, 1.4175 }, { 2.4, 9.7747, 1.7708, 1.5230 },
        { 3.1, 18.9764, 2.4485, 1.2378 },
#else
        { 2.1, 14.4186, 1.7017, 1.0731 }, { 2.4, 22.8093, 2.1036, 1.1517 },
        { 3.1, 54.3212, 3.2434, 1.0820 },
#endif
    };

    (void)state;
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        const struct weights s = weights_of(row[k].re * 0.01, 0.01);
        check(fabs(s.n0 - row[k].n0) < 1e-4, "re = %g: n0 = %.6f", row[k].re, s.n0);
        check(fabs(s.lambda / 1e-4 - row[k].lambda) < 1e-4, "re = %g: lambda = %.6f", row[k].re,
              s.lambda / 1e-4);
        check(fabs(s.kappa - row[k].kappa) < 1e-4, "re = %g: kappa = %.6f", row[k].re, s.kappa);
    }
}

/* A tank after one short step by MPS from a shaken state. */
struct stirred {
    struct tank tank;
    struct mps *mps;
    double *to;
};

static void stir_in(struct stirred *s, const char *water, const char *walls)
{
    tank_make(&s->tank, water, walls, WALLS, TANK_EFFECTS, NULL);
    tank_shake(&s->tank, 7, 0.15, 0.1, 0);
    s->to = tank_copy(&s->tank, s->tank.y);
    assert_int_equal(mps_create(s->tank.moment, &s->mps), 0);
    memset(s->tank.ydot, 0, (size_t)s->tank.n * sizeof(double));
    if (mps_step(s->mps, 0, 1e-4, s->tank.y, s->tank.ydot, s->to) != 0)
        fail_msg("%s", moment_refusal(s->tank.moment));
}

static void stir(struct stirred *s)
{
    stir_in(s, tank_water, tank_frame);
}

static void clear(struct stirred *s)
{
    mps_free(&s->mps);
    test_free(s->to);
    tank_free(&s->tank);
}

/* Places before the correction stand in `was`. */
static double distance(const struct mps *s, int i, int j)
{
    double square = 0;

    for (int d = 0; d < DIM; d++)
        square += (s->was[i][d] - s->was[j][d]) * (s->was[i][d] - s->was[j][d]);
    return sqrt(square);
}

static void number_densities_and_surfaces_are_those_of_plain_loops(void **state)
{
    struct stirred s;
    int surfaces = 0, unknowns = 0, dummies = 0;

    (void)state;
    stir(&s);
    const struct mps *m = s.mps;
    const double re = 2.4 * m->moment->plan->scales.dx;
    for (int i = 0; i < m->near.n; i++) {
        double n = 0;
        for (int j = 0; j < m->near.n; j++)
            if (j != i && distance(m, i, j) < re)
                n += re / distance(m, i, j) - 1;
        check(fabs(n - m->number[i]) < 1e-10 * n, "place %d: %.15g, a plain loop has %.15g", i,
              m->number[i], n);
        if (m->role[i] == POISSON_DUMMY) {
            check(i >= m->near.fluid, "fluid particle %d is a dummy", i);
            dummies++;
            continue;
        }
        check((m->role[i] == POISSON_SURFACE) == (n < 0.97 * m->density.n0),
              "place %d with n = %g n0 is %s", i, n / m->density.n0,
              m->role[i] == POISSON_SURFACE ? "at a surface" : "inside");
        surfaces += m->role[i] == POISSON_SURFACE;
        unknowns += m->role[i] == POISSON_UNKNOWN;
    }
    check(surfaces > 20 && unknowns > 20 && dummies > 20, "%d, %d, %d", surfaces, unknowns, dummies);
    clear(&s);
}

/* A block that lies 0.6 spacings deep in the floor of the tank. */
#if DIM == 2
#define BLOCK "block = { type = \"box\"; from = [0.04, -0.003]; to = [0.06, 0.012]; };"
#define BESIDE                                                                           \
    "dimension = 2; until = 1.0; spacing = 5e-3; gravity = [0.0, -9.81];"                \
    "domain = { from = [0.0, 0.0]; to = [0.1, 0.08]; };"                                 \
    "fluid = { left = { type = \"box\"; from = [0.0, 0.0]; to = [0.04, 0.06]; };"        \
    " right = { type = \"box\"; from = [0.06, 0.0]; to = [0.1, 0.06]; }; };"
#else
#define BLOCK                                                                            \
    "block = { type = \"box\"; from = [0.04, 0.0, -0.012]; to = [0.08, 0.1, 0.048]; };"
#define BESIDE                                                                           \
    "dimension = 3; until = 1.0; spacing = 2e-2; gravity = [0.0, 0.0, -9.81];"           \
    "domain = { from = [0.0, 0.0, 0.0]; to = [0.14, 0.1, 0.16]; };"                      \
    "fluid = { left = { type = \"box\"; from = [0.0, 0.0, 0.0]; to = [0.04, 0.1, 0.12]; };" \
    " right = { type = \"box\"; from = [0.08, 0.0, 0.0]; to = [0.14, 0.1, 0.12]; }; };"
#endif

static void walls_that_other_walls_cover_do_not_press(void **state)
{
    struct stirred s;
    int covered = 0, press = 0;

    (void)state;
    stir_in(&s, BESIDE, "wall = { tank = { type = \"frame\"; }; " BLOCK " };");
    const struct mps *m = s.mps;
    const double re = 2.4 * m->moment->plan->scales.dx;
    for (int i = m->near.fluid; i < m->near.n; i++) {
        double solids = 0, wet = 0;
        for (int j = 0; j < m->near.n; j++)
            if (j != i && distance(m, i, j) < re)
                *(j < m->near.fluid ? &wet : &solids) += re / distance(m, i, j) - 1;
        const bool full = solids >= m->density.n0;
        check(!full || m->role[i] == POISSON_DUMMY, "place %d presses under %g n0 of solids", i,
              solids / m->density.n0);
        covered += full && wet > 0 && m->face[mps_id(m, i)];
        press += m->role[i] != POISSON_DUMMY;
    }
    check(covered > 1 && press > 20, "%d covered, %d press", covered, press);
    clear(&s);
}

/* p rises by `slope` Pa/m along each coordinate in turn, on a lattice, with a pressure
 * everywhere: du = -dt slope/rho0 along it.  But cmps, as published, has 0: p_j less the least
 * pressure around j is the same for all j.  Of fluid at least `far` away from other bounds. */
static void push_by_a_slope(struct stirred *s, const char *word, double share, double far)
{
    const double slope = 700, h = 1e-4, dx = s->tank.plan->scales.dx;
    struct settings_mps key = s->tank.plan->in.mps;
    struct mps *m = s->mps;
    int inside = 0;

    key.gradient = word;
    m->key = &key;
    m->h = h;
    for (int along = 0; along < DIM; along++) {
        for (int i = 0; i < m->near.n; i++) {
            m->role[i] = POISSON_UNKNOWN;
            m->p[i] = slope * (1 + m->near.x[i][along]);
        }
        mps_gradient(m);
        for (int i = 0; i < m->near.fluid; i++) {
            bool near = m->near.x[i][DIM - 1] > (DIM == 2 ? 0.06 : 0.12) - 2.4 * dx - far;
            for (int d = 0; d < DIM; d++)
                near |= m->near.x[i][d] < far || (d < DIM - 1 && m->near.x[i][d] > 0.1 - far);
            if (near)
                continue;
            inside++;
            for (int d = 0; d < DIM; d++)
                check(fabs(m->du[i][d] + (d == along) * share * h * slope / 1000)
                      < 1e-9 * h * slope / 1000, "%s: du[%d] = %g m/s of particle %d, p rises "
                      "along %d", word, d, m->du[i][d], i, along);
        }
    }
    check(inside > 100, "%d particles", inside);
}

static void a_slope_of_pressure_pushes_by_its_gradient(void **state)
{
    struct stirred s;

    (void)state;
    tank_make(&s.tank, tank_water, tank_frame, WALLS, TANK_EFFECTS, NULL);
    s.to = tank_copy(&s.tank, s.tank.y);
    assert_int_equal(mps_create(s.tank.moment, &s.mps), 0);
    memset(s.tank.ydot, 0, (size_t)s.tank.n * sizeof(double));
    assert_int_equal(mps_step(s.mps, 0, 1e-4, s.tank.y, s.tank.ydot, s.to), 0);
    memcpy(s.mps->near.x, s.mps->was, (size_t)s.mps->near.n * sizeof *s.mps->was);
    push_by_a_slope(&s, "minimum", 1, 0);
    push_by_a_slope(&s, "gc", 1, 0);
    if (DIM == 2)
        push_by_a_slope(&s, "cmps", 0, 0.01);
    clear(&s);
}

/* The dense matrix of (M7) by its own loops: of unknowns, and 1 elsewhere. */
static gsl_matrix *dense(const struct mps *m)
{
    gsl_matrix *A = gsl_matrix_calloc((size_t)m->near.n, (size_t)m->near.n);
    const struct weights *w = &m->laplacian;

    for (int i = 0; i < m->near.n; i++) {
        double sum = 0;
        for (int j = 0; j < m->near.n; j++) {
            const double r = distance(m, i, j);
            if (i == j || !(r < w->re) || m->role[j] == POISSON_DUMMY)
                continue;
            const double a = 2 * DIM / (w->lambda * w->n0) * (w->re / r - 1);
            sum += a;
            if (m->role[i] == POISSON_UNKNOWN && m->role[j] == POISSON_UNKNOWN)
                gsl_matrix_set(A, (size_t)i, (size_t)j, -a);
        }
        gsl_matrix_set(A, (size_t)i, (size_t)i, m->role[i] == POISSON_UNKNOWN ? sum : 1);
    }
    return A;
}

/* Before the clamp, so by a solve of its own. */
static void pressures_are_those_of_a_dense_solve(void **state)
{
    struct stirred s;
    struct operator_report report;
    double worst = 0, most = 0;

    (void)state;
    stir(&s);
    struct mps *m = s.mps;
    const size_t n = (size_t)m->near.n;
    gsl_matrix *A = dense(m);
    gsl_vector *x = gsl_vector_alloc(n);
    gsl_vector_const_view b = gsl_vector_const_view_array(m->source, n);
    gsl_linalg_cholesky_decomp1(A);
    gsl_linalg_cholesky_solve(A, &b.vector, x);
    memset(m->p, 0, n * sizeof *m->p);
    memcpy(m->near.x, m->was, n * sizeof *m->was);
    assert_int_equal(poisson_assemble(&m->poisson, &m->near, m->role, mps_laplacian(m), m, 0), 0);
    assert_int_equal(poisson_solve(&m->poisson, m->source, 1e-11, m->p, &report), 0);
    for (size_t i = 0; i < n; i++) {
        worst = fmax(worst, fabs(m->p[i] - gsl_vector_get(x, i)));
        most = fmax(most, fabs(m->p[i]));
    }
    check(most > 0 && worst < 1e-8 * most, "%g of %g Pa", worst, most);
    check(report.products > 2 && report.products < 60, "%d products", report.products);
    gsl_vector_free(x);
    gsl_matrix_free(A);
    clear(&s);
}

/* With all entries of a small matrix there is no fill: IC(0) is the whole factor. */
static void factor_without_fill_is_cholesky(void **state)
{
    enum { N = 12 };
    size_t from[N + 1] = { 0 };
    int column[N * N];
    double lower[N * N], diagonal[N], b[N], x[N];
    gsl_matrix *A = gsl_matrix_calloc(N, N);
    gsl_vector *right = gsl_vector_alloc(N), *y = gsl_vector_alloc(N);
    unsigned seed = 3;

    (void)state;
    for (int i = 0; i < N; i++) {
        from[i + 1] = from[i];
        for (int j = 0; j < i; j++) {
            const double a = -0.5 - 0.4 * tank_random(&seed);
            column[from[i + 1]] = j;
            lower[from[i + 1]++] = a;
            gsl_matrix_set(A, (size_t)i, (size_t)j, a);
            gsl_matrix_set(A, (size_t)j, (size_t)i, a);
        }
        diagonal[i] = N;
        gsl_matrix_set(A, (size_t)i, (size_t)i, N);
        b[i] = tank_random(&seed);
        gsl_vector_set(right, (size_t)i, b[i]);
    }
    struct cholesky c = { N, from, column, lower, diagonal };
    assert_int_equal(cholesky_factor(&c), 0);
    cholesky_solve(&c, b, x);
    gsl_linalg_cholesky_decomp1(A);
    gsl_linalg_cholesky_solve(A, right, y);
    for (int i = 0; i < N; i++)
        check(fabs(x[i] - gsl_vector_get(y, (size_t)i)) < 1e-13, "%d: %.15g, not %.15g", i, x[i],
              gsl_vector_get(y, (size_t)i));
    gsl_matrix_free(A);
    gsl_vector_free(right);
    gsl_vector_free(y);
}

/* A matrix that is not definite has no factor, and the row is told. */
static void factor_tells_the_row_that_fails(void **state)
{
    size_t from[4] = { 0, 0, 1, 2 };
    int column[2] = { 0, 1 };
    double lower[2] = { -1, -1 }, diagonal[3] = { 2, 2, 0.5 };
    struct cholesky c = { 3, from, column, lower, diagonal };

    (void)state;
    assert_int_equal(cholesky_factor(&c), 3);
}

/* The published constant of HL is 2.28 (3D: 1.15) times that which is exact for |x|^2. */
static void laplacian_of_a_square_is_exact_on_the_lattice(void **state)
{
    const double l0 = 1, re = 2.4;
    const struct weights s = weights_of(re, l0);
    double standard = 0, higher = 0, published = 0;

    (void)state;
    for (int a = -3; a <= 3; a++)
        for (int b = -3; b <= 3; b++)
            for (int c = DIM == 3 ? -3 : 0; c <= (DIM == 3 ? 3 : 0); c++) {
                const double r2 = a * a + b * b + c * c, r = sqrt(r2);
                if (!(r > 0 && r < re))
                    continue;
                standard += 2 * DIM / (s.lambda * s.n0) * weights_w(&s, r) * r2;
                higher += 2 * DIM / s.inverse * re / (r * r2) * r2;
                published += (5 - DIM) / s.n0 * re / (r * r2) * r2;
            }
    check(fabs(standard - 2 * DIM) < 1e-12 && fabs(higher - 2 * DIM) < 1e-12, "%.15g, %.15g",
          standard, higher);
    check(fabs(published / (2 * DIM) - (DIM == 2 ? 2.28 : 1.15)) < 0.01, "%g",
          published / (2 * DIM));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constants_are_those_of_the_lattice),
        cmocka_unit_test(laplacian_of_a_square_is_exact_on_the_lattice),
        cmocka_unit_test(number_densities_and_surfaces_are_those_of_plain_loops),
        cmocka_unit_test(walls_that_other_walls_cover_do_not_press),
        cmocka_unit_test(a_slope_of_pressure_pushes_by_its_gradient),
        cmocka_unit_test(pressures_are_those_of_a_dense_solve),
        cmocka_unit_test(factor_without_fill_is_cholesky),
        cmocka_unit_test(factor_tells_the_row_that_fails),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
