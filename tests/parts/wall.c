/* wall.c -- tests of hydrostatic.c, the wall model of doc/adding-a-part.md. */
#include "added.h"

#include <math.h>

#define EFFECTS "effects = { continuity = { }; pressure = { }; };"
#define HYDROSTATIC "walls = \"hydrostatic\";"

static void it_is_listed_and_explained(void **state)
{
    (void)state;
    added_is_told(ADDED_WALLS, "hydrostatic");
}

static void absent_it_costs_nothing(void **state)
{
    (void)state;
    added_costs_nothing("hydrostatic");
}

/* (W9) typed anew: of wall particle a. */
static double wall_density(const struct view *v, int a)
{
    const struct scales *s = v->p->scales;
    double all = 0, sum = 0;

    for (int b = 0; b < particles_count(v->p, KIND_FLUID); b++) {
        double x[DIM], r2 = 0, rho = v->rho[KIND_FLUID][b];
        for (int d = 0; d < DIM; d++) {
            x[d] = v->x[KIND_WALL][a * DIM + d] - v->x[KIND_FLUID][b * DIM + d];
            r2 += x[d] * x[d];
            rho += s->rho0 * s->g[d] * x[d] / pow(s->c0, 2);
        }
        const double q = sqrt(r2) / s->support, w = q < 1 ? pow(1 - q, 4) * (1 + 4 * q) : 0;
        all += w;
        sum += w * rho;
    }
    return all > 0 ? sum / all : s->rho0;
}

static void check_density(void)
{
    struct tank t;
    struct view v;

    tank_make(&t, tank_water, tank_frame, HYDROSTATIC EFFECTS, NULL);
    tank_shake(&t, 2, 0.2, 1, 0.01);
    tank_rates(&t, 0, t.y, t.ydot);
    observe_view(t.moment, 0, t.y, &v);
    for (int a = 0; a < particles_count(v.p, KIND_WALL); a++) {
        const double expected = wall_density(&v, a), found = v.rho[KIND_WALL][a];
        check(fabs(found / expected - 1) < 1e-13, "wall particle %d: %.17g, not %.17g", a, found,
              expected);
    }
    tank_free(&t);
}

static void density_is_that_of_its_formula(void **state)
{
    (void)state;
    added_at_all_widths(check_density);
}

/* Mean rate of the velocity of the lowest row, upwards, in units of g. */
static double lowest_row(const char *walls)
{
    struct tank t;
    double sum = 0;
    int n = 0;

    tank_make(&t, tank_water, tank_frame, walls, EFFECTS, NULL);
    const struct particles *p = plan_particles(t.plan);
    const long u = tank_at(&t, "velocity of fluid", NULL);
    tank_rates(&t, 0, t.y, t.ydot);
    for (int i = 0; i < particles_count(p, KIND_FLUID); i++)
        if (p->x0[i][DIM - 1] < p->scales->dx) {
            sum += t.ydot[u + i * DIM + DIM - 1];
            n++;
        }
    tank_free(&t);
    return sum / n / 9.81;
}

/* Water at rest stays so above the floor, as well as before walls of the library. */
static void water_above_it_stays_at_rest(void **state)
{
    const double mine = lowest_row(HYDROSTATIC), adami = lowest_row("walls = \"adami\";");

    (void)state;
    print_message("# lowest row: %.3g g; with adami %.3g g\n", mine, adami);
    check(fabs(mine) < 0.05, "the lowest row gets %g g", mine);
    check(fabs(mine - adami) < 0.02, "the lowest row gets %g g, with adami %g g", mine, adami);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_listed_and_explained),
        cmocka_unit_test(absent_it_costs_nothing),
        cmocka_unit_test(density_is_that_of_its_formula),
        cmocka_unit_test(water_above_it_stays_at_rest),
    };

    return cmocka_run_group_tests_name("wall", tests, NULL, NULL);
}
