/* fields.c -- body forces on the water are the slopes of what they store, and
 * what they pull with in all is in the book of momentum. */
#include "tank.h"

#include <math.h>
#include <string.h>

#define CENTRAL "effects = { central-force = { omega = 3.0; centre = " CENTRE "; }; };"
#if DIM == 2
#define CENTRE "[0.04, 0.1]"
#else
#define CENTRE "[0.04, 0.02, 0.1]"
#endif

static double potential(struct tank *t, double *y)
{
    struct book_sheet s;

    observe_sheet(t->moment, 0, y, &s);
    return s.energy.potential;
}

static void acceleration_is_the_slope_of_the_potential(void **state)
{
    const double h = 1e-4;
    struct tank t;
    long x, u;

    (void)state;
    tank_make(&t, tank_water, tank_frame, CENTRAL, NULL);
    tank_shake(&t, 5, 0.3, 0, 0);
    tank_rates(&t, 0, t.y, t.ydot);
    x = tank_at(&t, "position of fluid", NULL);
    u = tank_at(&t, "velocity of fluid", NULL);
    for (int k = 0; k < 40 * DIM; k++) {
        double *entry = &t.y[x + k], before, after, slope;
        *entry -= h;
        before = potential(&t, t.y);
        *entry += 2 * h;
        after = potential(&t, t.y);
        *entry -= h;
        slope = -(after - before) / (2 * h) / plan_scales(t.plan)->mass;
        check(fabs(t.ydot[u + k] - slope) < 1e-6 * 9.81,
              "entry %d: acceleration %.10g, slope %.10g", k, t.ydot[u + k], slope);
    }
    tank_free(&t);
}

/* The sum of momenta grows by what the book has of weight, walls and body force. */
static void its_pull_is_in_the_book(void **state)
{
    struct tank t;
    struct book_sheet s, later;
    const double h = 1e-3;
    double *y;

    (void)state;
    tank_make(&t, tank_water, tank_frame, CENTRAL, NULL);
    tank_shake(&t, 5, 0.3, 0.1, 0);
    tank_rates(&t, 0, t.y, t.ydot);
    observe_sheet(t.moment, 0, t.y, &s);
    y = tank_copy(&t, t.y);
    for (long i = 0; i < t.n; i++)
        y[i] += h * t.ydot[i];
    observe_sheet(t.moment, h, y, &later);
    for (int d = 0; d < DIM; d++) {
        const double gained = later.momentum[d] - s.momentum[d];
        const double given = later.momentum_given[d] - s.momentum_given[d];
        check(fabs(gained) > 1e-6 && fabs(gained - given) < 1e-11 * s.mass,
              "direction %d: gained %.12g, booked %.12g", d, gained, given);
    }
    test_free(y);
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(acceleration_is_the_slope_of_the_potential),
        cmocka_unit_test(its_pull_is_in_the_book),
    };

    return cmocka_run_group_tests_name("fields", tests, NULL, NULL);
}
