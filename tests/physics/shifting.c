/* shifting.c -- particles that drift from crowds to gaps, (D4), against a double loop with
 * the kernel typed anew; particles near a surface stay; the work is in the book. */
#include "tank.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define SHIFTING                                                                         \
    "effects = { continuity = { }; pressure = { }; particle-shifting = { strength = 3.0; }; };"

/* (K4) and its slope over r. */
static double wendland_c2(double r, double H)
{
    const double q = r / H, sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);

    return q < 1 ? sigma * pow(H, -DIM) * pow(1 - q, 4) * (1 + 4 * q) : 0;
}

static double slope(double r, double H)
{
    const double q = r / H, sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);

    return q < 1 ? -20 * sigma * pow(H, -DIM - 2) * pow(1 - q, 3) : 0;
}

static double share(double c)
{
    const double s = fmin(fmax((c - 0.85) / 0.1, 0), 1);

    return s * s * (3 - 2 * s);
}

/* w of particle a; returns C. */
static double drift(const struct view *v, const struct scales *s, int a, double *w)
{
    const double *x = v->x[KIND_FLUID] + (long)a * DIM;
    double c = 0, grad[DIM] = { 0 }, w2 = 0;

    for (int k = 0; k < KINDS; k++)
        for (int b = 0; b < particles_count(v->p, k); b++) {
            const double volume = v->p->m[v->p->from[k] + b] / v->rho[k][b];
            double r2 = 0;
            for (int d = 0; d < DIM; d++)
                r2 += pow(x[d] - v->x[k][(long)b * DIM + d], 2);
            c += volume * wendland_c2(sqrt(r2), s->support);
            for (int d = 0; d < DIM; d++)
                grad[d] += volume * slope(sqrt(r2), s->support)
                         * (x[d] - v->x[k][(long)b * DIM + d]);
        }
    for (int d = 0; d < DIM; d++) {
        w[d] = -3 * s->speed * s->hs * share(c) * grad[d];
        w2 += w[d] * w[d];
    }
    for (int d = 0; d < DIM; d++)
        w[d] /= sqrt(1 + w2 / (s->speed * s->speed / 4));
    return c;
}

static void drift_is_that_of_the_formula(void **state)
{
    int inside = 0, between = 0, outside = 0;
    struct tank t;
    struct view v;
    long x, u;

    (void)state;
    tank_make(&t, tank_water, tank_frame, SHIFTING, NULL);
    tank_shake(&t, 3, 0.2, 0.3, 0.01);
    tank_rates(&t, 0, t.y, t.ydot);
    observe_view(t.moment, 0, t.y, &v);
    x = tank_at(&t, "position of fluid", NULL);
    u = tank_at(&t, "velocity of fluid", NULL);
    for (int a = 0; a < particles_count(v.p, KIND_FLUID); a++) {
        double w[DIM];
        const double c = drift(&v, plan_scales(t.plan), a, w);
        for (int d = 0; d < DIM; d++) {
            const long k = (long)a * DIM + d;
            check(fabs(t.ydot[x + k] - t.y[u + k] - w[d]) < 1e-12, "particle %d drifts at %.12g, "
                  "not %.12g m/s (C = %g)", a, t.ydot[x + k] - t.y[u + k], w[d], c);
        }
        inside += c > 0.95;
        between += c > 0.85 && c < 0.95;
        outside += c < 0.85;
    }
    check(inside > 20 && between > 0 && outside > 10, "%d inside, %d between, %d at the surface",
          inside, between, outside);
    tank_free(&t);
}

static void water_on_its_lattice_stays(void **state)
{
    struct tank t;
    long x;

    (void)state;
    tank_make(&t, tank_water, tank_frame, SHIFTING, NULL);
    tank_rates(&t, 0, t.y, t.ydot);
    x = tank_at(&t, "position of fluid", NULL);
    for (int k = 0; k < 10 * DIM; k++)
        check(fabs(t.ydot[x + k]) < 0.02 * plan_scales(t.plan)->speed, "entry %d drifts at %g m/s",
              k, t.ydot[x + k]);
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
    tank_make(&t, tank_water, tank_frame, SHIFTING, NULL);
    tank_shake(&t, 5, 0.2, 0.3, 0.01);
    tank_rates(&t, 0, t.y, t.ydot);
    for (int i = 0; i < book_work_names(t.plan, name); i++)
        if (strcmp(name[i], "particle-shifting") == 0)
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
    check(fabs(work) > 1e-3 && fabs(gained - given) < 1e-4 * fabs(work), "energy grows by %.10g W, "
          "booked are %.10g W, %.10g of them by the drift", gained, given, work);
    test_free(y);
    tank_free(&t);
}

static void fields_beside_the_weight_are_refused(void **state)
{
    struct tank t;
    char text[2048];

    (void)state;
    snprintf(text, sizeof text, "%s %s effects = { continuity = { }; particle-shifting = { }; "
             "central-force = { }; };", tank_water, tank_frame);
    check(tank_try(&t, text) != 0, "it goes with a central force");
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(drift_is_that_of_the_formula),
        cmocka_unit_test(water_on_its_lattice_stays),
        cmocka_unit_test(its_work_is_in_the_book),
        cmocka_unit_test(fields_beside_the_weight_are_refused),
    };

    return cmocka_run_group_tests_name("shifting", tests, NULL, NULL);
}
