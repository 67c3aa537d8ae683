/* operator.c -- tests of kernel-viscosity.c, the operator of doc/adding-a-part.md. */
#include "added.h"

#include "base/status.h"

#include <math.h>
#include <string.h>

#define SIDE(side)                                                                       \
    "effects = { continuity = { }; kernel-viscosity = { mu = 5.0; side = \"" side "\"; }; };"

static void it_is_listed_and_explained(void **state)
{
    (void)state;
    added_is_told(ADDED_EFFECTS, "kernel-viscosity");
}

static void absent_it_costs_nothing(void **state)
{
    (void)state;
    added_costs_nothing("kernel-viscosity");
}

/* The last velocity of each particle is that of a wave along x. */
static void make_wave(struct tank *t, const char *effects)
{
    tank_make(t, added_lattice, effects, NULL);
    const struct particles *p = plan_particles(t->plan);
    const long u = tank_at(t, "velocity of fluid", NULL);
    for (int i = 0; i < particles_count(p, KIND_FLUID); i++)
        t->y[u + i * DIM + DIM - 1] = sin(2 * M_PI / added_wave * p->x0[i][0]);
}

static double kinetic(const struct tank *t, const double *y)
{
    const long u = tank_at(t, "velocity of fluid", NULL);
    double sum = 0;

    for (int i = 0; i < particles_count(plan_particles(t->plan), KIND_FLUID) * DIM; i++)
        sum += y[u + i] * y[u + i];
    return sum;
}

/* A shear wave decays with mu/rho k^2, less what (S2) leaves out, some (kH)^2/30 of it. */
static void check_viscosity(void)
{
    struct tank t;

    make_wave(&t, SIDE("explicit"));
    tank_rates(&t, 0, t.y, t.ydot);
    const long u = tank_at(&t, "velocity of fluid", NULL) + DIM - 1;
    const double k = 2 * M_PI / added_wave, expected = -5.0 / 1000 * k * k;
    check(fabs(t.ydot[u] / t.y[u] / expected - 1) < 0.05, "decays with %g 1/s, not %g 1/s",
          t.ydot[u] / t.y[u], expected);
    tank_free(&t);
}

static void it_is_a_viscosity_of_mu(void **state)
{
    (void)state;
    added_at_all_widths(check_viscosity);
}

/* Both sides give the same rates; the implicit one has them all. */
static void check_sides(void)
{
    struct tank t, stiff;

    tank_make(&t, tank_water, tank_frame, SIDE("explicit"), NULL);
    tank_make(&stiff, tank_water, tank_frame, SIDE("implicit"), NULL);
    tank_shake(&t, 3, 0.2, 1, 0.01);
    memcpy(stiff.y, t.y, (size_t)t.n * sizeof *t.y);
    assert_string_equal(plan_viscous(stiff.plan), "effects.kernel-viscosity");
    assert_null(plan_viscous(t.plan));
    tank_rates(&t, 0, t.y, t.ydot);
    assert_int_equal(moment_eval(stiff.moment, ASK_IMPLICIT_SIDE, 0, stiff.y, stiff.ydot),
                     STATUS_DONE);
    const struct layout_row *row;
    const long u = tank_at(&t, "velocity of fluid", &row);
    for (long i = 0, g = DIM - 1; i < (long)row->n * DIM; i++) {
        const double weight = i % DIM == g ? -9.81 : 0, found = stiff.ydot[u + i];
        check(fabs(t.ydot[u + i] - weight - found) < 1e-9, "entry %ld: %g explicit, %g implicit",
              i, t.ydot[u + i] - weight, found);
    }
    tank_free(&t);
    tank_free(&stiff);
}

static void both_sides_are_the_same_law(void **state)
{
    (void)state;
    added_at_all_widths(check_sides);
}

/* z of z - gamma f_I(z) = y into `to`; f_I(y) is in ydot then. */
static void solve(struct tank *t, double gamma, double *to)
{
    assert_int_equal(moment_eval(t->moment, ASK_IMPLICIT_SIDE, 0, t->y, t->ydot), STATUS_DONE);
    memcpy(to, t->y, (size_t)t->n * sizeof *to);
    moment_solve_tolerance(t->moment, 1e-9);
    assert_int_equal(moment_solve(t->moment, 0, gamma, t->y, to), STATUS_DONE);
}

/* Steps of velocities alone: a short implicit one is the explicit one, less a second order;
 * a long one takes energy, where the explicit one gives some. */
static void check_steps(void)
{
    struct tank t;

    tank_make(&t, added_lattice, SIDE("implicit"), NULL);
    tank_shake(&t, 5, 0.2, 1, 0.01);
    double *z = tank_copy(&t, t.y), *euler = tank_copy(&t, t.y), gap[2];
    const struct layout_row *row;
    const long u = tank_at(&t, "velocity of fluid", &row), n = (long)row->n * DIM;
    for (int way = 0; way < 2; way++) {
        const double gamma = way ? 1e-5 : 2e-5;
        solve(&t, gamma, z);
        gap[way] = 0;
        for (long i = u; i < u + n; i++)
            gap[way] += pow(z[i] - t.y[i] - gamma * t.ydot[i], 2);
    }
    check(fabs(sqrt(gap[0] / gap[1]) - 4) < 0.1, "half a step: a gap of 1/%g, not 1/4",
          sqrt(gap[0] / gap[1]));
    solve(&t, 10, z);
    for (long i = u; i < u + n; i++)
        euler[i] = t.y[i] + 10 * t.ydot[i];
    check(kinetic(&t, z) < 0.01 * kinetic(&t, t.y), "a long implicit step leaves %g of the energy",
          kinetic(&t, z) / kinetic(&t, t.y));
    check(kinetic(&t, euler) > 10 * kinetic(&t, t.y), "a long explicit step is harmless");
    test_free(z);
    test_free(euler);
    tank_free(&t);
}

static void implicit_steps_agree_when_short_and_hold_when_long(void **state)
{
    (void)state;
    added_at_all_widths(check_steps);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_listed_and_explained),
        cmocka_unit_test(absent_it_costs_nothing),
        cmocka_unit_test(it_is_a_viscosity_of_mu),
        cmocka_unit_test(both_sides_are_the_same_law),
        cmocka_unit_test(implicit_steps_agree_when_short_and_hold_when_long),
    };

    return cmocka_run_group_tests_name("operator", tests, NULL, NULL);
}
