/* time-odes.c -- methods whose steps libraries take, CVODE's and those of GSL's odeiv2, and
 * our own multistep method ab3. */
#include "time-toy.h"

#include "base/status.h"
#include "time/ab3.h"
#include "time/cvode.h"
#include "time/gslode.h"
#include "time/method.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { METHODS = 6, STATE = 64 };

static const struct method *const methods[METHODS] = {
    &cvode_adams.method, &cvode_bdf.method, &gslode_rkf45.method, &gslode_rk8pd.method,
    &gslode_msadams.method, &ab3_kind.method
};

/* With a beam where the method serves one. */
static void make(struct moment *p, const struct method *m, double stiffness)
{
    toy_make(p, stiffness, 0.5);
    if (m->serves(moment_plan(p)))
        toy_make(p, 0, 0);
}

/* On the exact solution at t = 0. */
static void *begin(const struct method *m, struct moment *p, double tol, double h_first)
{
    struct method_def def = method_def_default();
    double y[STATE];
    void *self = NULL;

    status_clear();
    assert_null(m->serves(moment_plan(p)));
    def.tol = tol;
    def.h_first = h_first;
    toy_exact(p, 0, y);
    if (m->create(m, &def, p, 0, y, &self) != STATUS_DONE)
        fail_msg("%s: %s", m->name, status_message());
    return self;
}

static void end(const struct method *m, void **self)
{
    m->free(self);
    assert_null(*self);
}

static int run(const struct method *m, void *self, double from, double to, int *steps)
{
    struct method_step step = { .t = from };

    for (*steps = 0; step.t < to; ++*steps) {
        TRY(m->step(self, to, &step));
        assert_true(step.t <= to && step.h > 0);
    }
    assert_true(step.t == to);
    return STATUS_DONE;
}

static bool has_a_word(const char *word)
{
    return strstr(status_message(), word) != NULL;
}

/* --- accuracy ---------------------------------------------------------------- */

/* Each step is cut to h. */
static double fixed_error(const struct method *m, double h)
{
    struct moment p;
    struct method_step step = { .t = 0 };
    double error;

    toy_make(&p, 0, 0);
    void *self = begin(m, &p, 1e6, 1e9);
    for (int k = 1; k <= (int)lround(2 / h); k++) {
        assert_int_equal(m->step(self, k * h, &step), STATUS_DONE);
        assert_true(step.t == k * h && step.limiter == METHOD_OUTPUT);
        assert_string_equal(step.where, "end of the segment");
    }
    error = toy_error(&p, 2, m->state(self));
    end(m, &self);
    return error;
}

static void runge_kutta_has_its_order(void **state)
{
    static const struct {
        const struct method *m;
        double order, h;
    } row[] = { { &gslode_rkf45.method, 5, 0.1 }, { &gslode_rk8pd.method, 8, 1 } };

    (void)state;
    for (int i = 0; i < 2; i++) {
        const struct method *m = row[i].m;
        const double e2 = fixed_error(m, row[i].h / 2), e4 = fixed_error(m, row[i].h / 4),
                     order = log2(e2 / e4);
        if (!(e4 > 1e-14 && order > row[i].order - 0.3 && order < row[i].order + 0.9))
            fail_msg("%s: errors %.3g %.3g, order %.2f", m->name, e2, e4, order);
    }
}

/* Errors fall with tol, and the cost rises as a high order lets it. */
static void errors_follow_the_tolerance(void **state)
{
    static const double dearer[METHODS] = { 4, 30, 6, 4, 4, 12 }; /* steps, 1e-8 to 1e-4 */

    (void)state;
    for (int i = 0; i < METHODS; i++) {
        double error[3];
        int steps[3];
        for (int k = 0; k < 3; k++) {
            struct moment p;
            toy_make(&p, 0, 0);
            void *self = begin(methods[i], &p, pow(10, -4 - 2 * k), 0);
            assert_int_equal(run(methods[i], self, 0, 3, &steps[k]), STATUS_DONE);
            error[k] = toy_error(&p, 3, methods[i]->state(self));
            end(methods[i], &self);
        }
        if (!(error[0] < 5e-3 && error[1] < error[0] / 8 && error[2] < error[1] / 8
              && steps[2] < dearer[i] * steps[0]))
            fail_msg("%s: errors %.2g %.2g %.2g, steps %d %d %d", methods[i]->name, error[0],
                     error[1], error[2], steps[0], steps[1], steps[2]);
    }
}

