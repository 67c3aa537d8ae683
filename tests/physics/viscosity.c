/* viscosity.c -- two ways to the force of laminar viscosity, that of Morris and that by
 * the Laplacian of a kernel: in the flow u = (A y^2, 0) it is 2 A mu/rho everywhere. */
#include "tank.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A block of water alone in the world: no walls, no weight. */
#if DIM == 2
#define BLOCK "dimension = 2; until = 1.0; spacing = 0.01; eos = { c0 = 10.0; };"        \
              "domain = { from = [0.0, 0.0]; to = [0.2, 0.2]; };"                        \
              "fluid = { a = { type = \"box\"; from = [0.0, 0.0]; to = [0.2, 0.2]; }; };"
#else
#define BLOCK "dimension = 3; until = 1.0; spacing = 0.01; eos = { c0 = 10.0; };"        \
              "domain = { from = [0.0, 0.0, 0.0]; to = [0.1, 0.1, 0.1]; };"              \
              "fluid = { a = { type = \"box\"; from = [0.0, 0.0, 0.0]; to = [0.1, 0.1, 0.1]; }; };"
#endif
#define MU 0.5

static const double shear = 3; /* A [1/(m s)] */

static void middle(const struct particles *p, int *which)
{
    double least = HUGE_VAL;

    for (int i = 0; i < particles_count(p, KIND_FLUID); i++) {
        double r2 = 0;
        for (int d = 0; d < DIM; d++)
            r2 += pow(p->x0[i][d] - 0.5 * (p->scales->low[d] + p->scales->high[d]), 2);
        if (r2 < least) {
            least = r2;
            *which = i;
        }
    }
}

/* Acceleration in the middle over 2 A mu/rho, along the flow; nothing acts across it. */
static double found(const char *effect, const char *kernel, double support)
{
    const double *udot;
    struct tank t;
    char keys[256];
    double along;
    int which = 0;

    snprintf(keys, sizeof keys, "kernel = { support = %.3f; %s };"
             "effects = { continuity = { }; %s = { mu = %g; }; };", support, kernel, effect, MU);
    tank_make(&t, BLOCK, keys, NULL);
    middle(plan_particles(t.plan), &which);
    for (int i = 0; i < particles_count(plan_particles(t.plan), KIND_FLUID); i++)
        t.y[tank_at(&t, "velocity of fluid", NULL) + i * DIM] = shear * pow(t.y[i * DIM + 1], 2);
    tank_rates(&t, 0, t.y, t.ydot);
    udot = t.ydot + tank_at(&t, "velocity of fluid", NULL) + which * DIM;
    along = udot[0];
    for (int d = 1; d < DIM; d++)
        check(fabs(udot[d]) <= 1e-12 * fabs(along), "%s: %g m/s^2 across the flow", effect,
              udot[d]);
    tank_free(&t);
    return along / (2 * shear * MU / 1000);
}

/* What is off is the lattice, on which the sum is no integral: less with more
 * neighbours.  Morris divides by r^2 + 0.01 hs^2 and stays 1 to 2 % below. */
static void both_find_the_force_of_a_shear_flow(void **state)
{
    static const struct {
        double support, within;
    } cases[] = { { 2.5, 0.1 }, { 3, 0.055 }, { 4, 0.025 } };

    (void)state;
    for (int i = 0; i < 3; i++) {
        const double morris = found("laminar-viscosity", "", cases[i].support);
        const double laplacian = found("laplacian-viscosity", "viscosity = \"viscosity-log\";",
                                       cases[i].support);
        print_message("# H = %g dx: %.4f by Morris, %.4f by the Laplacian of the force expected\n",
                      cases[i].support, morris, laplacian);
        check(fabs(morris - 1) < cases[i].within, "Morris, H = %g dx: %g", cases[i].support,
              morris);
        check(fabs(laplacian - 1) < cases[i].within, "Laplacian, H = %g dx: %g", cases[i].support,
              laplacian);
    }
}

/* Whatever the water does between walls at rest, both slow it down. */
static void both_only_take_energy(void **state)
{
    static const char *const effects[] = { "laminar-viscosity", "laplacian-viscosity" };
    const double h = 1e-6;

    (void)state;
    for (int i = 0; i < 2; i++)
        for (unsigned seed = 1; seed <= 4; seed++) {
            char keys[256], name[BOOK_WORKS][80];
            struct book_sheet s;
            struct tank t;
            snprintf(keys, sizeof keys, "effects = { continuity = { }; %s = { mu = %g; }; };",
                     effects[i], MU);
            tank_make(&t, tank_bare_water, tank_frame, TANK_SEED_KERNELS, keys, NULL);
            tank_shake(&t, seed, 0.3, 1, 0.02);
            tank_rates(&t, 0, t.y, t.ydot);
            for (long k = 0; k < t.n; k++)
                t.y[k] += h * t.ydot[k];
            observe_sheet(t.moment, h, t.y, &s);
            book_work_names(t.plan, name);
            assert_string_equal(name[0], effects[i]);
            check(s.work[0] < -1e-3 * h, "%s gives %g W", effects[i], s.work[0] / h);
            tank_free(&t);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_find_the_force_of_a_shear_flow),
        cmocka_unit_test(both_only_take_energy),
    };

    return cmocka_run_group_tests_name("viscosity", tests, NULL, NULL);
}
