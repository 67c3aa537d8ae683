/* xsph.c -- particles that move with their neighbours in part, (D6), against a double loop with
 * the kernel typed anew; the centre of mass goes its way, so that no work is in the book. */
#include "tank.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define XSPH "effects = { continuity = { }; pressure = { }; xsph = { strength = 0.3; }; };"

/* (K4) */
static double wendland_c2(double r, double H)
{
    const double q = r / H, sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);

    return q < 1 ? sigma * pow(H, -DIM) * pow(1 - q, 4) * (1 + 4 * q) : 0;
}

/* w of particle a. */
static void drift(const struct view *v, double H, int a, double *w)
{
    const double *x = v->x[KIND_FLUID], *u = v->u[KIND_FLUID], *rho = v->rho[KIND_FLUID];

    memset(w, 0, DIM * sizeof *w);
    for (int b = 0; b < particles_count(v->p, KIND_FLUID); b++) {
        double r2 = 0;
        for (int d = 0; d < DIM; d++)
            r2 += pow(x[a * DIM + d] - x[b * DIM + d], 2);
        const double mean = 2 / (1 / rho[a] + 1 / rho[b]);
        for (int d = 0; d < DIM; d++)
            w[d] += 0.3 * v->p->m[b] / mean * wendland_c2(sqrt(r2), H)
                  * (u[b * DIM + d] - u[a * DIM + d]);
    }
}

static void drift_is_that_of_the_formula(void **state)
{
    double all[DIM] = { 0 }, most = 0;
    struct tank t;
    struct view v;
    long x, u;

    (void)state;
    tank_make(&t, tank_water, tank_frame, XSPH, NULL);
    tank_shake(&t, 3, 0.2, 0.3, 0.01);
    tank_rates(&t, 0, t.y, t.ydot);
    observe_view(t.moment, 0, t.y, &v);
    x = tank_at(&t, "position of fluid", NULL);
    u = tank_at(&t, "velocity of fluid", NULL);
    for (int a = 0; a < particles_count(v.p, KIND_FLUID); a++) {
        double w[DIM];
        drift(&v, plan_scales(t.plan)->support, a, w);
        for (int d = 0; d < DIM; d++) {
            const long k = (long)a * DIM + d;
            const double found = t.ydot[x + k] - t.y[u + k];
            check(fabs(found - w[d]) < 1e-12, "particle %d drifts at %.12g, not %.12g m/s", a,
                  found, w[d]);
            all[d] += v.p->m[a] * found;
            most = fmax(most, fabs(found));
        }
    }
    check(most > 0.01, "no particle drifts faster than %g m/s", most);
    for (int d = 0; d < DIM; d++)
        check(fabs(all[d]) < 1e-12 * v.p->m[0] * most * v.p->n, "the centre of mass drifts: %g kg m/s",
              all[d]);
    tank_free(&t);
}

static void equal_velocities_drift_nowhere(void **state)
{
    struct tank t;
    long x, u;

    (void)state;
    tank_make(&t, tank_water, tank_frame, XSPH, NULL);
    tank_shake(&t, 3, 0.2, 0.0, 0.01);
    x = tank_at(&t, "position of fluid", NULL);
    u = tank_at(&t, "velocity of fluid", NULL);
    for (int i = 0; i < DIM * particles_count(plan_particles(t.plan), KIND_FLUID); i++)
        t.y[u + i] = 0.25;
    tank_rates(&t, 0, t.y, t.ydot);
    for (int k = 0; k < 100 * DIM; k++)
        check(t.ydot[x + k] == 0.25, "entry %d moves at %.17g m/s", k, t.ydot[x + k]);
    tank_free(&t);
}

static double booked(const struct book_sheet *s)
{
    double sum = s->pressure_defect;

    for (int i = 0; i < s->works; i++)
        sum += s->work[i];
    return sum;
}

/* Rates of energies by name are those that the book has, drift against the weight among
 * them. */
static void its_work_is_in_the_book(void **state)
{
    struct book_sheet before, after;
    const double h = 1e-7;
    struct tank t;
    double *y;
    int own = -1;
    char name[BOOK_WORKS][80];

    (void)state;
    tank_make(&t, tank_water, tank_frame, XSPH, NULL);
    tank_shake(&t, 5, 0.2, 0.3, 0.01);
    tank_rates(&t, 0, t.y, t.ydot);
    for (int i = 0; i < book_work_names(t.plan, name); i++)
        if (strcmp(name[i], "xsph") == 0)
            own = i;
    check(own >= 0, "it has no column in the book");
    y = tank_copy(&t, t.y);
    for (long i = 0; i < t.n; i++) {
        y[i] = t.y[i] + h * t.ydot[i];
        t.y[i] -= h * t.ydot[i];
    }
    observe_sheet(t.moment, -h, t.y, &before);
    observe_sheet(t.moment, h, y, &after);
    const double gained = (after.total - before.total) / (2 * h);
    const double given = (booked(&after) - booked(&before)) / (2 * h);
    const double work = (after.work[own] - before.work[own]) / (2 * h);
    check(fabs(gained - given) < 1e-7, "energy grows by %.10g W, booked are %.10g W", gained, given);
    check(fabs(work) < 1e-12, "the weight gains %g W by a drift that leaves the centre where it is",
          work);
    test_free(y);
    tank_free(&t);
}

static void what_does_not_go_with_it_is_refused(void **state)
{
    static const char *const other[] = { "central-force = { };", "particle-shifting = { };" };

    (void)state;
    for (int i = 0; i < 2; i++) {
        struct tank t;
        char text[2048];

        snprintf(text, sizeof text, "%s %s effects = { continuity = { }; xsph = { }; %s };",
                 tank_water, tank_frame, other[i]);
        check(tank_try(&t, text) != 0, "it goes with %s", other[i]);
        tank_free(&t);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(drift_is_that_of_the_formula),
        cmocka_unit_test(equal_velocities_drift_nowhere),
        cmocka_unit_test(its_work_is_in_the_book),
        cmocka_unit_test(what_does_not_go_with_it_is_refused),
    };

    return cmocka_run_group_tests_name("xsph", tests, NULL, NULL);
}
