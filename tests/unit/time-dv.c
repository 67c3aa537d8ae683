/* time-dv.c -- the staggered Verlet method "dv" on the toy: formulas and bodies. */
#include "time-dv.h"
#include "time-tests.h"

struct dv *toy_dv(struct moment *p, double tol, double h)
{
    return toy_method(p, "dv", tol, h);
}

void toy_dv_free(struct dv *x)
{
    void *self = x;

    toy_method_free(&self);
}

/* --- the formulas -------------------------------------------------------- */

/* Errors of the state and of the book at t = 2, by steps of length h. */
static void final_errors(double stiffness, double drag, bool plain, double h, double error[2])
{
    struct moment p;
    double exact[64];
    int steps;

    toy_make(&p, stiffness, 0.5);
    p.drag = drag;
    p.plain = plain;
    struct dv *x = toy_dv(&p, 1e6, h);
    assert_int_equal(toy_run(x, 2, &steps), STATUS_DONE);
    near(steps, 2 / h, 1.5);
    toy_exact(&p, 2, exact);
    error[0] = toy_error(&p, 2, x->frame.y);
    error[1] = fabs(x->frame.y[layout_at(&p.layout, p.row_book)]
                    - exact[layout_at(&p.layout, p.row_book)]);
    toy_dv_free(x);
}

static void order(double stiffness, double drag, bool plain, int which, double least, double most)
{
    double coarse[2], fine[2];

    final_errors(stiffness, drag, plain, 0.02, coarse);
    final_errors(stiffness, drag, plain, 0.005, fine);
    const double got = log2(coarse[which] / fine[which]) / 2;
    if (!(fine[which] > 1e-9 && got > least && got < most))
        fail_msg("stiffness %g, drag %g: errors %g %g, order %g", stiffness, drag, coarse[which],
                 fine[which], got);
}

void dv_is_of_order_two_without_dissipation(void **state)
{
    (void)state;
    order(0, 0, true, 0, 1.9, 2.2);
    order(4, 0, true, 0, 1.9, 2.2);
    order(1e6, 0, true, 0, 1.9, 2.2);
    order(0, 0.5, true, 0, 0.8, 1.3);  /* velocities half a step old in u' */
    order(0, 0, false, 0, 0.8, 1.3);   /* densities half a step old in rho' */
}

/* book' = x u: with the velocity in the middle of the kick; also inside the step. */
void dv_books_the_work_of_a_kick(void **state)
{
    struct method_step step;
    struct moment p;
    double y[64], exact[64], last[64];

    (void)state;
    order(0, 0, true, 1, 1.9, 2.4);
    toy_make(&p, 0, 0);
    p.plain = true;
    struct dv *x = toy_dv(&p, 1e6, 0.01);
    for (int k = 0; k < 40; k++)
        assert_int_equal(toy_found()->step(x, 1, &step), STATUS_DONE);
    assert_int_equal(paced_at(x, step.t - 0.0025, y), STATUS_DONE);
    toy_exact(&p, step.t - 0.0025, exact);
    toy_exact(&p, step.t, last);
    for (long i = 0; i < moment_size(&p); i++) /* a line may be 1e-5 off, that of the book is */
        near(y[i] - x->frame.y[i], exact[i] - last[i], i + 1 < moment_size(&p) ? 2e-7 : 1e-5);
    toy_dv_free(x);
}

static double way_back(double drag, bool plain)
{
    struct moment p;
    double exact[64], most = 0;

    toy_make(&p, 0, 0);
    p.drag = drag;
    p.plain = plain;
    struct dv *x = toy_dv(&p, 1, 0);
    toy_exact(&p, 0, exact);
    assert_int_equal(dv_begin(&x->frame), STATUS_DONE);
    dv_steps(x, 50, 0.04);
    assert_true(fabs(x->frame.y[0] - exact[0]) > 0.5);
    assert_int_equal(moment_eval(&p, ASK_HALF(ASK_DENSITIES, 0), x->frame.t, x->frame.y, x->d.f[1]), STATUS_DONE);
    dv_steps(x, 50, -0.04);
    for (long i = 0; i < moment_size(&p) - 1; i++)
        most = fmax(most, fabs(x->frame.y[i] - exact[i]));
    toy_dv_free(x);
    return most;
}

void dv_is_symmetric_in_time(void **state)
{
    (void)state;
    assert_true(way_back(0, true) < 1e-11);
    assert_true(way_back(0.5, true) > 1e-4);
    assert_true(way_back(0, false) > 1e-5);
}

/* --- bodies -------------------------------------------------------------- */

