/* absent.c -- a part that a scene does not name is not there: neither in the state
 * nor in the instructions of a right-hand side.
 *
 * Built twice: with the table of effects as it is, and (absent-more.c, absent-table*.c)
 * with one effect more, "absent", at every width.  Without arguments these are tests of the
 * state; tests/absent-part.sh runs them with a number of right-hand sides and counts
 * instructions, or has them count their own. */
#include "instructions.h"
#include "tank.h"

#include "base/status.h"
#include "eval/inside.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Rows of water, tank and book of this scene, by hand. */
enum { WATER = 20 * 12, TANK = 26 * 22 - 20 * 16, SIZE = 5 * WATER + TANK + 4 + 1 + 2 * DIM };

static const char *const some =
    "effects = { continuity = { }; pressure = { }; artificial-viscosity = { alpha = 0.1; };"
    " density-diffusion = { delta = 0.1; }; };";

#ifdef ABSENT_MORE
enum { MORE = true };
#else
enum { MORE = false };
#endif

extern const struct part *const effects_table_lanes2[], *const effects_table_lanes4[],
    *const effects_table_lanes8[];

/* The tables of all widths that the build has, whatever this machine can run. */
static const struct part *const *const tables[] = {
    effects_table_lanes2,
#ifdef STIFFWATER_V3
    effects_table_lanes4,
#endif
#ifdef STIFFWATER_V4
    effects_table_lanes8,
#endif
};
enum { TABLES = sizeof tables / sizeof tables[0] };

static bool in_table(const struct part *const *table, const char *name)
{
    for (int i = 0; table[i]; i++)
        if (strcmp(table[i]->name, name) == 0)
            return true;
    return false;
}

/* One program has it at every width, the other at none. */
static void every_width_has_the_same_table(void **state)
{
    (void)state;
    for (int i = 0; i < TABLES; i++) {
        check(in_table(tables[i], "pressure"), "%d lanes: this is no table of effects", 2 << i);
        check(in_table(tables[i], "absent") == MORE, "%d lanes: an effect %s", 2 << i,
              MORE ? "is missing" : "too many");
    }
}

static void state_holds_what_the_scene_names(void **state)
{
    struct tank t;
    const char *path;

    (void)state;
    tank_make(&t, tank_water, tank_frame, some, NULL);
    assert_int_equal(t.n, SIZE);
    for (int i = 0; i < plan_parts(t.plan); i++)
        assert_string_not_equal(plan_part(t.plan, i, &path)->name, "absent");
    tank_free(&t);
}

/* Without a summed density there is no pass over pairs for it, and no memory. */
static void densities_that_evolve_are_not_summed(void **state)
{
    static const char *const none[] = {
        "effects = { continuity = { }; };",
        "walls = \"own-density\"; effects = { continuity = { }; pressure = { }; };",
        "walls = \"adami\"; effects = { continuity = { }; };", /* no law asks for a density */
    };
    static const char *const summed[] = {
        "walls = \"ghost\"; effects = { summation = { }; };",
        "walls = \"adami\"; effects = { continuity = { }; pressure = { }; };",
        "walls = \"adami\"; effects = { summation = { }; pressure = { }; };",
    };
    struct tank t;

    (void)state;
    for (int i = 0; i < 3; i++) {
        tank_make(&t, tank_water, tank_frame, none[i], NULL);
        tank_rates(&t, 0, t.y, t.ydot);
        assert_int_equal(t.plan->passes.fields, 0);
        assert_null(t.moment->work->rho);
        assert_null(t.moment->work->sum);
        tank_free(&t);
        tank_make(&t, tank_water, tank_frame, summed[i], NULL);
        assert_int_equal(t.plan->passes.fields, i == 2 ? 2 : 1);
        assert_non_null(t.moment->work->rho);
        assert_non_null(t.moment->work->sum);
        tank_free(&t);
    }
}

