/* rest.c -- water that starts at rest stays so: the lattice has the density of
 * water, and its pressure carries its weight. */
#include "tank.h"

#include <math.h>

/* A deep tank, so that there is a bulk: further than H from surface and walls. */
#if DIM == 2
static const char *const deep =
    "dimension = 2; until = 1.0; spacing = 5e-3; gravity = [0.0, -9.81];"
    "domain = { from = [0.0, 0.0]; to = [0.2, 0.2]; };"
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0]; to = [0.2, 0.2]; }; };";
#else
static const char *const deep =
    "dimension = 3; until = 1.0; spacing = 2e-2; gravity = [0.0, 0.0, -9.81];"
    "domain = { from = [0.0, 0.0, 0.0]; to = [0.24, 0.24, 0.24]; };"
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0, 0.0]; to = [0.24, 0.24, 0.24]; }; };";
#endif

/* Is x further than the support from the sides of the water? */
static bool in_bulk(const struct scales *s, const double *x)
{
    for (int d = 0; d < DIM; d++)
        if (x[d] < s->low[d] + s->support || x[d] > s->high[d] - s->support)
            return false;
    return true;
}

static double length(const double *v)
{
    double sum = 0;

    for (int d = 0; d < DIM; d++)
        sum += v[d] * v[d];
    return sqrt(sum);
}

/* Largest acceleration in the bulk [m/s^2]. */
static double largest(struct tank *t)
{
    const struct particles *p = plan_particles(t->plan);
    const double *udot = t->ydot + tank_at(t, "velocity of fluid", NULL);
    double most = 0;
    int n = 0;

    tank_rates(t, 0, t->y, t->ydot);
    for (int i = 0; i < particles_count(p, KIND_FLUID); i++)
        if (in_bulk(p->scales, p->x0[i])) {
            most = fmax(most, length(udot + i * DIM));
            n++;
        }
    check(n > 20, "only %d particles in the bulk", n);
    return most;
}

/* What is left comes from the lattice: it has spacing dx at every depth, though its
 * density is that of compressed water, which takes 4 p/(rho0 c0^2) off the pressure
 * gradient, and the sum over neighbours is off by 0.3 %. */
static void pressure_carries_the_weight(void **state)
{
    const struct particles *p;
    const double *udot;
    struct tank t;
    double most;

    (void)state;
    tank_make(&t, deep, tank_frame, TANK_EFFECTS, NULL);
    p = plan_particles(t.plan);
    most = largest(&t) / 9.81;
    print_message("# largest acceleration in the bulk %.2g g\n", most);
    check(most < 0.025, "largest acceleration in the bulk %g g", most);
    udot = t.ydot + tank_at(&t, "velocity of fluid", NULL);
    for (int i = 0; i < particles_count(p, KIND_FLUID); i++) {
        const double depth = p->scales->high[DIM - 1] - p->x0[i][DIM - 1];
        const double expected = -4 * 9.81 * depth / pow(p->scales->c0, 2);
        if (in_bulk(p->scales, p->x0[i]))
            check(fabs(udot[i * DIM + DIM - 1] / 9.81 - expected) < 0.004,
                  "particle %d, %g m deep: %g g instead of %g g", i, depth,
                  udot[i * DIM + DIM - 1] / 9.81, expected);
    }
    tank_free(&t);
}

/* Without the hydrostatic start the same water falls with g: the test above is
 * not about a sum that is always small. */
static void water_without_pressure_falls(void **state)
{
    struct tank t;

    (void)state;
    tank_make(&t, deep, tank_frame, TANK_EFFECTS, NULL);
    for (long i = 0; i < t.n; i++) /* rho0 everywhere */
        if (i >= plan_layout(t.plan)->from[LAYOUT_OTHER])
            t.y[i] = 1000;
    check(fabs(largest(&t) / 9.81 - 1) < 1e-9, "falls with %g g", largest(&t) / 9.81);
    tank_free(&t);
}

/* sum_b m W = rho0 within the error of the sum, in the middle of the particles. */
static void lattice_has_the_density_of_water(void **state)
{
    struct tank t;
    const struct particles *p;

    (void)state;
    tank_make(&t, deep, tank_frame, TANK_EFFECTS, NULL);
    p = plan_particles(t.plan);
    for (int i = 0; i < particles_count(p, KIND_FLUID); i++) {
        const double H = p->scales->support, sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);
        double rho = 0;
        if (!in_bulk(p->scales, p->x0[i]))
            continue;
        for (int j = 0; j < p->n; j++) {
            double x[DIM], q;
            for (int d = 0; d < DIM; d++)
                x[d] = p->x0[i][d] - p->x0[j][d];
            q = length(x) / H;
            if (q < 1)
                rho += p->m[j] * sigma / pow(H, DIM) * pow(1 - q, 4) * (1 + 4 * q);
        }
        check(fabs(rho / p->scales->rho0 - 1) < 0.01, "particle %d: sum of m W is %g kg/m^3", i,
              rho);
        break; /* all of them are alike */
    }
    tank_free(&t);
}

/* rho(0) is what the equation of state has at depth: bed and surface. */
static void depth_sets_the_density(void **state)
{
    struct tank t;
    const struct particles *p;
    const double *rho;
    double press;

    (void)state;
    tank_make(&t, deep, tank_frame, TANK_EFFECTS, NULL);
    p = plan_particles(t.plan);
    rho = t.y + tank_at(&t, "density of fluid", NULL);
    for (int i = 0; i < particles_count(p, KIND_FLUID); i++) {
        const double depth = p->scales->high[DIM - 1] - p->x0[i][DIM - 1];
        plan_pressures(t.plan, 1, rho + i, &press);
        check(fabs(press - 1000 * 9.81 * depth) < 1e-6 * 1000 * 9.81 * 0.2,
              "particle %d, %g m deep: %g Pa", i, depth, press);
    }
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pressure_carries_the_weight),
        cmocka_unit_test(water_without_pressure_falls),
        cmocka_unit_test(lattice_has_the_density_of_water),
        cmocka_unit_test(depth_sets_the_density),
    };

    return cmocka_run_group_tests_name("rest", tests, NULL, NULL);
}
