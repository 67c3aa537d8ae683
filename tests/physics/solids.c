/* solids.c -- walls go where their formula says and hold on to the fluid, or do not. */
#include "tank.h"

#include <math.h>
#include <string.h>

/* The frame of the tank with some keys more. */
#define FRAME(keys) "wall = { tank = { type = \"frame\"; " keys " }; };"

static const double velocity[3] = { 0.3, -0.2, 0.1 }, amplitude[3] = { 0.004, 0.01, -0.006 };
static const double frequency = 7;

#if DIM == 2
#define VELOCITY "[0.3, -0.2]"
#define AMPLITUDE "[0.004, 0.01]"
#define ALONG "[1.0, 0.0]"
#else
#define VELOCITY "[0.3, -0.2, 0.1]"
#define AMPLITUDE "[0.004, 0.01, -0.006]"
#define ALONG "[1.0, 0.0, 0.0]"
#endif

/* x = x0 + v t + A sin(2 pi f t), and its derivative by a difference. */
static void moving_wall_follows_its_formula(void **state)
{
    const double t1 = 0.0371, h = 1e-6;
    struct view before, now, after;
    double *x, *u, *x_before;
    struct tank t;
    int n;

    (void)state;
    tank_make(&t, tank_water, FRAME("velocity = " VELOCITY "; amplitude = " AMPLITUDE ";"
                                    " frequency = 7.0;"), TANK_EFFECTS, NULL);
    n = particles_count(plan_particles(t.plan), KIND_WALL) * DIM;
    x = test_malloc(n * sizeof *x);
    u = test_malloc(n * sizeof *u);
    x_before = test_malloc(n * sizeof *x_before);
    observe_view(t.moment, t1, t.y, &now);
    memcpy(x, now.x[KIND_WALL], n * sizeof *x);
    memcpy(u, now.u[KIND_WALL], n * sizeof *u);
    observe_view(t.moment, t1 - h, t.y, &before);
    memcpy(x_before, before.x[KIND_WALL], n * sizeof *x);
    observe_view(t.moment, t1 + h, t.y, &after);
    for (int i = 0; i < n; i++) {
        const int d = i % DIM;
        const double x0 = now.p->x0[now.p->from[KIND_WALL] + i / DIM][d];
        const double place = x0 + velocity[d] * t1
                           + amplitude[d] * sin(2 * M_PI * frequency * t1);
        check(fabs(x[i] - place) < 1e-15, "point %d: %.17g instead of %.17g", i / DIM, x[i], place);
        check(fabs((after.x[KIND_WALL][i] - x_before[i]) / (2 * h) - u[i]) < 1e-8,
              "point %d moves with %g, but says %g", i / DIM,
              (after.x[KIND_WALL][i] - x_before[i]) / (2 * h), u[i]);
    }
    test_free(x);
    test_free(u);
    test_free(x_before);
    tank_free(&t);
}

/* Force on the tank along x when all water slides with 1 m/s, by viscosity alone. */
static double drag(const char *walls, const char *effect)
{
    struct tank t;
    double force = 0;

    tank_make(&t, tank_water, walls, effect, NULL);
    for (long i = 0; i < particles_count(plan_particles(t.plan), KIND_FLUID); i++)
        t.y[tank_at(&t, "velocity of fluid", NULL) + i * DIM] = 1;
    tank_rates(&t, 0, t.y, t.ydot);
    for (int o = 0; o < plan_particles(t.plan)->objects; o++)
        if (plan_particles(t.plan)->object[o].kind != KIND_FLUID)
            force += moment_force(t.moment, o)[0];
    tank_free(&t);
    return force;
}

static void viscosity_acts_on_sticky_walls_only(void **state)
{
    static const char *const effect[] = {
        "effects = { continuity = { }; laminar-viscosity = { mu = 1.0; }; };",
        "effects = { continuity = { };"
        " artificial-viscosity = { alpha = 0.1; stick = \"particles\"; }; };",
    };

    (void)state;
    for (int i = 0; i < 2; i++) {
        const double sticky = drag(tank_frame, effect[i]);
        const double slip = drag(FRAME("slip = true;"), effect[i]);
        const double along = drag(FRAME("velocity = " ALONG ";"), effect[i]);
        check(sticky > 0.01, "%s\nthe water drags a sticky wall with %g N", effect[i], sticky);
        check(slip == 0, "%s\nthe water drags a wall that slips with %g N", effect[i], slip);
        check(fabs(along) < 1e-12 * sticky, "%s\na wall that goes along is dragged with %g N",
              effect[i], along);
    }
}

/* Pressure does not care whether the wall slips. */
static void slip_leaves_pressure_alone(void **state)
{
    static const char *const effect = "effects = { continuity = { }; pressure = { }; };";
    struct tank a, b;

    (void)state;
    tank_make(&a, tank_water, tank_frame, effect, NULL);
    tank_make(&b, tank_water, FRAME("slip = true;"), effect, NULL);
    tank_rates(&a, 0, a.y, a.ydot);
    tank_rates(&b, 0, b.y, b.ydot);
    assert_int_equal(a.n, b.n);
    for (long i = 0; i < plan_layout(a.plan)->from[LAYOUT_OTHER]; i++)
        check(a.ydot[i] == b.ydot[i], "entry %ld (%s): %g and %g", i, moment_entry(a.moment, i),
              a.ydot[i], b.ydot[i]);
    tank_free(&a);
    tank_free(&b);
}

/* Power of a wall that is pushed against the water: force times its velocity. */
static void driven_wall_gives_power(void **state)
{
    struct book_sheet before, after;
    const double h = 1e-3;
    double force, power, given;
    struct tank t;
    int wall = 0;

    (void)state;
    tank_make(&t, tank_water, FRAME("velocity = " ALONG ";"), TANK_EFFECTS, NULL);
    while (plan_particles(t.plan)->object[wall].kind != KIND_WALL)
        wall++;
    tank_shake(&t, 3, 0.2, 0.5, 0.01);
    tank_rates(&t, 0, t.y, t.ydot);
    force = moment_force(t.moment, wall)[0];
    observe_sheet(t.moment, 0, t.y, &before);
    for (long i = 0; i < t.n; i++)
        t.y[i] += h * t.ydot[i];
    observe_sheet(t.moment, h, t.y, &after);
    char name[BOOK_WORKS][80];
    for (int i = 0; i < book_work_names(t.plan, name); i++)
        if (strcmp(name[i], "walls") == 0) {
            given = (after.work[i] - before.work[i]) / h;
            power = -force * 1.0;
            check(fabs(given - power) < 1e-9 * fabs(power) && power != 0,
                  "the wall gives %g W, force times velocity is %g W", given, power);
        }
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(moving_wall_follows_its_formula),
        cmocka_unit_test(viscosity_acts_on_sticky_walls_only),
        cmocka_unit_test(slip_leaves_pressure_alone),
        cmocka_unit_test(driven_wall_gives_power),
    };

    return cmocka_run_group_tests_name("solids", tests, NULL, NULL);
}