static void between_the_ends_it_is_as_accurate(void **state)
{
    (void)state;
    for (int i = 0; i < METHODS; i++) {
        struct moment p;
        struct method_step step = { .t = 0 };
        double y[STATE], most = 0, ends = 0;
        make(&p, methods[i], 4);
        void *self = begin(methods[i], &p, 1e-5, 0);
        while (step.t < 3) {
            assert_int_equal(methods[i]->step(self, 3, &step), STATUS_DONE);
            assert_int_equal(methods[i]->at(self, step.t, y), STATUS_DONE);
            assert_memory_equal(y, methods[i]->state(self), sizeof *y * (size_t)moment_size(&p));
            ends = fmax(ends, toy_error(&p, step.t, y));
            for (int k = 1; k < 4; k++) {
                const double t = step.t - k * step.h / 4;
                assert_int_equal(methods[i]->at(self, t, y), STATUS_DONE);
                most = fmax(most, toy_error(&p, t, y));
            }
            assert_int_equal(methods[i]->at(self, step.t + step.h, y), STATUS_FAILED);
            assert_int_equal(methods[i]->at(self, step.t - 2 * step.h, y), STATUS_FAILED);
            status_clear();
        }
        /* rk8pd's steps are longer than an interpolant of order 6 can follow */
        if (!(most < (methods[i] == &gslode_rk8pd.method ? 2e-3 : 3 * ends + 1e-5)))
            fail_msg("%s: %.2g, at the ends %.2g", methods[i]->name, most, ends);
        end(methods[i], &self);
    }
}

/* Beams are BDF's preconditioner, and its order stays where their vibrations do not grow. */
static void bdf_does_not_mind_stiff_beams(void **state)
{
    int steps[3];

    (void)state;
    for (int k = 0; k < 3; k++) {
        struct moment p;
        toy_make(&p, pow(10, 6 + k), 0);
        p.wave = 0;
        void *self = begin(&cvode_bdf.method, &p, 1e-4, 0);
        if (run(&cvode_bdf.method, self, 0, 5, &steps[k]) != STATUS_DONE)
            fail_msg("%s", status_message());
        if (!(toy_error(&p, 5, cvode_bdf.method.state(self)) < 2e-2))
            fail_msg("1e%d: error %g", 6 + k, toy_error(&p, 5, cvode_bdf.method.state(self)));
        assert_true(p.counts.solves > 0);
        assert_non_null(strstr(cvode_bdf.method.table(self), "order <= 2"));
        end(&cvode_bdf.method, &self);
    }
    if (!(steps[0] < 1000 && abs(steps[1] - steps[0]) < steps[0] / 3
          && abs(steps[2] - steps[0]) < steps[0] / 3))
        fail_msg("steps: %d %d %d", steps[0], steps[1], steps[2]);
}

/* ab3 has a bound of stability that knows them. */
static void only_bdf_and_ab3_serve_beams(void **state)
{
    struct moment p;

    (void)state;
    toy_make(&p, 1e6, 0);
    for (int i = 0; i < METHODS; i++) {
        const char *why = methods[i]->serves(moment_plan(&p));
        if (methods[i] == &cvode_bdf.method || methods[i] == &ab3_kind.method)
            assert_null(why);
        else
            assert_non_null(strstr(why, "imex3"));
    }
}

/* --- ab3 ----------------------------------------------------------------------- */

/* Three for each of the first two steps, then one a step, accepted or not. */
static void ab3_asks_once_a_step(void **state)
{
    struct moment p;
    struct method_step step = { .t = 0 };
    int steps;

    (void)state;
    toy_make(&p, 0, 0);
    void *self = begin(&ab3_kind.method, &p, 1e-4, 0.01);
    for (steps = 0; steps < 30; steps++)
        assert_int_equal(ab3_kind.method.step(self, 10, &step), STATUS_DONE);
    assert_true(step.rejected == 0 && p.counts.rhs_explicit == 1 + 2 * 3 + (30 - 2));
    p.refuse_after = step.t;
    assert_int_equal(ab3_kind.method.step(self, 10, &step), STATUS_FAILED);
    assert_true(p.counts.refused > 10);
    assert_true(p.counts.rhs_explicit == 1 + 2 * 3 + (30 - 2) + p.counts.refused);
    end(&ab3_kind.method, &self);
}

