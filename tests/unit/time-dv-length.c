/* time-dv-length.c -- how long the steps of "dv" are, on the toy. */
#include "time-tests.h"

/* Of x, u and rho in a step from the exact solution, against the real one. */
void dv_estimates_its_error(void **state)
{
    const double h = 0.02;
    struct moment p;
    double exact[64];

    (void)state;
    toy_make(&p, 0, 0);
    p.plain = true;
    struct dv *x = toy_dv(&p, 1, 0);
    assert_int_equal(dv_begin(&x->frame), STATUS_DONE);
    for (int k = 0; k < DV_POINTS; k++) { /* rates of the exact solution */
        x->a.t[k] = 1 + h * (0.5 - k);
        x->d.t[k] = 1 + h * (1 - k);
        toy_exact(&p, x->a.t[k], exact);
        assert_int_equal(moment_eval(&p, ASK_HALF(ASK_VELOCITIES, 0), x->a.t[k], exact, x->a.f[k]), STATUS_DONE);
        toy_exact(&p, x->d.t[k], exact);
        assert_int_equal(moment_eval(&p, ASK_HALF(ASK_DENSITIES, 0), x->d.t[k], exact, x->d.f[k]), STATUS_DONE);
    }
    x->a.known = x->d.known = 2;
    const double e = dv_error(&x->frame, h), cube = h * h * h / 24;
    const double *each = vector_data(x->frame.error);
    for (int i = 0; i < TOY_PARTICLES; i++) {
        near(each[p.layout.row[p.row_x].offset + i], -cube * cos(1 + i), 0.03 * cube);
        near(each[p.layout.row[p.row_u].offset + i], cube * sin(1 + i), 0.03 * cube);
        near(each[p.layout.row[p.row_rho].offset + i], 0.1 * cube * sin(1 + i), 3e-3 * cube);
    }
    near(e, cube, 0.03 * cube); /* sin 2 and cos 3 are not far from 1 */
    toy_dv_free(x);
    double last = 1;
    for (double tol = 1e-3; tol > 1e-8; tol /= 100) {
        int steps;
        toy_make(&p, 0, 0);
        p.plain = true;
        x = toy_dv(&p, tol, 0);
        assert_int_equal(toy_run(x, 5, &steps), STATUS_DONE);
        const double error = toy_error(&p, 5, x->frame.y);
        if (!(error < 30 * pow(tol, 2.0 / 3) && error < last / 8 && steps < 30 / cbrt(tol)))
            fail_msg("tol %g: error %g, %d steps", tol, error, steps);
        last = error;
        toy_dv_free(x);
    }
}

void dv_starts_carefully(void **state)
{
    struct method_step step;
    struct moment p;

    (void)state;
    toy_make(&p, 0, 0);
    p.wave = 100;
    struct dv *x = toy_dv(&p, 1e-2, 0);
    assert_int_equal(toy_found()->step(x, 10, &step), STATUS_DONE);
    near(step.h, 0.3 * 0.95 * 2 / 100, 1e-9);
    assert_string_equal(step.where, "pressure, particle 1");
    toy_dv_free(x);
    toy_make(&p, 4, 0.5);
    p.wave = 0; /* no bound is known: no entry changes by more than tol */
    x = toy_dv(&p, 1e-2, 0);
    assert_int_equal(toy_found()->step(x, 10, &step), STATUS_DONE);
    assert_true(step.h < 0.0101 && step.h > 0.002);
    assert_string_equal(step.where, "first step");
    for (int k = 0; k < 60; k++)
        assert_int_equal(toy_found()->step(x, 1e3, &step), STATUS_DONE);
    assert_int_equal(step.limiter, METHOD_ERROR);
    assert_true(step.h > 0.3 && strstr(step.where, "number"));
    toy_dv_free(x);
    toy_make(&p, 0, 0); /* nor is there a body */
    p.wave = 0;
    x = toy_dv(&p, 1e-2, 0);
    assert_int_equal(toy_found()->step(x, 10, &step), STATUS_DONE);
    assert_true(step.h < 0.0101 && step.h > 0.002);
    toy_dv_free(x);
}

