/* walls.c -- tests of src/walls: how a wall is told to move. */
#include "walls/walls.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

static const struct walls_motion motion = {
    .velocity = { 0.3, -0.2, 0.1 }, .amplitude = { 0.004, 0.01, -0.006 }, .frequency = 7,
};

static void assert_close(double a, double b, double within)
{
    if (!(fabs(a - b) <= within))
        fail_msg("%.17g differs from %.17g by more than %g", a, b, within);
}

/* x = v t + A sin(2 pi f t); velocity and acceleration are its derivatives. */
static void velocity_and_acceleration_are_derivatives(void **state)
{
    const double h = 1e-6;

    (void)state;
    for (double t = 0; t < 0.5; t += 0.0131) {
        double x[3][DIM], u[3][DIM], a[3][DIM];

        for (int k = 0; k < 3; k++)
            walls_motion_at(&motion, t + (k - 1) * h, x[k], u[k], a[k]);
        for (int d = 0; d < DIM; d++) {
            assert_close(x[1][d], motion.velocity[d] * t
                         + motion.amplitude[d] * sin(2 * M_PI * 7 * t), 1e-16);
            assert_close((x[2][d] - x[0][d]) / (2 * h), u[1][d], 1e-9);
            assert_close((u[2][d] - u[0][d]) / (2 * h), a[1][d], 1e-7);
        }
    }
}

static void only_what_has_a_speed_moves(void **state)
{
    struct walls_motion m = { 0 };

    (void)state;
    assert_false(walls_motion_any(&m));
    m.frequency = 3;
    assert_false(walls_motion_any(&m));
    m.amplitude[DIM - 1] = -1e-3;
    assert_true(walls_motion_any(&m));
    m.frequency = 0;
    assert_false(walls_motion_any(&m));
    m.velocity[0] = -1e-9;
    assert_true(walls_motion_any(&m));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(velocity_and_acceleration_are_derivatives),
        cmocka_unit_test(only_what_has_a_speed_moves),
    };

    return cmocka_run_group_tests_name("walls", tests, NULL, NULL);
}