/* A step of next to nothing on the way: differences over it would be noise. */
static void ab3_is_not_disturbed_by_a_short_step(void **state)
{
    double error[2];
    int steps[2][3] = { { 0 } };

    (void)state;
    for (int k = 0; k < 2; k++) {
        struct moment p;
        const double stop[3] = { 1, 1 + 3e-15, 3 };
        toy_make(&p, 0, 0);
        void *self = begin(&ab3_kind.method, &p, 1e-5, 0);
        for (int i = 0; i < 3; i++)
            if (k == 1 || i == 2)
                assert_int_equal(run(&ab3_kind.method, self, 0, stop[i], &steps[k][i]),
                                 STATUS_DONE);
        error[k] = toy_error(&p, 3, ab3_kind.method.state(self));
        end(&ab3_kind.method, &self);
    }
    const int more = steps[1][0] + steps[1][1] + steps[1][2] - steps[0][2];
    if (!(error[1] < 1.5 * error[0] && steps[1][1] == 1 && more >= 1 && more <= 4))
        fail_msg("errors %g and %g, %d steps more", error[0], error[1], more);
}

/* --- contacts ------------------------------------------------------------------ */

/* Errors would let each step longer; ab3 asks for all bounds at once, not for this one. */
static void contacts_bound_what_errors_choose(void **state)
{
    const double longest = 1e-3;

    (void)state;
    for (int i = 0; i < METHODS; i++) {
        struct moment p;
        struct method_step step = { .t = 0 };
        double most = 0;
        int bound = 0;
        if (methods[i] == &ab3_kind.method)
            continue;
        make(&p, methods[i], 4);
        p.touch = 1 / longest;
        void *self = begin(methods[i], &p, 1e-4, 0);
        while (step.t < 0.2) {
            assert_int_equal(methods[i]->step(self, 0.2, &step), STATUS_DONE);
            most = fmax(most, step.h);
            bound += strcmp(step.where, "contact") == 0;
        }
        if (!(most < longest * (1 + 1e-9) && bound > 100))
            fail_msg("%s: a step of %g, %d bound", methods[i]->name, most, bound);
        end(methods[i], &self);
    }
}

/* --- bits ---------------------------------------------------------------------- */

static void looking_does_not_change_the_run(void **state)
{
    (void)state;
    for (int i = 0; i < METHODS; i++) {
        double final[2][STATE] = { { 0 } };
        long asked[2];
        for (int looks = 0; looks < 2; looks++) {
            struct moment p;
            struct method_step step = { .t = 0 };
            double y[STATE];
            make(&p, methods[i], 100);
            void *self = begin(methods[i], &p, 1e-5, 0);
            while (step.t < 2) {
                assert_int_equal(methods[i]->step(self, 2, &step), STATUS_DONE);
                for (int k = 1; k < 4 && looks; k++)
                    assert_int_equal(methods[i]->at(self, step.t - step.h * k / 4, y), 0);
            }
            memcpy(final[looks], methods[i]->state(self), sizeof *y * (size_t)moment_size(&p));
            asked[looks] = p.counts.rhs_explicit;
            assert_true(p.counts.rebuilds > 5);
            end(methods[i], &self);
        }
        assert_memory_equal(final[0], final[1], sizeof final[0]);
        assert_true(asked[0] == asked[1]);
    }
}

static void a_restart_forgets_the_past(void **state)
{
    (void)state;
    for (int i = 0; i < METHODS; i++) {
        struct moment p;
        double y[STATE], first[STATE];
        struct method_step step;
        int steps;
        make(&p, methods[i], 4);
        void *self = begin(methods[i], &p, 1e-5, 0);
        assert_int_equal(run(methods[i], self, 0, 1, &steps), STATUS_DONE);
        memcpy(first, methods[i]->state(self), sizeof *y * (size_t)moment_size(&p));
        assert_int_equal(methods[i]->step(self, 2, &step), STATUS_DONE);
        toy_exact(&p, 0, y);
        assert_int_equal(methods[i]->restart(self, 0, y, NULL), STATUS_DONE);
        assert_memory_equal(methods[i]->state(self), y, sizeof *y * (size_t)moment_size(&p));
        assert_int_equal(methods[i]->at(self, 0.5, y), STATUS_FAILED);
        p.listed = 0;
        assert_int_equal(run(methods[i], self, 0, 1, &steps), STATUS_DONE);
        assert_memory_equal(first, methods[i]->state(self), sizeof *y * (size_t)moment_size(&p));
        end(methods[i], &self);
    }
}

/* --- refusals --------------------------------------------------------------------- */

