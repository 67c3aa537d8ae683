/* flow.c -- tests of the flows that a fluid may start with. */
#include "base/status.h"
#include "fill/flow.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>

#define check(good, ...)           \
    do {                           \
        if (!(good))               \
            fail_msg(__VA_ARGS__); \
    } while (0)

enum { UP = DIM - 1 };

static struct flow flow_of(const char *type)
{
    struct flow f = { .type = type, .rate = 3, .speed = 0.7, .size = 2, .amplitude = 0.05,
                      .pressure = NAN, .gravity = 9.81, .rho0 = 1000 };

    for (int d = 0; d < DIM; d++) {
        f.low[d] = 0;
        f.high[d] = d == UP ? 1 : 2;
        f.centre[d] = NAN;
    }
    check(flow_check(&f, "fluid.x", "here:1") == STATUS_DONE, "%s is refused", type);
    return f;
}

static void velocity(const struct flow *f, double x, double z, double *u)
{
    double at[DIM] = { 0 };

    at[0] = x;
    at[UP] = z;
    memset(u, 0, DIM * sizeof *u);
    flow_find(f)->velocity(f, at, u);
}

static double pressure(const struct flow *f, double x, double z)
{
    double at[DIM] = { 0 };

    at[0] = x;
    at[UP] = z;
    return flow_find(f)->pressure(f, at);
}

/* The velocity gradient at (x, z) by central differences: du/dx du/dz dw/dx dw/dz. */
static void gradient(const struct flow *f, double x, double z, double g[4])
{
    const double h = 1e-5;
    double a[DIM], b[DIM];

    velocity(f, x + h, z, a);
    velocity(f, x - h, z, b);
    g[0] = (a[0] - b[0]) / (2 * h);
    g[2] = (a[UP] - b[UP]) / (2 * h);
    velocity(f, x, z + h, a);
    velocity(f, x, z - h, b);
    g[1] = (a[0] - b[0]) / (2 * h);
    g[3] = (a[UP] - b[UP]) / (2 * h);
}

static void no_flow_has_a_source(void **state)
{
    (void)state;
    for (int i = 0; flow_table[i]; i++) {
        const struct flow f = flow_of(flow_table[i]->name);
        for (int k = 0; k < 9; k++) {
            double g[4];
            gradient(&f, 0.21 + 0.2 * k, 0.9 - 0.1 * k, g);
            check(fabs(g[0] + g[3]) < 1e-8, "%s: div u = %g", f.type, g[0] + g[3]);
        }
    }
}

static void spin_is_what_the_rate_says(void **state)
{
    static const struct { const char *type; double spin; } case_[] = {
        { "rotation", 6 }, { "strain", 0 }, { "shear", -3 }, { "standing-wave", 0 } };

    (void)state;
    for (size_t i = 0; i < sizeof case_ / sizeof case_[0]; i++) {
        const struct flow f = flow_of(case_[i].type);
        double g[4];
        gradient(&f, 0.37, 0.41, g);
        check(fabs(g[2] - g[1] - case_[i].spin) < 1e-8, "%s: curl u = %.10g", f.type,
              g[2] - g[1]);
    }
}

/* u grad u = -grad p/rho: vortices in balance turn for ever. */
static void vortices_are_in_balance(void **state)
{
    const struct flow f = flow_of("taylor-green");
    const double h = 1e-5;

    (void)state;
    for (int k = 0; k < 9; k++) {
        const double x = 0.13 + 0.19 * k, z = 0.77 - 0.13 * k;
        double u[DIM], g[4];
        velocity(&f, x, z, u);
        gradient(&f, x, z, g);
        check(fabs(u[0] * g[0] + u[UP] * g[1]
                   + (pressure(&f, x + h, z) - pressure(&f, x - h, z)) / (2 * h * f.rho0)) < 1e-7,
              "across, at %g %g", x, z);
        check(fabs(u[0] * g[2] + u[UP] * g[3]
                   + (pressure(&f, x, z + h) - pressure(&f, x, z - h)) / (2 * h * f.rho0)) < 1e-7,
              "upwards, at %g %g", x, z);
    }
}

/* Linear theory: the kinetic energy of a wave length is rho g A^2 length/4, and
 * nothing goes through the bed. */
static void a_wave_holds_the_energy_of_its_height(void **state)
{
    const struct flow f = flow_of("standing-wave");
    const int n = 800; /* the sum is right to (pi/n)^2/6 */
    double sum = 0, u[DIM];

    (void)state;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < n; k++) {
            velocity(&f, 2 * (i + 0.5) / n, (k + 0.5) / n, u);
            sum += f.rho0 * (u[0] * u[0] + u[UP] * u[UP]) / 2 * 2 / ((double)n * n);
        }
    check(fabs(sum / (1000 * 9.81 * 0.05 * 0.05 * 2 / 4) - 1) < 1e-5, "energy %.8g J", sum);
    velocity(&f, 0.3, 0, u);
    check(fabs(u[UP]) < 1e-15, "through the bed: %g m/s", u[UP]);
    velocity(&f, 1, 1, u);
    check(u[UP] > 0, "at half the wave the surface is to rise first");
}

static void a_round_drop_has_a_parabola(void **state)
{
    struct flow f = flow_of("strain");

    (void)state;
    check(pressure(&f, 1, 0.5) == 0, "a strain without keys has no pressure");
    f.pressure = 500;
    check(fabs(pressure(&f, 1, 0.5) - 500) < 1e-12, "middle");
    check(fabs(pressure(&f, 2, 0.5) - 375) < 1e-12, "half way to the edge");
    check(fabs(pressure(&f, 3, 0.5)) < 1e-12 && pressure(&f, 3.5, 0.5) == 0, "edge");
}

static void what_is_missing_is_named(void **state)
{
    struct flow f = flow_of("taylor-green");

    (void)state;
    f.speed = NAN;
    assert_int_equal(flow_check(&f, "fluid.x", "a.scene:7"), STATUS_BAD_SCENE);
    check(strstr(status_message(), "a.scene:7") && strstr(status_message(), "flow_speed"),
          "says: %s", status_message());
    status_clear();
    f = flow_of("standing-wave");
    f.gravity = 0;
    assert_int_equal(flow_check(&f, "fluid.x", "a.scene:7"), STATUS_BAD_SCENE);
    check(strstr(status_message(), "gravity"), "says: %s", status_message());
    status_clear();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_flow_has_a_source),
        cmocka_unit_test(spin_is_what_the_rate_says),
        cmocka_unit_test(vortices_are_in_balance),
        cmocka_unit_test(a_wave_holds_the_energy_of_its_height),
        cmocka_unit_test(a_round_drop_has_a_parabola),
        cmocka_unit_test(what_is_missing_is_named),
    };

    return cmocka_run_group_tests_name("flow", tests, NULL, NULL);
}
