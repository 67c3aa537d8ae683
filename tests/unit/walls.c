/* walls.c -- tests of src/walls: how a wall is told to move. */
#include "base/status.h"
#include "state/particles.h"
#include "state/track.h"
#include "walls/walls.h"
#include "state/motion.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

enum { UP = DIM - 1 };

static double lift[][3] = { { 0, 0 }, { 0.1, 0.02 }, { 0.3, 0.05 }, { 0.4, 0.05 } };
static double roll[][3] = { { 0.05, 0 }, { 0.2, 30 }, { 0.45, -10 } };

static struct motion motion_of_all(void)
{
    struct motion m = {
        .velocity = { 0.3, -0.2, 0.1 }, .amplitude = { 0.004, 0.01, -0.006 }, .frequency = 7,
        .phase = 20, .start = 0.04, .stop = 0.6, .direction = { 3, 4, 0 },
        .path = { 4, lift }, .pivot = { 0.2, 0.1, -0.3 }, .spin = 50, .swing = 3,
        .turn = { 3, roll }
    };

    assert_int_equal(motion_prepare(&m, "wall.gate", "a.scene:3"), STATUS_DONE);
    return m;
}

static void assert_close(double a, double b, double within)
{
    if (!(fabs(a - b) <= within))
        fail_msg("%.17g differs from %.17g by more than %g", a, b, within);
}

/* x and u of the particle at x0, and the wall's acceleration there. */
static void look(const struct motion *m, double t, const double *x0, double *x, double *u,
                 double *a)
{
    struct motion_place p;
    double back[DIM];
    struct object o = { .name = "gate" };

    motion_at(m, t, &p);
    motion_point(m, &p, x0, x, u);
    motion_back(m, &p, x, back);
    for (int d = 0; d < DIM; d++)
        assert_true(fabs(back[d] - x0[d]) < 1e-12 * (1 + fabs(x0[d]) + fabs(x[d])));
    memcpy(o.a, p.a, sizeof o.a);
    for (int d = 0; d < DIM; d++)
        o.centre[d] = m->pivot[d] + p.shift[d];
    o.omega = p.omega;
    o.alpha = p.alpha;
    object_acceleration(&o, x, a);
}

static void velocity_and_acceleration_are_derivatives(void **state)
{
    const double h = 1e-6, x0[3] = { 0.31, -0.05, 0.4 };
    struct motion m = motion_of_all();

    (void)state;
    for (double t = 0.003; t < 0.7; t += 0.0131) {
        double x[3][DIM], u[3][DIM], a[3][DIM];

        for (int k = 0; k < 3; k++)
            look(&m, t + (k - 1) * h, x0, x[k], u[k], a[k]);
        for (int d = 0; d < DIM; d++) {
            assert_close((x[2][d] - x[0][d]) / (2 * h), u[1][d], 2e-9);
            assert_close((u[2][d] - u[0][d]) / (2 * h), a[1][d], 2e-6);
        }
    }
    motion_free(&m);
}

/* x = v s + A sin(2 pi f s): the first two keys of old, s from the start on. */
static void a_sine_is_added_to_a_constant_velocity(void **state)
{
    struct motion m = { .velocity = { 0.3 }, .amplitude = { 0.004 }, .frequency = 7,
                              .start = 0.1, .stop = 1 };
    const double x0[DIM] = { 0 };
    double x[DIM], u[DIM], a[DIM];

    (void)state;
    for (double t = 0.1; t < 0.9; t += 0.0731) {
        look(&m, t, x0, x, u, a);
        assert_close(x[0], 0.3 * (t - 0.1) + 0.004 * sin(2 * M_PI * 7 * (t - 0.1)), 1e-16);
    }
    look(&m, 0.09, x0, x, u, a);
    assert_close(fabs(x[0]) + fabs(u[0]) + fabs(a[0]), 0, 0);
    look(&m, 2, x0, x, u, a);
    assert_close(x[0], 0.3 * 0.9 + 0.004 * sin(2 * M_PI * 7 * 0.9), 1e-15);
    assert_close(fabs(u[0]) + fabs(a[0]), 0, 0);
}

/* A quarter turn about a pivot: what was right of it is above it. */
static void turning_is_anticlockwise_about_the_pivot(void **state)
{
    struct motion m = { .spin = 90, .pivot = { 1, 1, 1 }, .stop = 10 };
    double x0[3] = { 1.5, 1, 1 }, x[DIM], u[DIM], a[DIM];

    (void)state;
    look(&m, 1, x0, x, u, a);
    assert_close(x[0], 1, 1e-15);
    assert_close(x[UP], 1.5, 1e-15);
    assert_close(u[0], -0.25 * M_PI, 1e-15);
    assert_close(a[UP], -0.5 * M_PI * M_PI / 4, 1e-14);
}

