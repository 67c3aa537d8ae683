/* effect.c -- tests of velocity-smoothing.c, the effect of doc/adding-a-part.md. */
#include "added.h"

#include "plan/inside.h"

#include <math.h>
#include <string.h>

#define SMOOTH(k) "effects = { continuity = { }; velocity-smoothing = { k = " k "; }; };"

static void it_is_listed_and_explained(void **state)
{
    (void)state;
    added_is_told(ADDED_EFFECTS, "velocity-smoothing");
}

static void absent_it_costs_nothing(void **state)
{
    (void)state;
    added_costs_nothing("velocity-smoothing");
}

/* Power that it takes, and that of the velocities' rates; both [W]. */
static void powers(struct tank *t, double *booked, double *found)
{
    const struct particles *p = plan_particles(t->plan);
    const long u = tank_at(t, "velocity of fluid", NULL);

    tank_rates(t, 0, t->y, t->ydot);
    *found = 0;
    for (int i = 0; i < particles_count(p, KIND_FLUID) * DIM; i++)
        *found += p->m[i / DIM] * t->y[u + i] * t->ydot[u + i];
    for (int i = 0; i < t->plan->parts; i++)
        if (strcmp(t->plan->part[i].part->name, "velocity-smoothing") == 0)
            *booked = t->ydot[tank_at(t, "book", NULL) + t->plan->book.work
                              + t->plan->part[i].slot];
}

static void check_energy(void)
{
    struct tank t;

    for (unsigned seed = 1; seed < 20; seed++) {
        double booked = NAN, found;
        tank_make(&t, added_lattice, SMOOTH("20.0"), NULL);
        tank_shake(&t, seed, 0.3, 1, 0.01);
        powers(&t, &booked, &found);
        check(booked < 0, "it gives %g W", booked);
        check(fabs(found / booked - 1) < 1e-12, "books %g W of %g W", booked, found);
        tank_free(&t);
    }
}

static void it_takes_energy_only(void **state)
{
    (void)state;
    added_at_all_widths(check_energy);
}

/* Neighbours weigh 1 together, less W(0): a lone fast particle is slowed at the rate k of
 * that, on the lattice. */
static void a_lone_velocity_decays_at_its_rate(void **state)
{
    struct tank t;

    (void)state;
    tank_make(&t, added_lattice, SMOOTH("20.0"), NULL);
    const struct scales *s = plan_scales(t.plan);
    const long u = tank_at(&t, "velocity of fluid", NULL);
    t.y[u] = 1;
    tank_rates(&t, 0, t.y, t.ydot);
    const double expected = -20 * (1 - s->mass * s->centre / s->rho0);
    check(fabs(t.ydot[u] / expected - 1) < 0.02, "%g 1/s, not %g 1/s", t.ydot[u], expected);
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_listed_and_explained),
        cmocka_unit_test(absent_it_costs_nothing),
        cmocka_unit_test(it_takes_energy_only),
        cmocka_unit_test(a_lone_velocity_decays_at_its_rate),
    };

    return cmocka_run_group_tests_name("effect", tests, NULL, NULL);
}
