/* bits.c -- the right-hand side is a function of t and y: to the bit on any number
 * of threads and lanes, to rounding whatever was asked before, and looking changes
 * nothing of what comes after. */
#include "tank.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

/* Enough particles for several threads to share. */
#if DIM == 2
static const char *const wide =
    "dimension = 2; until = 1.0; spacing = 2.5e-3; gravity = [0.0, -9.81];"
    "domain = { from = [0.0, 0.0]; to = [0.4, 0.08]; };"
    "fluid = { left = { type = \"box\"; from = [0.0, 0.0]; to = [0.2, 0.06]; };"
    "          right = { type = \"box\"; from = [0.215, 0.0]; to = [0.4, 0.03]; }; };"
    "beam = { plate = { at = [0.2075, 0.0]; length = 0.05; thickness = 4e-3; E = 1e7;"
    "  density = 1200.0; elements = 4; layers = 4; beta = 1e-4; }; };";
#else
static const char *const wide =
    "dimension = 3; until = 1.0; spacing = 2e-2; gravity = [0.0, 0.0, -9.81];"
    "domain = { from = [0.0, 0.0, 0.0]; to = [0.4, 0.24, 0.24]; };"
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0, 0.0]; to = [0.4, 0.24, 0.24]; }; };";
#endif

/* Every way to a density and every model of walls; all kernels at once. */
static const char *const physics[] = {
    TANK_EFFECTS TANK_ONE_KERNEL,
    "walls = \"ghost\"; effects = { summation = { }; pressure = { };"
    " laplacian-viscosity = { mu = 0.7; }; }; eos = { tension = false; };" TANK_SEED_KERNELS,
    "walls = \"adami\";" TANK_EFFECTS TANK_ONE_KERNEL,
    "walls = \"adami\"; effects = { summation = { }; pressure = { };"
    " laminar-viscosity = { mu = 0.7; }; }; eos = { tension = false; };" TANK_SEED_KERNELS,
    "walls = \"contact\";" TANK_EFFECTS TANK_SEED_KERNELS,
};
enum { PHYSICS = sizeof physics / sizeof physics[0] };

static void make(struct tank *t, const char *scene, int which)
{
    tank_make(t, scene, tank_frame, physics[which], NULL);
    tank_shake(t, 7, 0.2, 1.0, 0.02);
}

static void set_threads(int n)
{
#ifdef _OPENMP
    omp_set_num_threads(n);
#else
    (void)n;
#endif
}

static void check_same_bits(const struct tank *t, const double *a, const double *b,
                            const char *what)
{
    for (long i = 0; i < t->n; i++)
        check(memcmp(&a[i], &b[i], sizeof a[i]) == 0, "%s: entry %ld (%s) is %.17g and %.17g",
              what, i, moment_entry(t->moment, i), a[i], b[i]);
}

/* Rates of one moment, then densities that are not in them. */
static double *rates_and_densities(struct tank *t)
{
    const struct particles *p = plan_particles(t->plan);
    double *all = test_malloc((t->n + p->n) * sizeof *all);
    struct view v;

    tank_rates(t, 0.01, t->y, all);
    observe_view(t->moment, 0.01, t->y, &v);
    for (int k = 0; k < KINDS; k++)
        if (v.rho[k])
            memcpy(all + t->n + p->from[k], v.rho[k], particles_count(p, k) * sizeof *all);
    return all;
}

static void check_threads_and_lanes(int which)
{
    static const char *const lanes[] = { "2", "4", "8" };
    double *first = NULL;

    for (int l = 0; l < 3; l++)
        for (int threads = 1; threads <= (which ? 2 : 4); threads *= 2) {
            double *found;
            struct tank t;
            setenv("STIFFWATER_LANES", lanes[l], 1);
            set_threads(threads);
            make(&t, wide, which);
            check(plan_lanes(t.plan) <= 2 << l, "STIFFWATER_LANES=%s gives %d lanes", lanes[l],
                  plan_lanes(t.plan));
            found = rates_and_densities(&t);
            if (first) {
                check_same_bits(&t, first, found, lanes[l]);
                assert_memory_equal(first + t.n, found + t.n,
                                    plan_particles(t.plan)->n * sizeof *first);
                test_free(found);
            } else {
                first = found;
            }
            tank_free(&t);
        }
    test_free(first);
    unsetenv("STIFFWATER_LANES");
    set_threads(2);
}

static void threads_and_lanes_do_not_matter(void **state)
{
    (void)state;
    for (int which = 0; which < PHYSICS; which++)
        check_threads_and_lanes(which);
}

/* Largest entry of each row, for comparisons to rounding. */
static void check_close(const struct tank *t, const double *a, const double *b, double tolerance)
{
    const struct layout *l = plan_layout(t->plan);

    for (int i = 0; i < l->rows; i++) {
        const struct layout_row *r = &l->row[i];
        double size = 0, off = 0;
        for (long k = r->offset; k < r->offset + (long)r->n * r->components; k++) {
            size = fmax(size, fabs(a[k]));
            off = fmax(off, fabs(a[k] - b[k]));
        }
        check(off <= tolerance * size, "%s: %g of %g depends on what was asked before", r->name,
              off, size);
    }
}