static void a_path_goes_through_its_pairs_and_never_beyond(void **state)
{
    struct motion m = { .direction = { 0, 2, 0 }, .path = { 4, lift }, .stop = 10 };
    const double x0[DIM] = { 0 };
    double x[DIM], u[DIM], a[DIM], before = 0;

    (void)state;
    assert_int_equal(motion_prepare(&m, "wall.gate", "a.scene:3"), STATUS_DONE);
    for (int i = 0; i < 4; i++) {
        look(&m, lift[i][0], x0, x, u, a);
        assert_close(x[1], lift[i][1], 1e-15);
    }
    for (double t = 0; t < 0.5; t += 1e-3) {
        look(&m, t, x0, x, u, a);
        assert_true(x[1] >= before - 1e-15 && x[1] <= 0.05 + 1e-15);
        before = x[1];
    }
    motion_free(&m);
}

static void events_stand_where_the_velocity_jumps(void **state)
{
    static const double when[] = { 0.04, 0.09, 0.44, 0.49, 0.6 };
    struct motion m = motion_of_all();
    double t = -1;

    (void)state;
    for (size_t i = 0; i < sizeof when / sizeof when[0]; i++) {
        t = motion_event(&m, t);
        assert_close(t, when[i], 1e-15);
    }
    assert_true(isinf(motion_event(&m, t)));
    motion_free(&m);
    m = (struct motion){ .stop = 1 };
    assert_true(isinf(motion_event(&m, -1)));
}

static void its_extent_holds_all_that_it_does(void **state)
{
    struct motion m = { .velocity = { 0.5 }, .spin = 90, .stop = 2 };
    const double low[3] = { 0 }, high[3] = { 1, 1, 1 };
    double reach[DIM], fastest;

    (void)state;
    fastest = motion_extent(&m, low, high, 4, reach);
    assert_true(fastest >= M_PI / 2 * sqrt(2) && fastest <= M_PI / 2 * sqrt(2) + 0.51);
    assert_true(reach[0] >= 1 && reach[0] <= 3 && reach[UP] >= 1 && reach[UP] <= 2);
    m = (struct motion){ .stop = 2 };
    assert_close(motion_extent(&m, low, high, 4, reach) + reach[0] + reach[UP], 0, 0);
    /* One phase at all moments: that of rest, where -90 begins. */
    m = (struct motion){ .amplitude = { 0.01 }, .frequency = 1000, .phase = -90, .stop = 1e6 };
    assert_close(motion_extent(&m, low, high, 2, reach), 20 * M_PI, 1e-9);
    assert_close(reach[0], 0.02, 1e-9);
}

static void refuse(struct motion m, const char *word)
{
    assert_int_equal(motion_prepare(&m, "wall.gate", "a.scene:3"), STATUS_BAD_SCENE);
    if (!strstr(status_message(), word) || !strstr(status_message(), "a.scene:3"))
        fail_msg("says: %s", status_message());
    status_clear();
    motion_free(&m);
}

static void what_cannot_be_is_refused(void **state)
{
    static double back[][3] = { { 0, 0 }, { 1, 1 }, { 0.5, 2 } };

    (void)state;
    refuse((struct motion){ .start = 2, .stop = 1 }, "stop");
    refuse((struct motion){ .stop = 1, .path = { 4, lift } }, "direction");
    refuse((struct motion){ .stop = 1, .turn = { 1, lift } }, "wall.gate.turn");
    refuse((struct motion){ .stop = 1, .turn = { 3, back } }, "pair 3");
}

static void only_what_has_a_speed_moves(void **state)
{
    struct motion m = { 0 };

    (void)state;
    assert_false(motion_any(&m));
    m.frequency = 3;
    assert_false(motion_any(&m));
    m.amplitude[DIM - 1] = -1e-3;
    assert_true(motion_any(&m));
    m.frequency = 0;
    assert_false(motion_any(&m));
    m.velocity[0] = -1e-9;
    assert_true(motion_any(&m));
    assert_true(motion_any(&(struct motion){ .spin = 1 }));
    assert_true(motion_any(&(struct motion){ .turn = { 3, roll } }));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(velocity_and_acceleration_are_derivatives),
        cmocka_unit_test(a_sine_is_added_to_a_constant_velocity),
        cmocka_unit_test(turning_is_anticlockwise_about_the_pivot),
        cmocka_unit_test(a_path_goes_through_its_pairs_and_never_beyond),
        cmocka_unit_test(events_stand_where_the_velocity_jumps),
        cmocka_unit_test(its_extent_holds_all_that_it_does),
        cmocka_unit_test(what_cannot_be_is_refused),
        cmocka_unit_test(only_what_has_a_speed_moves),
    };

    return cmocka_run_group_tests_name("walls", tests, NULL, NULL);
}