static void name_it(struct tank *t)
{
    static const char *const effects =
        "walls = \"own-density\"; effects = { continuity = { }; pressure = { }; artificial-viscosity = { };"
        " density-diffusion = { }; absent = { }; };";
    char text[2048];
    int status;

    snprintf(text, sizeof text, "%s %s %s", tank_water, tank_frame, effects);
    status = tank_try(t, text);
    check((status == STATUS_DONE) == MORE, "exit %d: %s", status, status_message());
}

/* Named, the effect has its column in the book and nothing else, at every width that this
 * machine runs; where the table lacks it, the scene is refused. */
static void named_it_has_a_column(void **state)
{
    static const char *const wish[] = { "2", "4", "8" };
    const int most = engine_pick()->lanes;
    struct tank t;

    (void)state;
    for (int i = 0; 2 << i <= most; i++) {
        setenv("STIFFWATER_LANES", wish[i], 1);
        name_it(&t);
        if (MORE) {
            check(plan_lanes(t.plan) == 2 << i, "%d lanes, not %s", plan_lanes(t.plan), wish[i]);
            assert_int_equal(t.n, SIZE + 1);
            assert_int_equal(t.plan->passes.fields, 1);
            tank_rates(&t, 0, t.y, t.ydot);
        }
        tank_free(&t);
    }
    unsetenv("STIFFWATER_LANES");
}

static void turn(void *times)
{
    for (long n = *(long *)times; n > 0; n--)
        __asm__ volatile("" : "+r"(n));
}

/* A loop that turns 200 times more takes as many instructions as 100 times more, twice. */
static void instructions_are_counted(void **state)
{
    long times[] = { 100, 200, 400 };
    const long first = instructions_of(turn, &times[0]);
    const long second = instructions_of(turn, &times[1]);
    const long third = instructions_of(turn, &times[2]);

    (void)state;
    if (first < 0)
        skip();
    check(second - first >= 200 && third - second == 2 * (second - first),
          "%ld, %ld, %ld instructions", first, second, third);
}

/* --- for tests/absent-part.sh -------------------------------------------------- */

static void rates(void *tank)
{
    struct tank *t = tank;

    tank_rates(t, 0, t->y, t->ydot);
}

static void report(const char *what, long n, const struct tank *t)
{
    printf("%ld %s, %ld numbers, %s, %d lanes\n", n, what, t->n, MORE ? "more" : "as is",
           plan_lanes(t->plan));
}

/* For a program that counts from outside. */
static void evaluate(int n)
{
    struct tank t;

    tank_make(&t, tank_water, tank_frame, some, NULL);
    tank_shake(&t, 1, 0.1, 0.5, 0.01);
    for (int i = 0; i < n; i++)
        rates(&t);
    report("right-hand sides", n, &t);
    tank_free(&t);
}

/* Of one right-hand side, the list being made, of little water: steps are slow. */
static void step(void)
{
    struct tank t;

    tank_make(&t,
              "dimension = 2; until = 1.0; spacing = 5e-3; gravity = [0.0, -9.81];"
              "domain = { from = [0.0, 0.0]; to = [0.04, 0.03]; };"
              "fluid = { water = { type = \"box\"; from = [0.0, 0.0]; to = [0.04, 0.02]; }; };",
              tank_frame, some, NULL);
    tank_shake(&t, 1, 0.1, 0.5, 0.01);
    rates(&t);
    report("instructions", instructions_of(rates, &t), &t);
    tank_free(&t);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_width_has_the_same_table),
        cmocka_unit_test(state_holds_what_the_scene_names),
        cmocka_unit_test(densities_that_evolve_are_not_summed),
        cmocka_unit_test(named_it_has_a_column),
        cmocka_unit_test(instructions_are_counted),
    };

    if (argc == 1)
        return cmocka_run_group_tests_name("absent", tests, NULL, NULL);
    if (strcmp(argv[1], "steps") == 0)
        step();
    else
        evaluate(atoi(argv[1]));
    return 0;
}
