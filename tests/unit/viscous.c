/* viscous.c -- a viscosity on the implicit side: the solve, the books, the run. */
#include "../physics/tank.h"

#include "base/status.h"
#include "time/method.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define EFFECTS(mu, side)                                                                \
    "effects = { continuity = { }; pressure = { }; density-diffusion = { delta = 0.1; };"  \
    " laminar-viscosity = { mu = " mu "; side = \"" side "\"; }; };"
#define THICK EFFECTS("300.0", "implicit")
#define THICK_PARTICLES EFFECTS("300.0", "implicit\"; stick = \"particles")
#define THICK_LAPLACIAN                                                                  \
    TANK_SEED_KERNELS "effects = { continuity = { }; pressure = { };"                    \
    " laplacian-viscosity = { mu = 300.0; side = \"implicit\"; }; };"

/* Walls that slide under the water, so that they pull. */
#if DIM == 2
static const char moving[] =
    "wall = { bed = { type = \"box\"; from = [-0.02, -0.015]; to = [0.12, 0.0];"
    " velocity = [0.5, 0.0]; }; };";
#else
static const char moving[] =
    "wall = { bed = { type = \"box\"; from = [-0.06, -0.06, -0.06]; to = [0.16, 0.16, 0.0];"
    " velocity = [0.5, 0.0, 0.0]; }; };";
#endif

/* The same bed where it is, with a surface that slides. */
#if DIM == 2
static const char belt[] =
    "wall = { bed = { type = \"box\"; from = [-0.02, -0.015]; to = [0.12, 0.0];"
    " surface = [0.5, 0.0]; }; };";
#else
static const char belt[] =
    "wall = { bed = { type = \"box\"; from = [-0.06, -0.06, -0.06]; to = [0.16, 0.16, 0.0];"
    " surface = [0.5, 0.0, 0.0]; }; };";
#endif

/* r: any state; z: what the solve makes of it. */
struct solved {
    struct tank t;
    double *r, *z, gamma;
};

static void solve(struct solved *s, unsigned seed, double gamma, double tol)
{
    tank_shake(&s->t, seed, 0.2, 1, 0.01);
    s->r = tank_copy(&s->t, s->t.y);
    s->z = tank_copy(&s->t, s->t.y);
    s->gamma = gamma;
    moment_solve_tolerance(s->t.moment, tol);
    const int status = moment_solve(s->t.moment, 0.1, gamma, s->r, s->z);
    check(status == 0, "%s", moment_refusal(s->t.moment));
}

static void forget(struct solved *s)
{
    test_free(s->r);
    test_free(s->z);
}

static bool in_ranges(const struct tank *t, long i)
{
    long range[16][2];
    const int n = moment_stiff_ranges(t->moment, 16, range);

    for (int k = 0; k < n; k++)
        if (i >= range[k][0] && i < range[k][1])
            return true;
    return false;
}

/* Small against what the solve has to do: r, and gamma times the rate at r. */
static void check_solved(struct solved *s, double small)
{
    double *rate = tank_copy(&s->t, s->t.y);

    assert_int_equal(moment_eval(s->t.moment, ASK_IMPLICIT_SIDE, 0.1, s->z, rate), 0);
    for (long i = 0; i < s->t.n; i++) {
        const double left = s->z[i] - s->gamma * rate[i];
        const double size = fabs(s->z[i]) + s->gamma * fabs(rate[i]) + 1;
        check(fabs(left - s->r[i]) <= small * size, "%s: %.12g is not %.12g at gamma = %g",
              moment_entry(s->t.moment, i), left, s->r[i], s->gamma);
        check(in_ranges(&s->t, i) || s->z[i] == s->r[i], "%s is touched",
              moment_entry(s->t.moment, i));
        check(in_ranges(&s->t, i) || rate[i] == 0, "%s has an implicit side",
              moment_entry(s->t.moment, i));
    }
    test_free(rate);
}

static void check_solve(const char *water, const char *walls, const char *beam,
                        const char *effects)
{
    struct solved s;
    const double gamma[] = { 1e-5, 1e-3, beam[0] ? 2e-3 : 0.1 };

    tank_make(&s.t, water, walls, beam, effects, NULL);
    assert_true(plan_stiff(s.t.plan));
    for (int g = 0; g < 3; g++) {
        solve(&s, 3 + (unsigned)g, gamma[g], 1e-12);
        check(fabs(s.z[tank_at(&s.t, "velocity of fluid", NULL)]
                   - s.r[tank_at(&s.t, "velocity of fluid", NULL)]) > 1e-6, "nothing happened");
        check_solved(&s, 1e-8);
        forget(&s);
    }
    tank_free(&s.t);
}

