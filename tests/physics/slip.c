/* slip.c -- artificial viscosity that leaves solids out is no friction at walls, and is all
 * that it was between particles of the fluid; laminar viscosity sticks as ever. */
#include "tank.h"

#include <math.h>
#include <string.h>

#define STICKS "artificial-viscosity = { alpha = 0.3; stick = \"particles\"; };"
#define SLIPS "artificial-viscosity = { alpha = 0.3; stick = \"none\"; };"
#define EFFECTS(VISCOSITY) "effects = { continuity = { }; " VISCOSITY " };"

/* u_x = base + rate y, along the floor; nothing moves up or down. */
static void shear(struct tank *t, double base, double rate)
{
    const double *x = t->y + tank_at(t, "position of fluid", NULL);
    double *u = t->y + tank_at(t, "velocity of fluid", NULL);
    const int n = particles_count(plan_particles(t->plan), KIND_FLUID);

    memset(u, 0, (size_t)n * DIM * sizeof *u);
    for (int i = 0; i < n; i++)
        u[i * DIM] = base + rate * x[i * DIM + DIM - 1];
    tank_rates(t, 0, t->y, t->ydot);
}

static void make(struct tank *t, const char *effects)
{
    tank_make(t, tank_bare_water, tank_frame, TANK_ONE_KERNEL, effects, NULL);
}

/* Largest acceleration besides that of gravity. */
static double brake(const struct tank *t)
{
    const double *udot = t->ydot + tank_at(t, "velocity of fluid", NULL);
    const double *g = plan_scales(t->plan)->g;
    double most = 0;

    for (int i = 0; i < particles_count(plan_particles(t->plan), KIND_FLUID) * DIM; i++)
        most = fmax(most, fabs(udot[i] - g[i % DIM]));
    return most;
}

static double on_walls(const struct tank *t, int d)
{
    return moment_force(t->moment, 1)[d];
}

static void water_slides_along_walls_as_one(void **state)
{
    struct tank slips, sticks;

    (void)state;
    make(&slips, EFFECTS(SLIPS));
    make(&sticks, EFFECTS(STICKS));
    shear(&slips, 1, 0);
    shear(&sticks, 1, 0);
    check(brake(&slips) == 0, "water that slips is braked by %g m/s^2", brake(&slips));
    check(brake(&sticks) > 1, "water that sticks is braked by %g m/s^2 only", brake(&sticks));
    tank_free(&slips);
    tank_free(&sticks);
}

static void a_sheared_layer_has_friction_where_it_sticks_only(void **state)
{
    struct tank slips, sticks;

    (void)state;
    make(&slips, EFFECTS(SLIPS));
    make(&sticks, EFFECTS(STICKS));
    shear(&slips, 1, 20);
    shear(&sticks, 1, 20);
    for (int d = 0; d < DIM; d++)
        check(on_walls(&slips, d) == 0, "%g N on walls along which the water slips",
              on_walls(&slips, d));
    check(on_walls(&sticks, 0) > 0.1, "%g N on walls to which it sticks", on_walls(&sticks, 0));
    check(brake(&slips) > 0.1, "the water has lost its own viscosity: %g m/s^2", brake(&slips));
    tank_free(&slips);
    tank_free(&sticks);
}

/* The same beside a beam, which is object 2 or later. */
static void skins_slip_too(void **state)
{
    static const char *const words[] = { EFFECTS(SLIPS), EFFECTS(STICKS) };

    (void)state;
    for (int way = 0; way < 2 && DIM == 2; way++) {
        struct tank t;
        double most = 0;

        tank_make(&t, tank_parted_water, tank_frame, tank_beam, TANK_ONE_KERNEL, words[way], NULL);
        shear(&t, 1, 20);
        for (int o = 0; o < plan_particles(t.plan)->objects; o++)
            for (int d = 0; d < DIM; d++)
                most = fmax(most, fabs(moment_force(t.moment, o)[d]));
        check((most > 0) == (way == 1), "%s: the largest force is %g N", words[way], most);
        tank_free(&t);
    }
}

static void laminar_viscosity_sticks_as_ever(void **state)
{
    struct tank both, alone;

    (void)state;
    make(&both, EFFECTS(SLIPS "laminar-viscosity = { mu = 2.0; };"));
    make(&alone, EFFECTS("laminar-viscosity = { mu = 2.0; };"));
    shear(&both, 1, 20);
    shear(&alone, 1, 20);
    check(fabs(on_walls(&alone, 0)) > 0.1, "%g N on walls: the test is void", on_walls(&alone, 0));
    for (int d = 0; d < DIM; d++)
        check(fabs(on_walls(&both, d) - on_walls(&alone, d)) <= 1e-13 * fabs(on_walls(&alone, 0)),
              "%g N on walls with, %g N without artificial viscosity", on_walls(&both, d),
              on_walls(&alone, d));
    tank_free(&both);
    tank_free(&alone);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(water_slides_along_walls_as_one),
        cmocka_unit_test(a_sheared_layer_has_friction_where_it_sticks_only),
        cmocka_unit_test(skins_slip_too),
        cmocka_unit_test(laminar_viscosity_sticks_as_ever),
    };

    return cmocka_run_group_tests_name("slip", tests, NULL, NULL);
}
