/* healing.c -- density comes back where there is no pressure, as (D5) says, by every method,
 * and no book knows of it. */
#include "../unit/tank-run.h"

#include "base/status.h"

#include <math.h>
#include <string.h>

#define EFFECTS "effects = { continuity = { }; pressure = { }; artificial-viscosity = { };"
#define HEALING EFFECTS " density-healing = { strength = 0.7; }; };"
#define CLAMPED "eos = { c0 = 20.0; tension = false; };"

static const double when = 0.013; /* [s] */

/* (D5), written plainly. */
static double formula(const struct tank *t, double strength, double rho)
{
    const struct scales *s = plan_scales(t->plan);
    const double x = s->rho0 - rho, d = 0.1 * s->rho0 * pow(s->speed / s->c0, 2);

    return x > 0 ? strength * s->c0 / s->hs * pow(x, 3) / (x * x + d * d) : 0;
}

static void make(struct tank *t, const char *effects)
{
    tank_make(t, tank_bare_water, tank_frame, TANK_ONE_KERNEL, CLAMPED, effects, NULL);
    tank_shake(t, 3, 0.2, 1.0, 0.01);
    tank_rates(t, when, t->y, t->ydot);
}

static void densities_heal_and_nothing_else_changes(void **state)
{
    const struct layout_row *row;
    struct tank with, without;
    int low = 0;

    (void)state;
    make(&with, HEALING);
    make(&without, EFFECTS " };");
    const long at = tank_at(&with, "density of fluid", &row);
    for (long i = 0; i < with.n; i++) {
        const bool fluid = i >= at && i < at + row->n;
        const double more = fluid ? formula(&with, 0.7, with.y[i]) : 0;
        low += more > 0;
        check(fabs(with.ydot[i] - without.ydot[i] - more) <= 1e-14 * (more + fabs(with.ydot[i])),
              "entry %ld: rate %.17g with, %.17g without, and the formula has %.17g", i,
              with.ydot[i], without.ydot[i], more);
    }
    assert_in_range(low, row->n / 4, row->n * 3 / 4);
    tank_free(&with);
    tank_free(&without);
}

static void it_is_as_fast_as_it_says(void **state)
{
    struct limit limit[2];
    struct tank t;
    double most = 0;

    (void)state;
    make(&t, EFFECTS " density-healing = { strength = 1.0; }; };");
    moment_limit(t.moment, when, t.y, false, limit);
    assert_string_equal(limit[1].part, "density-healing");
    for (double x = 0.01; x < 500; x *= 1.01)
        most = fmax(most, (formula(&t, 1, 1000 - x) - formula(&t, 1, 1000 - x / 1.01))
                              / (x - x / 1.01));
    check(fabs(most / limit[1].rate - 1) < 1e-3, "%g/s where the formula has %g/s at most",
          limit[1].rate, most);
    tank_free(&t);
}

/* The x that is left of x after the time t at the rate k: ln x - d^2/(2 x^2) falls by k t. */
static double left(double x, double d, double kt)
{
    const double want = log(x) - d * d / (2 * x * x) - kt;
    double low = 1e-9 * x, high = x;

    for (int i = 0; i < 200; i++) {
        const double z = sqrt(low * high);
        *(log(z) - d * d / (2 * z * z) > want ? &high : &low) = z;
    }
    return low;
}

#if DIM == 2
#define DROP(NAME, AT) NAME " = { from = [" AT ", 0.0]; to = [" AT "5, 0.005]; };"
#define SPACE "dimension = 2; until = 1.0; spacing = 5e-3;"                                  \
    "domain = { from = [0.0, 0.0]; to = [0.2, 0.2]; };"
#else
#define DROP(NAME, AT) NAME " = { from = [" AT ", 0.0, 0.0]; to = [" AT "5, 0.005, 0.005]; };"
#define SPACE "dimension = 3; until = 1.0; spacing = 5e-3;"                                  \
    "domain = { from = [0.0, 0.0, 0.0]; to = [0.2, 0.2, 0.2]; };"
#endif
#define SPRAY SPACE CLAMPED "fluid = {" DROP("a", "0.00") DROP("b", "0.05") DROP("c", "0.10") "};"

/* Three particles, too far from each other to meet. */
static void check_method(const char *method)
{
    static const double share[] = { 0.4, 0.9, 0.999 };
    const double strength = 0.7, tol = 1e-3;
    struct book_sheet sheet;
    struct tank t;

    tank_make(&t, SPRAY HEALING, NULL);
    double *rho = t.y + tank_at(&t, "density of fluid", NULL);
    const struct scales *s = plan_scales(t.plan);
    const double k = strength * s->c0 / s->hs, d = 0.1 * s->rho0 * pow(s->speed / s->c0, 2);
    const double until = 3 / k;

    for (int i = 0; i < 3; i++)
        rho[i] = share[i] * s->rho0;
    tank_run(&t, method, tol, until);
    rho = t.y + tank_at(&t, "density of fluid", NULL);
    for (int i = 0; i < 3; i++) {
        const double x0 = s->rho0 * (1 - share[i]), x = left(x0, d, 3);
        check(fabs(s->rho0 - rho[i] - x) < 0.02 * x0, "%s: %g kg/m^3 below rest became %g, not %g",
              method, x0, s->rho0 - rho[i], x);
    }
    observe_sheet(t.moment, until, t.y, &sheet);
    check(sheet.total == 0 && sheet.defect == 0, "%s: %g J came from nowhere", method,
          sheet.total);
    tank_free(&t);
}

static void spray_comes_back_by_every_method(void **state)
{
    static const char *const methods[] = { "cks43", "ark436", "erk4", "imex3", "dv", "ab3", "adams",
                                           "bdf", "leapfrog@0.02", "euler-cfl@0.02" };

    (void)state;
    for (size_t i = 0; i < sizeof methods / sizeof methods[0]; i++)
        check_method(methods[i]);
}

static void where_there_is_tension_it_is_refused(void **state)
{
    static const char *const bad[][2] = {
        { HEALING, "set eos.tension = false" },
        { CLAMPED "walls = \"ghost\"; effects = { summation = { }; pressure = { };"
          " density-healing = { }; };", "effects.continuity instead of effects.summation" },
    };
    char text[4000];

    (void)state;
    for (int i = 0; i < 2; i++) {
        struct tank t;
        snprintf(text, sizeof text, "%s%s%s%s", tank_bare_water, tank_frame, TANK_ONE_KERNEL,
                 bad[i][0]);
        assert_int_not_equal(tank_try(&t, text), STATUS_DONE);
        check(strstr(status_message(), bad[i][1]) != NULL, "it says: %s", status_message());
        tank_free(&t);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(densities_heal_and_nothing_else_changes),
        cmocka_unit_test(it_is_as_fast_as_it_says),
        cmocka_unit_test(spray_comes_back_by_every_method),
        cmocka_unit_test(where_there_is_tension_it_is_refused),
    };

    return cmocka_run_group_tests_name("healing", tests, NULL, NULL);
}