/* A stiff body lies where the last load bends it, to where A looks for it. */
void dv_shows_bodies_under_the_last_load(void **state)
{
    struct method_step step;
    struct moment p;

    (void)state;
    toy_make(&p, 1e8, 1e3);
    struct dv *x = toy_dv(&p, 1e6, 0.01);
    for (int k = 0; k < 99; k++) {
        const long q = layout_at(&p.layout, p.row_q);
        double exact[64];
        assert_int_equal(toy_found()->step(x, 1, &step), STATUS_DONE);
        toy_exact(&p, step.t - step.h / 2, exact);
        near(x->half[q], exact[q], 0.02 * 1e-8);
    }
    toy_dv_free(x);
}

/* Of a body that swings, plucked by 0.5 at a frequency of 20/s. */
void dv_estimates_the_error_of_bodies(void **state)
{
    const double h = 0.002, w = 20, cube = h * h * h / 24;
    struct method_step step;
    struct moment p;
    double y[64];

    (void)state;
    toy_make(&p, w * w, 0);
    struct dv *x = toy_dv(&p, 1e6, h);
    toy_exact(&p, 0, y);
    y[layout_at(&p.layout, p.row_q)] += 0.5;
    assert_int_equal(toy_found()->restart(x, 0, y, NULL), STATUS_DONE);
    for (int k = 0; k < 12; k++)
        assert_int_equal(toy_found()->step(x, 1, &step), STATUS_DONE);
    assert_true(fabs(step.h - h) < 1e-9);
    const double *e = vector_data(x->frame.error), t = step.t;
    near(e[layout_at(&p.layout, p.row_q)], cube * 0.5 * pow(w, 3) * sin(w * (t - h)),
         0.02 * cube * pow(w, 3));
    near(e[layout_at(&p.layout, p.row_v)], cube * 0.5 * pow(w, 4) * cos(w * (t - 1.5 * h)),
         0.02 * cube * pow(w, 4));
    toy_dv_free(x);
}

static int stiff_steps(double stiffness)
{
    struct moment p;
    int steps;

    toy_make(&p, stiffness, 1);
    p.plain = true;
    p.wave = 0;
    struct dv *x = toy_dv(&p, 1e-5, 0);
    assert_int_equal(toy_run(x, 5, &steps), STATUS_DONE);
    if (!(toy_error(&p, 5, x->frame.y) < 5e-3))
        fail_msg("stiffness %g: error %g", stiffness, toy_error(&p, 5, x->frame.y));
    assert_true(p.counts.solves >= 3 * steps);
    toy_dv_free(x);
    return steps;
}

void dv_steps_do_not_depend_on_stiffness(void **state)
{
    const int stiff = stiff_steps(1e6);

    (void)state;
    for (double s = 1e7; s < 2e9; s *= 10)
        if (abs(stiff_steps(s) - stiff) > stiff / 6)
            fail_msg("stiffness %g: %d steps, not %d", s, stiff_steps(s), stiff);
}

/* q at t = 1 of a body plucked by 0.5. */
static double plucked(const char *name, double tol, int *steps)
{
    struct moment p;
    double y[64];

    toy_make(&p, 400, 1);
    p.plain = true;
    p.wave = 0;
    void *self = toy_method(&p, name, tol, 0);
    toy_exact(&p, 0, y);
    y[layout_at(&p.layout, p.row_q)] += 0.5;
    assert_int_equal(toy_found()->restart(self, 0, y, NULL), STATUS_DONE);
    assert_int_equal(toy_run(self, 1, steps), STATUS_DONE);
    const double q = toy_found()->state(self)[layout_at(&p.layout, p.row_q)];
    toy_method_free(&self);
    return q;
}

void dv_resolves_vibrations_of_bodies(void **state)
{
    int steps;
    const double exact = plucked("imex5", 1e-8, &steps);
    const double coarse = plucked("dv", 1e-3, &steps) - exact,
                 fine = plucked("dv", 1e-6, &steps) - exact;

    (void)state;
    if (!(fabs(coarse) < 0.05 && fabs(fine) < 1e-3 && fabs(coarse) > 30 * fabs(fine)))
        fail_msg("errors %g and %g", coarse, fine);
}

void dv_needs_halves(void **state)
{
    struct method_def def = method_def_default();
    const struct method *m;
    struct moment p;

    (void)state;
    toy_make(&p, 0, 0);
    assert_int_equal(method_find("dv", &def, &m), STATUS_DONE);
    assert_null(m->serves(moment_plan(&p)));
    p.whole = "all is one";
    assert_string_equal(m->serves(moment_plan(&p)), "all is one");
}
