/* time-beam.c -- the coupling of Toth (2012), the implicit bodies of "dv" and the methods for
 * beams alone on the program's own beam, without water: the first vibration of a
 * cantilever under a step load. */
#include "eval/observe.h"
#include "plan/plan.h"

#include "base/status.h"
#include "scene/scene.h"
#include "time/method.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Of data/scenes/beam-alone.scene: F L^3/(3 E I), and 1.8751^2 sqrt(E I/(mu L^4)). */
static const double bent = 10 * 0.08 * 0.08 * 0.08 / (3 * 0.5e9 * 4e-3 * 4e-3 * 4e-3 / 12);
static const double omega = 624.7;

enum { POINTS = 8 };

struct beam {
    struct scene *scene;
    const struct plan *plan;
    struct moment *moment;
    const struct method *method;
    void *self;
    double *y;
    long tip; /* entry of y */
};

static long tip_of(const struct layout *l)
{
    for (int i = 0; i < l->rows; i++)
        if (strcmp(l->row[i].name, "beam.plate.w") == 0)
            return l->row[i].offset + l->row[i].n - 1;
    fail_msg("the layout has no beam.plate.w");
    return -1;
}

/* keys: assignments over the scene's own, NULL-ended. */
static void make_with(struct beam *b, const char *name, double tol, double substep,
                      const char *const *keys)
{
    struct method_def def = method_def_default();
    char path[1024];

    snprintf(path, sizeof path, "%s/data/scenes/beam-alone.scene",
             getenv("top_srcdir") ? getenv("top_srcdir") : ".");
    if (scene_read(path, &b->scene) != STATUS_DONE)
        fail_msg("%s", status_message());
    for (int i = 0; keys[i]; i++)
        assert_int_equal(scene_override(b->scene, keys[i]), STATUS_DONE);
    if (plan_create(b->scene, &b->plan) != STATUS_DONE
        || moment_create(b->plan, &b->moment) != STATUS_DONE)
        fail_msg("%s", status_message());
    assert_int_equal(method_find(name, &def, &b->method), STATUS_DONE);
    def.tol = tol;
    def.substep = substep;
    b->y = test_calloc((size_t)plan_size(b->plan), sizeof *b->y);
    b->tip = tip_of(plan_layout(b->plan));
    plan_start(b->plan, b->y);
    if (b->method->create(b->method, &def, b->moment, 0, b->y, &b->self) != STATUS_DONE)
        fail_msg("%s", status_message());
}

static void make(struct beam *b, const char *name, double tol, double substep)
{
    make_with(b, name, tol, substep, (const char *const[]){ NULL });
}

static void end(struct beam *b)
{
    b->method->free(&b->self);
    test_free(b->y);
    moment_free(&b->moment);
    plan_free(&b->plan);
    scene_free(&b->scene);
}

/* Up to `most` extremes of tip - bent from t = from on, with their times: vertices
 * of parabolas through three ends of steps. */
static int extremes(struct beam *b, double h, double from, int most, double *when, double *size)
{
    double w[3] = { 0 };
    int n = 0;

    for (long k = 1; n < most; k++) {
        struct method_step step;
        assert_int_equal(b->method->step(b->self, 1, &step), STATUS_DONE);
        assert_true(fabs(step.h - h) < 1e-9 * h);
        w[0] = w[1];
        w[1] = w[2];
        w[2] = b->method->state(b->self)[b->tip] - bent;
        const double slope = (w[2] - w[0]) / 2, curve = w[2] - 2 * w[1] + w[0];
        if (step.t < from || (w[1] - w[0]) * (w[2] - w[1]) > 0)
            continue;
        when[n] = step.t - h - h * slope / curve;
        size[n++] = w[1] - slope * slope / (2 * curve);
    }
    return n;
}

/* A step multiplies the vibration by 1/(1 - i omega h). */
static void check_vibration(double h)
{
    double when[7], size[7];
    struct beam b;

    make(&b, "staggered", 1, h);
    extremes(&b, h, 0.02, 7, when, size); /* the higher modes are gone by then */
    end(&b);
    const double turn = 6 * M_PI / (when[6] - when[0]) * h;
    const double decay = pow(size[6] / size[0], h / (when[6] - when[0]));
    if (!(fabs(turn / atan(omega * h) - 1) < 2e-3))
        fail_msg("h %g: turns by %.6g a step, not %.6g", h, turn, atan(omega * h));
    if (!(fabs(log(decay) / (-0.5 * log1p(omega * h * omega * h)) - 1) < 0.02))
        fail_msg("h %g: shrinks to %.6g a step, not %.6g", h, decay,
                 1 / sqrt(1 + omega * h * omega * h));
}