static double bound(double wave, double decay, char where[96])
{
    struct method_step step;
    struct moment p;

    toy_make(&p, 0, 0);
    p.wave = wave;
    p.decay = decay;
    struct dv *x = toy_dv(&p, 1e-2, 0);
    for (int k = 0; k < 20; k++)
        assert_int_equal(toy_found()->step(x, 10, &step), STATUS_DONE);
    assert_int_equal(step.limiter, METHOD_STABILITY);
    strcpy(where, step.where);
    toy_dv_free(x);
    return step.h;
}

/* A wave with damping by these formulas: does it grow? */
static bool grows(double w, double d, double h)
{
    double v = 1, r = 1;

    for (int k = 0; k < 4000; k++) {
        v += h * (-w * r - d * v);
        r += h * w * v;
    }
    return !(hypot(v, r) < 100);
}

void dv_keeps_waves_and_decay_stable(void **state)
{
    static const double rate[][2] = { { 500, 0 }, { 500, 250 }, { 500, 900 }, { 0, 5000 } };
    char where[96];

    (void)state;
    for (int i = 0; i < 4; i++) {
        const double w = rate[i][0], d = rate[i][1], h = bound(w, d, where) / 0.95;
        if (grows(w, d, 0.999 * h) || !grows(w, d, 1.001 * h))
            fail_msg("waves %g/s, decay %g/s: %g s is not the bound", w, d, h);
        assert_string_equal(where, d > w ? "viscosity" : "pressure, particle 1");
    }
}

/* Lengths of three steps after 40 and perhaps one that is cut short. */
static void steps_after(bool cut, double h[3])
{
    struct method_step step;
    struct moment p;
    double y[64];

    toy_make(&p, 4, 0.5);
    p.wave = 0;
    struct dv *x = toy_dv(&p, 1e-4, 0);
    for (int k = 0; k < 40; k++)
        assert_int_equal(toy_found()->step(x, 100, &step), STATUS_DONE);
    const long rejected = step.rejected;
    if (cut) {
        assert_int_equal(toy_found()->step(x, step.t + 1e-6 * step.h, &step), STATUS_DONE);
        assert_int_equal(step.limiter, METHOD_OUTPUT);
        assert_int_equal(toy_found()->at(x, step.t - 0.4 * step.h, y), STATUS_DONE);
        for (long i = 0; i < moment_size(&p); i++)
            near(y[i], x->frame.y[i], 1e-6);
    }
    for (int k = 0; k < 3; k++) {
        assert_int_equal(toy_found()->step(x, 100, &step), STATUS_DONE);
        h[k] = step.h;
    }
    assert_int_equal(step.rejected, rejected);
    toy_dv_free(x);
}

/* A step cut short at the end of a segment leaves neither its length nor its rates:
 * densities half a step old make differences that, over a millionth of a step, would
 * be taken for enormous rates of change. */
void dv_is_not_disturbed_by_a_short_step(void **state)
{
    double with[3], without[3];

    (void)state;
    steps_after(true, with);
    steps_after(false, without);
    for (int k = 0; k < 3; k++)
        if (!(fabs(with[k] / without[k] - 1) < 0.15))
            fail_msg("step %d is %g s, not %g s", k, with[k], without[k]);
}

/* A solve that fails, a density that is off: half the step, state and rates restored. */
void dv_shortens_steps_without_an_answer(void **state)
{
    struct method_step step;
    struct moment p;

    (void)state;
    toy_make(&p, 4, 0.5);
    p.solvable = 1e-3;
    struct dv *x = toy_dv(&p, 1, 0.05);
    assert_int_equal(toy_found()->step(x, 1, &step), STATUS_DONE);
    near(step.h, 0.05 / 32, 1e-6); /* h/2 is the largest gamma */
    assert_int_equal(step.rejected, 5);
    assert_true(toy_error(&p, step.t, x->frame.y) < 1e-5);
    assert_string_equal(status_message(), "");
    p.solvable = 1e-12;
    assert_int_equal(toy_found()->step(x, 1, &step), STATUS_FAILED);
    assert_non_null(strstr(status_message(), "gamma is"));
    assert_true(toy_error(&p, step.t, x->frame.y) < 1e-5);
    toy_dv_free(x);
    toy_make(&p, 0, 0);
    p.refuse_after = 1e-9;
    x = toy_dv(&p, 1, 0);
    p.wave = 1e-3;
    x->frame.def.h_min = 1;
    assert_int_equal(toy_found()->step(x, 1, &step), STATUS_FAILED);
    assert_non_null(strstr(status_message(), "density of particle 0"));
    toy_dv_free(x);
}
