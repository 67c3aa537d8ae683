/* time-orders.c -- the order of every method, measured on the program's own water and
 * beams, beside the one it claims: a row of method_table that is added later is measured
 * here without a change to this file.
 *
 * Six problems, smooth while they run: no pair of particles crosses the edge of the
 * kernel (its support lies between two distances of the lattice), no walls, no switches,
 * and all vibrations of the beam are resolved.  Two errors at constant steps, NAME@1e-4s,
 * give the order, and are taken against Runge-Kutta of order 8, which agrees with another
 * method.  The table of what came out is in the log. */
#include "../physics/tank.h"

#include "base/status.h"
#include "time/method.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WHERE                                                                            \
    "dimension = 2; until = 1.0; spacing = 1e-2; gravity = [0.0, 0.0];"                  \
    "domain = { from = [0.0, 0.0]; to = [0.2, 0.2]; }; kernel = { support = 2.5; };"     \
    "fluid = { drop = { type = \"box\"; from = [0.07, 0.07]; to = [0.12, 0.12]; }; };"
#define DROP WHERE "eos = { c0 = 10.0; };"
#define SOLVED                                                                           \
    WHERE "eos = { type = \"look-ahead\"; c0 = 30.0; tau = 0.2; residual = 1e-14; }; tol = 1e-12;"  \
    "reference = { speed = 1.0; };"
/* The default turns from pressure to none within a thousandth of a density. */
#define SMOOTH "walls = \"own-density\";"
#define MOVES "effects = { continuity = { }; pressure = { }; };"
#define DISSIPATES                                                                       \
    "effects = { continuity = { }; pressure = { }; laminar-viscosity = { mu = 5.0; };"   \
    " density-diffusion = { delta = 0.05; }; };"
#define BEAM_THAT(is)                                                                    \
    "beam = { plate = { at = [0.135, 0.06]; length = 0.07; thickness = 4e-3; E = 1e7;"    \
    " density = 1200.0; elements = 2; layers = 3; alpha = 3.0; beta = 1e-4;"             \
    " tip_force = 2.0; " is " }; };"
#define BEAM BEAM_THAT("")

enum problem_name { WATER, DISSIPATION, BEAM_ALONE, COUPLED, AHEAD, PREDICTED, PROBLEMS };

static const struct {
    const char *name, *text[3];
    double end; /* [s] */
    const char *check;
    int steps; /* of the check: of order 8 as few as of the reference */
} problem[PROBLEMS] = {
    { "water", { DROP, MOVES, "" }, 4e-3, "gsl-rk8pd", 512 },
    { "dissipation", { DROP, DISSIPATES, "" }, 4e-3, "gsl-rk8pd", 512 },
    { "beam", { "dimension = 2; until = 1.0;", BEAM, "" }, 1e-2, "imex5", 2048 },
    { "coupled", { DROP SMOOTH, MOVES, BEAM }, 4e-3, "imex5", 2048 },
    { "ahead", { SOLVED SMOOTH, MOVES, BEAM }, 4e-3, "imex5", 2048 },
    { "predicted", { SOLVED SMOOTH, MOVES, BEAM_THAT("response = \"predicted\";") }, 4e-3,
      "gsl-rk8pd", 512 },
};

/* Where what is measured is not what the method's row says; PROBLEMS: on all of them. */
static const struct {
    const char *method;
    enum problem_name problem;
    double least, most;
    const char *why;
} other[] = {
    { "dv", DISSIPATION, 1, 1, "viscosity and diffusion see values half a step old" },
    { "cks43", PROBLEMS, 3, 4, "what is linear it does in order 4, and the rest of its error of "
                               "order 3 is small: it shows below 1e-10 only" },
};

struct measured {
    struct tank tank;
    double *exact, *y;
};

/* Largest difference of entries in units of their scales; not of the book's. */
static double far(const struct tank *t, const double *y, const double *z)
{
    const struct layout *l = plan_layout(t->plan);
    double most = 0;

    for (int i = 0; i < l->rows; i++) {
        const struct layout_row *r = &l->row[i];
        for (long k = r->offset; k < r->offset + (long)r->n * r->components; k++)
            if (r->scale > 0 && !(fabs(y[k] - z[k]) / r->scale <= most))
                most = fabs(y[k] - z[k]) / r->scale;
    }
    return most;
}