static void solve_inverts_the_implicit_side(void **state)
{
    (void)state;
    check_solve(tank_water, tank_frame, "", THICK);
    check_solve(tank_water, moving, "", THICK);
    check_solve(tank_water, moving, "", THICK_PARTICLES);
    check_solve(tank_water, belt, "", THICK);
    check_solve(tank_water, "wall = { tank = { type = \"frame\"; spin = 100.0; }; };", "", THICK);
    check_solve(tank_water, belt, "", THICK_PARTICLES);
    check_solve(tank_bare_water, tank_frame, "", THICK_LAPLACIAN);
    check_solve(tank_water, tank_frame, "", "walls = \"adami\";" THICK);
    if (DIM == 2) {
        check_solve(tank_parted_water, tank_frame, tank_beam, THICK);
        check_solve(tank_parted_water, moving, tank_beam, THICK);
        check_solve(tank_parted_water, tank_frame, tank_beam, THICK_PARTICLES);
    }
}

/* A beam a hundred thousand times lighter than the water it pushes away. */
static void light_beam_takes_no_more_products(void **state)
{
    char text[512];
    long products[2];

    (void)state;
    if (DIM != 2)
        return;
    for (int k = 0; k < 2; k++) {
        struct solved s;
        const char *at = strstr(tank_beam, "1200.0");
        snprintf(text, sizeof text, "%.*s%s%s", (int)(at - tank_beam), tank_beam,
                 k ? "0.0100" : "1200.0", at + 6);
        tank_make(&s.t, tank_parted_water, tank_frame, text, THICK, NULL);
        solve(&s, 5, 1e-3, 1e-3);
        products[k] = moment_counts(s.t.moment)->products;
        forget(&s);
        tank_free(&s.t);
    }
    /* (47 and 53 when what the water does to the beam is left out of its inverse) */
    check(products[0] > 3 && products[0] <= 40 && products[1] <= 40,
          "%ld products, with a light beam %ld", products[0], products[1]);
}

/* z of r is linear but for the walls, and symmetric: x . Z y = y . Z x, masses alike. */
static void operator_is_symmetric(void **state)
{
    const struct layout_row *row;
    struct solved a;
    double xy = 0, yx = 0, *x, *zx;

    (void)state;
    tank_make(&a.t, tank_water, tank_frame, THICK, NULL);
    solve(&a, 7, 1e-3, 1e-13);
    const long at = tank_at(&a.t, "velocity of fluid", &row), n = (long)row->n * row->components;
    x = a.r;
    zx = a.z;
    a.r = tank_copy(&a.t, x);
    a.z = tank_copy(&a.t, x);
    for (long i = at; i < at + n; i++)
        a.r[i] = a.z[i] = sin(17.0 * (double)i);
    assert_int_equal(moment_solve(a.t.moment, 0.1, 1e-3, a.r, a.z), 0);
    for (long i = at; i < at + n; i++) {
        xy += x[i] * a.z[i];
        yx += a.r[i] * zx[i];
    }
    check(fabs(xy - yx) < 1e-9 * fabs(xy) && fabs(xy) > 1e-6, "x.Zy = %.12g, y.Zx = %.12g", xy, yx);
    test_free(x);
    test_free(zx);
    forget(&a);
    tank_free(&a.t);
}

static double book(const struct solved *s, int entry)
{
    const long at = tank_at(&s->t, "book", NULL) + entry;

    return s->z[at] - s->r[at];
}

/* However loosely it is solved: momentum of the water goes to solids, and the work of
 * the viscosity is what water and beams have less. */