static void check_history(int which)
{
    double *home, *first, *second;
    struct tank t;

    make(&t, DIM == 2 || which ? tank_bare_water : wide, which);
    home = tank_copy(&t, t.y);
    first = tank_copy(&t, t.y);
    second = tank_copy(&t, t.y);
    tank_rates(&t, 0.01, home, first);
    tank_rates(&t, 0.01, home, second);
    check_same_bits(&t, first, second, "asked twice");
    tank_shake(&t, 8, 0.005, 0.1, 0.002); /* too little for a rebuild */
    tank_rates(&t, 0.5, t.y, t.ydot);
    check(moment_counts(t.moment)->rebuilds == 1, "%ld rebuilds", moment_counts(t.moment)->rebuilds);
    check(memcmp(t.ydot, first, t.n * sizeof *first) != 0, "another y has the same rates");
    tank_rates(&t, 0.01, home, second);
    check_same_bits(&t, first, second, "after another y");
    for (unsigned seed = 9; seed < 12; seed++) {
        tank_shake(&t, seed, 1.0, 1.0, 0.02);
        tank_rates(&t, 0.5, t.y, t.ydot);
    }
    check(moment_counts(t.moment)->rebuilds > 2, "%ld rebuilds", moment_counts(t.moment)->rebuilds);
    tank_rates(&t, 0.01, home, second);
    check_close(&t, first, second, 1e-12);
    test_free(home);
    test_free(first);
    test_free(second);
    tank_free(&t);
}

static void rates_do_not_depend_on_history(void **state)
{
    (void)state;
    for (int which = 0; which < PHYSICS; which++)
        check_history(which);
}

/* Two plans go the same way; one of them is looked at in every manner between. */
static void check_looking(int which)
{
    struct tank seen, alone;
    struct book_sheet sheet;
    struct limit limit[2];
    struct view view;
    double *aside;

    make(&seen, tank_bare_water, which);
    make(&alone, tank_bare_water, which);
    for (unsigned seed = 20; seed < 40; seed++) {
        const double far = seed % 3 ? 0.01 : 0.2;
        aside = tank_copy(&seen, seen.y);
        tank_shake(&seen, seed + 100, seed % 2 ? 0.5 : 0.004, 0.3, 0.01);
        assert_int_equal(observe_forces(seen.moment, 0.3, seen.y), 0);
        observe_sheet(seen.moment, 0.3, seen.y, &sheet);
        observe_view(seen.moment, 0.4, seen.y, &view);
        moment_limit(seen.moment, 0.4, seen.y, true, limit);
        observe_escaped(seen.moment, 0.5, seen.y);
        memcpy(seen.y, aside, seen.n * sizeof *aside);
        test_free(aside);
        tank_shake(&seen, seed, far, 0.1, 0.001);
        tank_shake(&alone, seed, far, 0.1, 0.001);
        tank_rates(&seen, 0.01, seen.y, seen.ydot);
        tank_rates(&alone, 0.01, alone.y, alone.ydot);
        check_same_bits(&seen, seen.ydot, alone.ydot, "looked at");
    }
    check(moment_counts(seen.moment)->rebuilds == moment_counts(alone.moment)->rebuilds
          && moment_counts(seen.moment)->rebuilds > 3, "%ld rebuilds with, %ld without looking",
          moment_counts(seen.moment)->rebuilds, moment_counts(alone.moment)->rebuilds);
    tank_free(&seen);
    tank_free(&alone);
}

static void looking_changes_nothing(void **state)
{
    (void)state;
    for (int which = 0; which < PHYSICS; which++)
        check_looking(which);
}

/* What the observer reports is what the right-hand side had. */
static void check_observer(int which)
{
    struct tank t;
    double force[DIM];

    make(&t, tank_bare_water, which);
    tank_rates(&t, 0.01, t.y, t.ydot);
    memcpy(force, moment_force(t.moment, 1), sizeof force);
    assert_int_equal(observe_forces(t.moment, 0.01, t.y), 0);
    assert_memory_equal(force, observe_force(t.moment, 1), sizeof force);
    tank_shake(&t, 99, 1.0, 1.0, 0.01); /* needs a list of its own */
    assert_int_equal(observe_forces(t.moment, 0.01, t.y), 0);
    memcpy(force, observe_force(t.moment, 1), sizeof force);
    tank_rates(&t, 0.01, t.y, t.ydot);
    for (int d = 0; d < DIM; d++)
        check(fabs(force[d] - moment_force(t.moment, 1)[d]) <= 1e-11 * fabs(force[d]),
              "the observer sees %g N, the run %g N", force[d], moment_force(t.moment, 1)[d]);
    tank_free(&t);
}

static void observer_sees_the_same_forces(void **state)
{
    (void)state;
    for (int which = 0; which < PHYSICS; which++)
        check_observer(which);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(threads_and_lanes_do_not_matter),
        cmocka_unit_test(rates_do_not_depend_on_history),
        cmocka_unit_test(looking_changes_nothing),
        cmocka_unit_test(observer_sees_the_same_forces),
    };

    return cmocka_run_group_tests_name("bits", tests, NULL, NULL);
}