/* From t->y to y at end; false when a step has no answer. */
static bool run(struct tank *t, const struct method *m, const struct method_def *def, double end,
                double *y)
{
    struct method_step step = { .t = 0 };
    void *self;

    status_clear();
    if (m->create(m, def, t->moment, 0, t->y, &self) != STATUS_DONE)
        fail_msg("%s", status_message());
    while (step.t < end && m->step(self, end, &step) == STATUS_DONE)
        check(def->seconds == 0 || fabs(step.h / def->seconds - 1) < 1e-6, "%s: a step of %g s "
              "instead of %g", m->name, step.h, def->seconds);
    memcpy(y, m->state(self), (size_t)t->n * sizeof *y);
    m->free(&self);
    return step.t == end;
}

/* Error after n equal steps. */
static double error_of(struct measured *p, const struct method *m, double end, int n)
{
    struct method_def def = method_def_default();

    def.seconds = end / n;
    return run(&p->tank, m, &def, end, p->y) ? far(&p->tank, p->y, p->exact) : NAN;
}

static void solve(struct measured *p, const char *name, double end, int n, double *y)
{
    struct method_def def = method_def_default();
    const struct method *m;

    assert_int_equal(method_find(name, &def, &m), STATUS_DONE);
    def.seconds = end / n;
    check(run(&p->tank, m, &def, end, y), "%s: %s", name, status_message());
}

static void make(struct measured *p, enum problem_name which)
{
    const double end = problem[which].end;
    const char *const *text = problem[which].text;

    tank_make(&p->tank, text[0], text[1], text[2], NULL);
    if (which != BEAM_ALONE)
        tank_shake(&p->tank, 7, 0.03, 0.2, 1e-3);
    p->exact = tank_copy(&p->tank, p->tank.y);
    p->y = tank_copy(&p->tank, p->tank.y);
    solve(p, "ARKODE_FEHLBERG_13_7_8", end, 512, p->exact);
    solve(p, problem[which].check, end, problem[which].steps, p->y);
    check(far(&p->tank, p->y, p->exact) < 1e-11, "%s: references differ by %g",
          problem[which].name, far(&p->tank, p->y, p->exact));
    check(far(&p->tank, p->tank.y, p->exact) > 0.3, "%s: nothing happens", problem[which].name);
}

static void end(struct measured *p)
{
    test_free(p->exact);
    test_free(p->y);
    tank_free(&p->tank);
}

/* High orders show between coarse steps and rounding: more and more steps until the
 * error is below 1e-11.  Low ones need steps as short as is cheap. */
static double measure(struct measured *p, const struct method *m, double t_end, double *error)
{
    const int most = m->order == 1 ? 2048 : 512;
    double before = NAN, order = NAN, n = m->order > 3 ? (m->order > 6 ? 2 : 8) : most / 2;

    for (double last = n; n <= most; last = n, n = ceil(n * (m->order > 3 ? M_SQRT2 : 2))) {
        *error = error_of(p, m, t_end, (int)n);
        order = log(before / *error) / log(n / last);
        before = *error;
        if (*error < 1e-11 && isfinite(order))
            break;
    }
    return order;
}

static bool claimed(const struct method *m, enum problem_name which, double got)
{
    const double slack = m->order > 6 ? 0.75 : 0.25;
    double least = m->order, most = m->order;

    for (size_t i = 0; i < sizeof other / sizeof other[0]; i++)
        if ((other[i].problem == which || other[i].problem == PROBLEMS)
            && strcmp(other[i].method, m->name) == 0) {
            least = other[i].least;
            most = other[i].most;
        }
    return got > least - slack && got < most + slack;
}

/* Their fluid is incompressible: the exact solution here is none of their equations.  What is
 * compressed at the start they take back in one step, however short, so that states have no
 * limit for short steps; mps refuses the pressure of 2e-6 s here. */
/* mri-rigid wants rigid bodies, of which the toy has none: tests/mri-rigid.sh has its order. */
static bool solves_another_problem(const struct method *m)
{
    return strcmp(m->name, "mps") == 0 || strcmp(m->name, "pcisph") == 0
           || strcmp(m->name, "mri-rigid") == 0;
}

/* Where a solve in each evaluation costs a hundred of others, some methods stand for
 * all of it; with STIFFWATER_LONG imex2, too, which needs the most steps. */
static bool stands_for_others(const struct method *m)
{
    static const char *const few[] = { "imex2", "imex3", "imex4", "cks43" };

    for (size_t i = getenv("STIFFWATER_LONG") ? 0 : 1; i < sizeof few / sizeof few[0]; i++)
        if (strcmp(few[i], m->name) == 0)
            return true;
    return false;
}