static void vibrations_die_as_backward_euler_says(void **state)
{
    (void)state;
    check_vibration(1e-4);
    check_vibration(5e-5);
}

/* The tip at 0.5, 1, .. 4 ms. */
static void tips(const char *name, double tol, double substep, double *tip)
{
    struct method_step step = { .t = 0 };
    struct beam b;

    make(&b, name, tol, substep);
    for (int k = 0; k < POINTS; k++) {
        const double t = 5e-4 * (k + 1);
        while (step.t < t)
            assert_int_equal(b.method->step(b.self, 0.01, &step), STATUS_DONE);
        assert_int_equal(b.method->at(b.self, t, b.y), STATUS_DONE);
        tip[k] = b.y[b.tip];
    }
    end(&b);
}

static void the_tip_converges_to_that_of_imex4(void **state)
{
    double exact[POINTS], tip[POINTS], error[3] = { 0 };

    (void)state;
    tips("imex4", 1e-6, 0, exact);
    for (int i = 0; i < 3; i++) {
        tips("staggered", 1, 1e-5 / (1 << i), tip);
        for (int k = 0; k < POINTS; k++)
            error[i] = fmax(error[i], fabs(tip[k] - exact[k]));
    }
    const double first = log2(error[0] / error[1]), second = log2(error[1] / error[2]);
    if (!(error[2] > 1e-9 && error[0] < 0.02 * bent && first > 0.85 && first < 1.15
          && second > 0.9 && second < 1.1))
        fail_msg("errors %g %g %g m, orders %.3f %.3f", error[0], error[1], error[2], first,
                 second);
}

/* Between the first and the 21st time that the tip passes its rest upwards. */
static void dv_keeps_the_frequency(void **state)
{
    struct method_step step;
    struct beam b;
    double w[2] = { 0, 0 }, first = 0, last = 0;

    (void)state;
    make(&b, "dv", 1e-4, 0);
    for (int n = 0; n < 21;) {
        assert_int_equal(b.method->step(b.self, 10, &step), STATUS_DONE);
        w[0] = w[1];
        w[1] = b.method->state(b.self)[b.tip] - bent;
        if (!(w[0] < 0 && w[1] >= 0))
            continue;
        last = step.t - step.h * w[1] / (w[1] - w[0]);
        first = n++ == 0 ? last : first;
    }
    end(&b);
    if (!(fabs(20 * 2 * M_PI / (last - first) / omega - 1) < 3e-3))
        fail_msg("%g rad/s instead of %g", 20 * 2 * M_PI / (last - first), omega);
}

static void the_tip_of_dv_converges(void **state)
{
    double exact[POINTS], tip[POINTS], error[2] = { 0 };

    (void)state;
    tips("imex4", 1e-6, 0, exact);
    for (int i = 0; i < 2; i++) {
        tips("dv", i ? 1e-6 : 1e-3, 0, tip);
        for (int k = 0; k < POINTS; k++)
            error[i] = fmax(error[i], fabs(tip[k] - exact[k]));
    }
    if (!(error[0] < 0.05 * bent && error[1] < 1e-3 * bent))
        fail_msg("errors %g and %g of the deflection", error[0] / bent, error[1] / bent);
}

/* However long the steps: supports and loads give the momentum that the beam gets, and
 * loads the energy that goes with it. */
static void the_book_of_dv_is_that_of_its_steps(void **state)
{
    struct method_step step = { .t = 0 };
    struct book_sheet s;
    struct beam b;
    double most = 0, driven;

    (void)state;
    make(&b, "dv", 0.1, 0);
    for (int k = 0; k < 40; k++) {
        assert_int_equal(b.method->step(b.self, 10, &step), STATUS_DONE);
        observe_sheet(b.moment, step.t, b.method->state(b.self), &s);
        most = fmax(most, fabs(s.momentum[0]));
        for (int d = 0; d < 2; d++)
            if (!(fabs(s.momentum[d] - s.momentum_given[d]) < 1e-11))
                fail_msg("t = %g s: %g N s of %g N s", step.t, s.momentum_given[d],
                         s.momentum[d]);
    }
    assert_true(most > 1e-3);
    driven = s.work[s.works - 1];
    if (!(fabs(driven - 10 * b.method->state(b.self)[b.tip]) < 1e-12 && driven > 1e-4))
        fail_msg("the load gave %.15g J, not %.15g J", driven,
                 10 * b.method->state(b.self)[b.tip]);
    end(&b);
}