static void a_refusal_shortens_the_step(void **state)
{
    (void)state;
    for (int i = 0; i < METHODS; i++) {
        struct moment p;
        int steps;
        make(&p, methods[i], 4);
        p.off = 2e-3;
        void *self = begin(methods[i], &p, 1e-4, 2); /* by far too long a first step */
        if (run(methods[i], self, 0, 2, &steps) != STATUS_DONE)
            fail_msg("%s: %s", methods[i]->name, status_message());
        if (p.counts.refused == 0 || steps < 2 || steps > 2000)
            fail_msg("%s: %ld refusals, %d steps", methods[i]->name, p.counts.refused, steps);
        assert_string_equal(status_message(), "");
        end(methods[i], &self);
    }
}

static void a_lasting_refusal_ends_the_run_with_a_message(void **state)
{
    (void)state;
    for (int i = 0; i < METHODS; i++) {
        struct moment p;
        int steps;
        make(&p, methods[i], 4);
        p.refuse_after = 1;
        void *self = begin(methods[i], &p, 1e-4, 0);
        assert_int_equal(run(methods[i], self, 0, 2, &steps), STATUS_FAILED);
        if (!has_a_word("density of particle 0") || !has_a_word("t = ") || !has_a_word("try")
            || !has_a_word(methods[i]->name) || !status_has_remedy()
            || strlen(status_message()) > 600)
            fail_msg("%s", status_message());
        assert_true(p.counts.rhs_explicit < 3000);
        assert_true(toy_error(&p, 1, methods[i]->state(self)) < 0.2); /* the last good state */
        end(methods[i], &self);
    }
}

/* No right-hand side at all: there is no start. */
static void nothing_starts_where_there_is_no_answer(void **state)
{
    (void)state;
    for (int i = 0; i < METHODS; i++) {
        struct moment p;
        double y[STATE];
        int steps;
        make(&p, methods[i], 4);
        p.off = 1e-3;
        void *self = begin(methods[i], &p, 1e-4, 0);
        toy_exact(&p, 0, y);
        y[layout_at(&p.layout, p.row_rho)] = 2;
        assert_int_equal(methods[i]->restart(self, 0, y, NULL), STATUS_DONE);
        assert_int_equal(run(methods[i], self, 0, 2, &steps), STATUS_FAILED);
        if (!has_a_word("cannot start") || !has_a_word("overlap"))
            fail_msg("%s", status_message());
        end(methods[i], &self);
    }
}

/* Also where no weight looks: the book is a quadrature. */
static void rates_that_are_not_finite_are_refused(void **state)
{
    (void)state;
    for (int i = 0; i < METHODS; i++) {
        struct moment p;
        int steps;
        make(&p, methods[i], 4);
        p.poison_after = 1;
        void *self = begin(methods[i], &p, 1e-4, 0);
        assert_int_equal(run(methods[i], self, 0, 2, &steps), STATUS_FAILED);
        if (!has_a_word("rate of book, number 0 is not finite"))
            fail_msg("%s", status_message());
        for (long k = 0; k < moment_size(&p); k++)
            assert_true(isfinite(methods[i]->state(self)[k]));
        end(methods[i], &self);
    }
}

/* A tolerance that no step meets: the message names the entry. */
static void the_largest_error_is_named(void **state)
{
    (void)state;
    for (int i = 0; i < METHODS; i++) {
        struct moment p;
        struct method_step step;
        toy_make(&p, 0, 0);
        void *self = begin(methods[i], &p, 1e-6, 0);
        for (int k = 0; k < 30; k++)
            assert_int_equal(methods[i]->step(self, 1e3, &step), STATUS_DONE);
        assert_int_equal(step.limiter, METHOD_ERROR);
        if (!strstr(step.where, "of fluid, number"))
            fail_msg("%s: %s", methods[i]->name, step.where);
        end(methods[i], &self);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(runge_kutta_has_its_order),
        cmocka_unit_test(errors_follow_the_tolerance),
        cmocka_unit_test(between_the_ends_it_is_as_accurate),
        cmocka_unit_test(bdf_does_not_mind_stiff_beams),
        cmocka_unit_test(only_bdf_and_ab3_serve_beams),
        cmocka_unit_test(ab3_asks_once_a_step),
        cmocka_unit_test(ab3_is_not_disturbed_by_a_short_step),
        cmocka_unit_test(contacts_bound_what_errors_choose),
        cmocka_unit_test(looking_does_not_change_the_run),
        cmocka_unit_test(a_restart_forgets_the_past),
        cmocka_unit_test(a_refusal_shortens_the_step),
        cmocka_unit_test(a_lasting_refusal_ends_the_run_with_a_message),
        cmocka_unit_test(nothing_starts_where_there_is_no_answer),
        cmocka_unit_test(rates_that_are_not_finite_are_refused),
        cmocka_unit_test(the_largest_error_is_named),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