static void books_close_when_the_solve_is_loose(void **state)
{
    struct solved s;

    (void)state;
    for (int k = 0; k < 3; k++) {
        const struct layout_row *row;
        const struct particles *all;
        double given[DIM] = { 0 }, taken[DIM] = { 0 }, work = 0;
        long at;

        tank_make(&s.t, tank_water, k == 0 ? tank_frame : k == 1 ? moving : belt, THICK, NULL);
        all = plan_particles(s.t.plan);
        solve(&s, 9, 1e-3, 3.0);
        at = tank_at(&s.t, "velocity of fluid", &row);
        for (int i = 0; i < row->n; i++)
            for (int d = 0; d < DIM; d++, at++) {
                taken[d] += all->m[i] * (s.z[at] - s.r[at]);
                work += all->m[i] * (s.z[at] - s.r[at]) * s.z[at];
            }
        for (int o = 0; o < all->objects; o++)
            for (int d = 0; d < DIM; d++)
                given[d] += plan_impulse(s.t.plan, s.z, o)[d] - plan_impulse(s.t.plan, s.r, o)[d];
        for (int d = 0; d < DIM; d++)
            check(fabs(given[d] + taken[d]) < 1e-12 && fabs(taken[d]) > 1e-5,
                  "solids get %g of momentum, water %g", given[d], taken[d]);
        /* work of the viscosity on all particles, less that of walls on the water */
        const int columns = 4; /* continuity, pressure, laminar-viscosity, density-diffusion */
        check(fabs(book(&s, 2) + book(&s, columns) - work) < 1e-11 * fabs(work) && work != 0,
              "viscosity %g, walls %g, water %g", book(&s, 2), book(&s, columns), work);
        check(book(&s, 2) < 0 && (k == 0) == (book(&s, columns) == 0), "work %g", book(&s, 2));
        forget(&s);
        tank_free(&s.t);
    }
}

/* Both sides from one pass are those from a pass for each, bit by bit. */
static void check_one_pass(struct tank *t, const double *f, const double *g)
{
    const long before = moment_counts(t->moment)->passes;
    double *both[2] = { tank_copy(t, t->y), tank_copy(t, t->y) };

    struct ask ask = ASK_ALL;

    ask.apart = both[1];
    assert_int_equal(moment_eval(t->moment, ask, 0.1, t->y, both[0]), 0);
    assert_int_equal(moment_counts(t->moment)->passes - before, 1);
    for (long i = 0; i < t->n; i++)
        check(both[0][i] == f[i] && both[1][i] == g[i], "%s: %.17g, %.17g, not %.17g, %.17g",
              moment_entry(t->moment, i), both[0][i], both[1][i], f[i], g[i]);
    test_free(both[0]);
    test_free(both[1]);
}

static void check_sides(const char *walls)
{
    struct tank t;
    double *f, *g;

    tank_make(&t, DIM == 2 ? tank_parted_water : tank_water, walls, DIM == 2 ? tank_beam : "",
              THICK, NULL);
    tank_shake(&t, 5, 0.2, 1, 0.02);
    f = tank_copy(&t, t.y);
    g = tank_copy(&t, t.y);
    assert_int_equal(moment_eval(t.moment, ASK_EXPLICIT_SIDE, 0.1, t.y, f), 0);
    assert_int_equal(moment_eval(t.moment, ASK_IMPLICIT_SIDE, 0.1, t.y, g), 0);
    assert_int_equal(moment_eval(t.moment, ASK_ALL, 0.1, t.y, t.ydot), 0);
    for (long i = 0; i < t.n; i++)
        check(fabs(f[i] + g[i] - t.ydot[i]) <= 1e-10 * (fabs(f[i]) + fabs(g[i]) + 1),
              "%s: %g + %g is not %g", moment_entry(t.moment, i), f[i], g[i], t.ydot[i]);
    check_one_pass(&t, f, g);
    check(strcmp(plan_viscous(t.plan), "effects.laminar-viscosity") == 0, "the implicit part");
    check(plan_halves(t.plan) != NULL, "two halves");
    test_free(f);
    test_free(g);
    tank_free(&t);
}

static void sides_add_up(void **state)
{
    (void)state;
    check_sides(moving);
    check_sides(belt);
}

/* Positions after a while, by one method. */
static double *run(struct tank *t, const char *name, const char *effects, double until)
{
    struct method_def def = method_def_default();
    const struct method *m;
    struct method_step step;
    void *self;
    double *y;

    tank_make(t, DIM == 2 ? tank_parted_water : tank_water, tank_frame, DIM == 2 ? tank_beam : "",
              effects, NULL);
    def.tol = 1e-6;
    assert_int_equal(method_find(name, &def, &m), 0);
    assert_int_equal(m->create(m, &def, t->moment, 0, t->y, &self), 0);
    do
        check(m->step(self, until, &step) == 0, "%s", status_message());
    while (step.t < until);
    y = tank_copy(t, m->state(self));
    m->free(&self);
    return y;
}