static void the_tips_of_dirk_converge(void **state)
{
    static const char *const names[] = { "dirk2", "dirk3", "dirk4", "dirk5" };
    double exact[POINTS], tip[POINTS];

    (void)state;
    tips("imex4", 1e-6, 0, exact);
    for (int m = 0; m < 4; m++) {
        double error[2] = { 0 };
        for (int i = 0; i < 2; i++) {
            tips(names[m], i ? 1e-5 : 1e-3, 0, tip);
            for (int k = 0; k < POINTS; k++)
                error[i] = fmax(error[i], fabs(tip[k] - exact[k]));
        }
        if (!(error[0] < 0.1 * bent && error[1] < 1e-3 * bent && error[1] < error[0] / 20))
            fail_msg("%s: errors %g and %g of the deflection", names[m], error[0] / bent,
                     error[1] / bent);
    }
}

static int steps_to(double t_end, const char *name, const char *const *keys)
{
    struct method_step step = { .t = 0 };
    struct beam b;
    int n = 0;

    make_with(&b, name, 1e-3, 0, keys);
    for (; step.t < t_end; n++)
        assert_int_equal(b.method->step(b.self, t_end, &step), STATUS_DONE);
    end(&b);
    return n;
}

/* The same vibration, two of its periods, on the beam as it is, on one of steel as much
 * stiffer as its load is larger, and with five times the elements. */
static void dirk_does_not_feel_stiffness_or_elements(void **state)
{
    static const char *const names[] = { "dirk2", "dirk3", "dirk4", "dirk5" };

    (void)state;
    for (int m = 0; m < 4; m++) {
        const int soft = steps_to(0.02, names[m], (const char *const[]){ NULL });
        const int steel = steps_to(0.02 / sqrt(420), names[m],
                                   (const char *const[]){ "beam.plate.E=210e9",
                                                          "beam.plate.tip_force=4200", NULL });
        const int fine = steps_to(0.02, names[m],
                                  (const char *const[]){ "beam.plate.elements=100", NULL });
        if (!(abs(steel - soft) <= 0.05 * soft && fine < 1.5 * soft && soft < 800))
            fail_msg("%s: %d steps, %d of steel, %d with 100 elements", names[m], soft, steel,
                     fine);
    }
}

/* Steps of 10 ms on steel: 128 radians of the slowest vibration, and of the fastest as
 * many thousands. */
static void dirk_goes_to_rest_in_long_steps(void **state)
{
    static const char *const names[] = { "dirk2@1e-2s", "dirk3@1e-2s", "dirk4@1e-2s",
                                         "dirk5@1e-2s" };

    (void)state;
    for (int m = 0; m < 4; m++) {
        struct method_step step;
        struct beam b;
        make_with(&b, names[m], 1, 0, (const char *const[]){ "beam.plate.E=210e9", NULL });
        for (int k = 0; k < 12; k++)
            assert_int_equal(b.method->step(b.self, 1, &step), STATUS_DONE);
        const double off = b.method->state(b.self)[b.tip] / (bent / 420) - 1;
        end(&b);
        if (!(fabs(off) < 1e-3))
            fail_msg("%s: %g off its rest", names[m], off);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vibrations_die_as_backward_euler_says),
        cmocka_unit_test(the_tip_converges_to_that_of_imex4),
        cmocka_unit_test(dv_keeps_the_frequency),
        cmocka_unit_test(the_tip_of_dv_converges),
        cmocka_unit_test(the_tips_of_dirk_converge),
        cmocka_unit_test(dirk_does_not_feel_stiffness_or_elements),
        cmocka_unit_test(dirk_goes_to_rest_in_long_steps),
        cmocka_unit_test(the_book_of_dv_is_that_of_its_steps),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
