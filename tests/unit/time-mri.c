/* time-mri.c -- the method "mri" on the toy: bodies in steps of their own within those of
 * the water.  Its order, dense output, refusals and bits: time.c. */
#include "time-tests.h"

#include "time/mri.h"

static struct mri *toy_mri(struct moment *p, double stiffness, double tol, double h)
{
    toy_make(p, stiffness, 0.5);
    return toy_method(p, "mri@0.25", tol, h);
}

static void end(struct mri *m)
{
    void *self = m;

    toy_method_free(&self);
}

static double error_at(double stiffness, double tol, double h, double t_end)
{
    struct moment p;
    struct mri *m = toy_mri(&p, stiffness, tol, h);
    int steps;
    double error;

    assert_int_equal(toy_run(m, t_end, &steps), STATUS_DONE);
    near(steps, t_end / h, 2.5);
    error = toy_error(&p, t_end, toy_found()->state(m));
    end(m);
    return error;
}

void mri_is_of_order_three(void **state)
{
    (void)state;
    for (int tight = 0; tight < 2; tight++) {
        const double tol = tight ? 1e-9 : 1e6;
        const double e1 = error_at(4, tol, 0.1, 2), e2 = error_at(4, tol, 0.05, 2),
                     e4 = error_at(4, tol, 0.025, 2);
        if (!(e4 > 1e-10 && fabs(log2(e1 / e2) - 3) < 0.4 && fabs(log2(e2 / e4) - 3) < 0.2))
            fail_msg("errors %g %g %g, orders %.2f %.2f", e1, e2, e4, log2(e1 / e2),
                     log2(e2 / e4));
    }
}

/* Stages at 0, 1/3, 3/4 and 1 of a step: within each, steps no longer than `substep`. */
void mri_keeps_to_substep(void **state)
{
    struct moment p;
    struct mri *m = toy_mri(&p, 4, 1e6, 0.06);
    struct method_step step;

    (void)state;
    for (int k = 0; k < 2; k++) {
        const long solves = p.counts.solves;
        assert_int_equal(toy_found()->step(m, 10, &step), STATUS_DONE);
        near(step.h, 0.06, 1e-12);
        near((double)(p.counts.solves - solves), 5 * (k ? 4 + 5 + 3 : 3), 0);
        m->frame->substep = m->bodies.longest = 0.006;
    }
    end(m);
}

/* The water's steps stay; the bodies' become as many as their vibration asks for. */
void mri_resolves_vibrations_of_bodies(void **state)
{
    long solves[2];
    double error[2];

    (void)state;
    for (int k = 0; k < 2; k++) {
        struct moment p;
        struct mri *m = toy_mri(&p, 1e4, k ? 1e-7 : 1e-3, 0.05);
        int steps;
        double exact[64], y[64];
        toy_exact(&p, 0, y);
        const long q = layout_at(&p.layout, p.row_q);
        toy_exact(&p, 1, exact);
        y[q] += 0.01; /* swings with omega = 100, damped by exp(-t/4) */
        assert_int_equal(toy_found()->restart(m, 0, y, NULL), STATUS_DONE);
        assert_int_equal(toy_run(m, 1, &steps), STATUS_DONE);
        near(steps, 20, 1);
        solves[k] = p.counts.solves;
        const double omega = sqrt(1e4 - 0.0625), c = cos(omega), s = sin(omega);
        exact[q] += 0.01 * exp(-0.25) * (c + 0.25 / omega * s);
        error[k] = fabs(toy_found()->state(m)[q] - exact[q]);
        end(m);
    }
    if (!(error[1] < 2e-5 && error[0] < 5e-3 && solves[1] > 5 * solves[0]))
        fail_msg("errors %g %g, %ld %ld solves", error[0], error[1], solves[0], solves[1]);
}

/* Once nothing swings, a stiff body costs one step a stage. */
void mri_passes_over_stiff_bodies(void **state)
{
    (void)state;
    for (double stiffness = 1e6; stiffness < 2e12; stiffness *= 100) {
        struct moment p;
        struct mri *m = toy_mri(&p, stiffness, 1e-4, 0.05);
        int steps;
        assert_int_equal(toy_run(m, 2, &steps), STATUS_DONE);
        assert_true(toy_error(&p, 2, toy_found()->state(m)) < 2e-4);
        if (!(p.counts.solves <= 5 * 3 * steps * 1.2 && p.counts.rhs_explicit <= 3 * steps + 1))
            fail_msg("stiffness %g: %d steps, %ld solves", stiffness, steps, p.counts.solves);
        end(m);
    }
}

void mri_shortens_steps_without_an_answer(void **state)
{
    struct moment p;
    struct mri *m = toy_mri(&p, 4, 1e-3, 0.8);
    int steps;

    (void)state;
    p.solvable = 0.02; /* of a stage's gamma: the first step is 0.8 */
    assert_int_equal(toy_run(m, 2, &steps), STATUS_DONE);
    assert_true(steps > 10 && steps < 60);
    assert_string_equal(status_message(), "");
    end(m);
}

void mri_says_what_it_cannot_serve(void **state)
{
    struct method_def def = method_def_default();
    const struct method *m;
    struct moment p;

    (void)state;
    assert_int_equal(method_find("mri", &def, &m), STATUS_DONE);
    toy_make(&p, 0, 0);
    assert_non_null(strstr(m->serves(moment_plan(&p)), "no beam"));
    toy_make(&p, 4, 0);
    assert_null(m->serves(moment_plan(&p)));
    assert_int_equal(method_find("dirk3", &def, &m), STATUS_DONE);
    assert_non_null(strstr(m->serves(moment_plan(&p)), "imex3"));
    toy_make(&p, 0, 0);
    assert_non_null(strstr(m->serves(moment_plan(&p)), "no beam"));
}
