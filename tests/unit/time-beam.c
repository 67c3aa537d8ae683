/* time-beam.c -- the seed's coupling and the implicit bodies of "dv" on the program's
 * own beam, without water: the first vibration of a cantilever under a step load. */
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
    struct plan *plan;
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

static void make(struct beam *b, const char *name, double tol, double substep)
{
    struct method_def def = method_def_default();
    char path[1024];

    snprintf(path, sizeof path, "%s/data/scenes/beam-alone.scene",
             getenv("top_srcdir") ? getenv("top_srcdir") : ".");
    if (scene_read(path, &b->scene) != STATUS_DONE
        || plan_create(b->scene, &b->plan) != STATUS_DONE)
        fail_msg("%s", status_message());
    assert_int_equal(method_find(name, &def, &b->method), STATUS_DONE);
    def.tol = tol;
    def.substep = substep;
    b->y = test_calloc((size_t)plan_size(b->plan), sizeof *b->y);
    b->tip = tip_of(plan_layout(b->plan));
    plan_start(b->plan, b->y);
    if (b->method->create(b->method, &def, b->plan, 0, b->y, &b->self) != STATUS_DONE)
        fail_msg("%s", status_message());
}

static void end(struct beam *b)
{
    b->method->free(&b->self);
    test_free(b->y);
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vibrations_die_as_backward_euler_says),
        cmocka_unit_test(the_tip_converges_to_that_of_imex4),
        cmocka_unit_test(dv_keeps_the_frequency),
        cmocka_unit_test(the_tip_of_dv_converges),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