static bool fits(const struct measured *p, enum problem_name which, const struct method *m)
{
    if (which >= AHEAD && !stands_for_others(m))
        return false;
    return !solves_another_problem(m) && m->order > 0 && !m->varies && !(m->serves && m->serves(p->tank.plan));
}

static bool served[128]; /* by any problem */

static void orders_on(enum problem_name which)
{
    struct measured p;
    int wrong = 0;

    make(&p, which);
    for (int i = 0; method_table[i]; i++) {
        const struct method *m = method_table[i];
        double error;
        if (!fits(&p, which, m))
            continue;
        served[i] = true;
        const double got = measure(&p, m, problem[which].end, &error);
        const bool right = claimed(m, which, got);
        printf("# %-12s %-28s order %.2f, nominal %d, at an error of %.1e%s\n",
               problem[which].name, m->name, got, m->order, error, right ? "" : ": WRONG");
        wrong += !right;
    }
    end(&p);
    check(wrong == 0, "%s: %d methods have another order than their rows say", problem[which].name,
          wrong);
}

static void on_water(void **state)
{
    (void)state;
    orders_on(WATER);
}

static void on_water_that_dissipates(void **state)
{
    (void)state;
    orders_on(DISSIPATION);
}

static void on_a_beam(void **state)
{
    (void)state;
    orders_on(BEAM_ALONE);
}

static void on_water_with_a_beam(void **state)
{
    (void)state;
    orders_on(COUPLED);
}

static void on_a_pressure_that_looks_ahead(void **state)
{
    (void)state;
    for (enum problem_name which = AHEAD; which <= PREDICTED; which++)
        orders_on(which);
}

/* Methods whose order changes, or which have no steps of one length: a hundredth of the
 * tolerance, between a fifth and a thousandth of the error. */
static void others_follow_the_tolerance(void **state)
{
    struct measured p;

    (void)state;
    make(&p, DISSIPATION);
    for (int i = 0; method_table[i]; i++) {
        const struct method *m = method_table[i];
        struct method_def def = method_def_default();
        double error[3];
        if ((m->order > 0 && !m->varies) || (m->serves && m->serves(p.tank.plan)))
            continue;
        served[i] = true;
        for (int k = 0; k < 3; k++) {
            def.tol = pow(10, -3 - 2 * k);
            assert_true(run(&p.tank, m, &def, problem[DISSIPATION].end, p.y));
            error[k] = far(&p.tank, p.y, p.exact);
        }
        printf("# %-12s %-28s errors %.1e %.1e %.1e at tol 1e-3 1e-5 1e-7\n",
               problem[DISSIPATION].name, m->name, error[0], error[1], error[2]);
        for (int k = 0; k < 2; k++)
            check(error[k + 1] < error[k] / 5 && error[k + 1] > error[k] / 1000,
                  "%s: errors %g and %g", m->name, error[k], error[k + 1]);
    }
    end(&p);
}

static void no_method_is_left_out(void **state)
{
    (void)state;
    for (int i = 0; method_table[i]; i++)
        check(served[i] || solves_another_problem(method_table[i]), "%s has not been measured: it serves none of these problems",
              method_table[i]->name);
}

/* A constant step is not shortened: it fails, and says how long it was. */
static void too_long_a_step_says_so(void **state)
{
    struct limit limit[2];
    struct measured p;

    (void)state;
    make(&p, WATER);
    moment_limit(p.tank.moment, 0, p.tank.y, false, limit);
    for (int i = 0; method_table[i]; i++) {
        const struct method *m = method_table[i];
        struct method_def def = method_def_default();
        def.seconds = 20 / limit[0].rate;
        if (!fits(&p, WATER, m) || !m->adaptive) /* rules may halve the step */
            continue;
        assert_false(run(&p.tank, m, &def, 100 * def.seconds, p.y));
        check(strstr(status_message(), "constant step")
                  && strstr(status_message(), "longer than the plan's stability bound")
                  && strstr(status_message(), m->name) && strlen(status_message()) < 700
                  && status_has_cause() && status_has_remedy(),
              "%s: \"%s\"", m->name, status_message());
        for (long k = 0; k < p.tank.n; k++)
            assert_true(isfinite(p.y[k]));
    }
    end(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(on_water),
        cmocka_unit_test(on_water_that_dissipates),
        cmocka_unit_test(on_a_beam),
        cmocka_unit_test(on_water_with_a_beam),
        cmocka_unit_test(on_a_pressure_that_looks_ahead),
        cmocka_unit_test(others_follow_the_tolerance),
        cmocka_unit_test(no_method_is_left_out),
        cmocka_unit_test(too_long_a_step_says_so),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
