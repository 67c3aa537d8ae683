/* shepard.c -- densities that are replaced at times: (D7) against a double loop with the kernel
 * typed anew; a constant density stays; nothing else changes; the book has the energy. */
#include "tank.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define FILTER "effects = { continuity = { }; pressure = { };"                                \
               " shepard-filter = { interval = 0.002; }; };"

static const double when = 3 * 0.002; /* [s] an event */

/* (K4) */
static double wendland_c2(double r, double H)
{
    const double q = r / H, sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);

    return q < 1 ? sigma * pow(H, -DIM) * pow(1 - q, 4) * (1 + 4 * q) : 0;
}

static void make(struct tank *t, double dense)
{
    tank_make(t, tank_water, tank_frame, FILTER, NULL);
    tank_shake(t, 5, 0.2, 0.3, dense);
}

/* (D7), written plainly. */
static double formula(const struct tank *t, const double *x, const double *rho, int n, int a)
{
    const double H = plan_scales(t->plan)->support;
    double above = 0, below = 0;

    for (int b = 0; b < n; b++) {
        double r2 = 0;
        for (int d = 0; d < DIM; d++)
            r2 += pow(x[a * DIM + d] - x[b * DIM + d], 2);
        const double m = plan_particles(t->plan)->m[b], W = wendland_c2(sqrt(r2), H);
        above += m * W;
        below += m / rho[b] * W;
    }
    return above / below;
}

static void densities_are_those_of_the_formula(void **state)
{
    const struct layout_row *row;
    struct tank t;
    double most = 0;

    (void)state;
    make(&t, 0.01);
    double *y = tank_copy(&t, t.y);
    const long rho = tank_at(&t, "density of fluid", &row);
    const long x = tank_at(&t, "position of fluid", NULL);
    assert_int_equal(moment_event(t.moment, when, y), 0);
    for (int a = 0; a < row->n; a++) {
        const double want = formula(&t, t.y + x, t.y + rho, row->n, a);
        check(fabs(y[rho + a] / want - 1) < 1e-12, "particle %d: %.15g kg/m^D, not %.15g", a,
              y[rho + a], want);
        most = fmax(most, fabs(want / t.y[rho + a] - 1));
    }
    check(most > 1e-3, "it changes no density by more than %g", most);
    test_free(y);
    tank_free(&t);
}

static void a_constant_density_stays(void **state)
{
    const struct layout_row *row;
    struct tank t;

    (void)state;
    make(&t, 0.01);
    const long rho = tank_at(&t, "density of fluid", &row);
    for (int a = 0; a < row->n; a++)
        t.y[rho + a] = 1003;
    assert_int_equal(moment_event(t.moment, when, t.y), 0);
    for (int a = 0; a < row->n; a++)
        check(fabs(t.y[rho + a] / 1003 - 1) < 1e-14, "particle %d: %.17g", a, t.y[rho + a]);
    tank_free(&t);
}

/* Densities of fluid and the book alone change, and these at its times alone. */
static void nothing_else_changes(void **state)
{
    const struct layout_row *fluid, *book;
    struct tank t;

    (void)state;
    make(&t, 0.01);
    double *y = tank_copy(&t, t.y);
    const long rho = tank_at(&t, "density of fluid", &fluid), at = tank_at(&t, "book", &book);
    assert_int_equal(moment_event(t.moment, when + 1e-5, y), 0);
    assert_memory_equal(y, t.y, (size_t)t.n * sizeof *y);
    assert_int_equal(moment_event(t.moment, when, y), 0);
    for (long i = 0; i < t.n; i++) {
        const bool may = (i >= rho && i < rho + fluid->n) || (i >= at && i < at + book->n);
        check(may || y[i] == t.y[i], "entry %ld has changed", i);
    }
    test_free(y);
    tank_free(&t);
}

static void times_are_multiples_of_its_interval(void **state)
{
    struct tank t;
    double at = 0;

    (void)state;
    make(&t, 0);
    for (int k = 1; k < 1000; k++) {
        at = plan_event(t.plan, at);
        check(at == k * 0.002, "event %d is at %.17g s", k, at);
    }
    check(plan_event(t.plan, 0.0031) == 0.004, "after 3.1 ms comes %g s", plan_event(t.plan, 0.0031));
    tank_free(&t);
}

static void the_book_has_the_energy(void **state)
{
    char name[BOOK_WORKS][BOOK_NAME];
    struct book_sheet before, after;
    struct tank t;
    int own = -1;

    (void)state;
    make(&t, 0.01);
    for (int i = 0; i < book_work_names(t.plan, name); i++)
        if (strcmp(name[i], "shepard-filter") == 0)
            own = i;
    check(own >= 0, "it has no column in the book");
    observe_sheet(t.moment, when, t.y, &before);
    assert_int_equal(moment_event(t.moment, when, t.y), 0);
    observe_sheet(t.moment, when, t.y, &after);
    const double lost = before.total - after.total;
    check(lost > 1e-3 * before.energy.internal, "it takes %g J of %g J that densities store", lost,
          before.energy.internal);
    check(fabs(after.work[own] - before.work[own] + lost) < 1e-12 * before.total,
          "it takes %.12g J and books %.12g J", lost, after.work[own]);
    check(fabs(book_defect(&before, &after)) < 1e-12 * before.total, "the book is open by %g J",
          book_defect(&before, &after));
    tank_free(&t);
}

static void what_does_not_go_with_it_is_refused(void **state)
{
    static const char *const other[] = {
        "walls = \"ghost\"; effects = { summation = { }; shepard-filter = { }; };",
        "effects = { continuity = { }; pressure = { }; shepard-filter = { interval = 1e-30; }; };",
        "eos = { type = \"look-ahead\"; }; effects = { continuity = { }; pressure = { };"
        " shepard-filter = { }; };",
    };

    (void)state;
    for (int i = 0; i < 3; i++) {
        struct tank t;
        char text[2048];

        snprintf(text, sizeof text, "%s %s %s", tank_water, tank_frame, other[i]);
        check(tank_try(&t, text) != 0, "it goes with %s", other[i]);
        tank_free(&t);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(densities_are_those_of_the_formula),
        cmocka_unit_test(a_constant_density_stays),
        cmocka_unit_test(nothing_else_changes),
        cmocka_unit_test(times_are_multiples_of_its_interval),
        cmocka_unit_test(the_book_has_the_energy),
        cmocka_unit_test(what_does_not_go_with_it_is_refused),
    };

    return cmocka_run_group_tests_name("shepard", tests, NULL, NULL);
}