static void both_sides_give_the_same_motion(void **state)
{
    struct tank t, u;
    const struct layout_row *row;
    double *x, *y, most = 0, way = 0;
    long at;

    (void)state;
    x = run(&t, "cks43", EFFECTS("3.0", "explicit"), 0.02);
    y = run(&u, "imex3", EFFECTS("3.0", "implicit"), 0.02);
    at = tank_at(&t, "position of fluid", &row);
    for (long i = at; i < at + (long)row->n * row->components; i++) {
        most = fmax(most, fabs(x[i] - y[i]));
        way = fmax(way, fabs(x[i] - t.y[i]));
    }
    check(most < 1e-3 * way, "positions differ by %g m of a way of %g m", most, way);
    check(moment_counts(u.moment)->solves > 0 && moment_counts(t.moment)->products == 0, "no solves");
    test_free(x);
    test_free(y);
    tank_free(&t);
    tank_free(&u);
}

/* The bound of explicit steps forgets the viscosity that is implicit. */
static void bound_is_that_of_the_side(void **state)
{
    struct limit with[2], without[2];
    struct tank t;

    (void)state;
    tank_make(&t, tank_water, tank_frame, THICK, NULL);
    moment_limit(t.moment, 0, t.y, true, with);
    moment_limit(t.moment, 0, t.y, false, without);
    check(strcmp(with[1].part, "laminar-viscosity") == 0, "%s decays fastest", with[1].part);
    check(strcmp(without[1].part, "density-diffusion") == 0, "%s decays fastest",
          without[1].part);
    tank_free(&t);
}

/* No answer is a refusal with a reason, not a failure. */
static void solve_refuses_what_is_not_finite(void **state)
{
    struct tank t;
    double *r, *z;

    (void)state;
    tank_make(&t, tank_water, tank_frame, THICK, NULL);
    r = tank_copy(&t, t.y);
    z = tank_copy(&t, t.y);
    r[tank_at(&t, "velocity of fluid", NULL)] = NAN;
    assert_int_equal(moment_solve(t.moment, 0, 1e-3, r, z), STATUS_FAILED);
    check(strstr(moment_refusal(t.moment), "found no velocities"), "%s", moment_refusal(t.moment));
    assert_string_equal(status_message(), "");
    r[tank_at(&t, "velocity of fluid", NULL)] = 0;
    r[tank_at(&t, "position of fluid", NULL)] = NAN;
    assert_int_equal(moment_solve(t.moment, 0, 1e-3, r, z), STATUS_FAILED);
    check(strstr(moment_refusal(t.moment), "not finite"), "%s", moment_refusal(t.moment));
    check(moment_counts(t.moment)->refused == 2, "%ld refused", moment_counts(t.moment)->refused);
    test_free(r);
    test_free(z);
    tank_free(&t);
}

static void two_viscosities_are_not_solved_for(void **state)
{
    struct tank t;
    char text[2048];

    (void)state;
    snprintf(text, sizeof text, "%s%s%s", tank_bare_water, tank_frame,
             "kernel = { viscosity = \"viscosity-log\"; };"
             "effects = { continuity = { }; pressure = { };"
             " laminar-viscosity = { side = \"implicit\"; };"
             " laplacian-viscosity = { side = \"implicit\"; }; };");
    assert_int_equal(tank_try(&t, text), STATUS_BAD_SCENE);
    check(strstr(status_message(), "one viscosity is solved for"), "%s", status_message());
    tank_free(&t);
    status_clear();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(solve_inverts_the_implicit_side),
        cmocka_unit_test(light_beam_takes_no_more_products),
        cmocka_unit_test(operator_is_symmetric),
        cmocka_unit_test(books_close_when_the_solve_is_loose),
        cmocka_unit_test(sides_add_up),
        cmocka_unit_test(both_sides_give_the_same_motion),
        cmocka_unit_test(bound_is_that_of_the_side),
        cmocka_unit_test(solve_refuses_what_is_not_finite),
        cmocka_unit_test(two_viscosities_are_not_solved_for),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
