/* absent.c -- a part that a scene does not name is not there: neither in the state
 * nor in the instructions of a right-hand side.
 *
 * Built twice: with the table of effects as it is, and (absent-table*.c) with one
 * effect more, "absent".  Without arguments these are tests of the state;
 * tests/absent-part.sh runs them with a number of right-hand sides and counts
 * instructions. */
#include "tank.h"

#include "plan/inside.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Rows of water, tank and book of this scene, by hand. */
enum { WATER = 20 * 12, TANK = 26 * 22 - 20 * 16, SIZE = 5 * WATER + TANK + 4 + 1 + 2 * DIM };

static const char *const some =
    "effects = { continuity = { }; pressure = { }; artificial-viscosity = { alpha = 0.1; };"
    " density-diffusion = { delta = 0.1; }; };";

static bool in_table(const char *name)
{
    const struct part *const *table = engine_pick()->effects;

    for (int i = 0; table[i]; i++)
        if (strcmp(table[i]->name, name) == 0)
            return true;
    return false;
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
        "effects = { continuity = { }; pressure = { }; };",
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
        assert_int_equal(t.plan->fields, 0);
        assert_null(t.moment->work->rho);
        assert_null(t.moment->work->sum);
        tank_free(&t);
        tank_make(&t, tank_water, tank_frame, summed[i], NULL);
        assert_int_equal(t.plan->fields, i == 2 ? 2 : 1);
        assert_non_null(t.moment->work->rho);
        assert_non_null(t.moment->work->sum);
        tank_free(&t);
    }
}

/* Named, the effect has its column in the book and nothing else. */
static void named_it_has_a_column(void **state)
{
    struct tank t;

    (void)state;
    if (!in_table("absent"))
        return;
    tank_make(&t, tank_water, tank_frame,
              "effects = { continuity = { }; pressure = { }; artificial-viscosity = { };"
              " density-diffusion = { }; absent = { }; };", NULL);
    assert_int_equal(t.n, SIZE + 1);
    assert_int_equal(t.plan->fields, 1);
    tank_free(&t);
}

static void count(int n)
{
    struct tank t;

    tank_make(&t, tank_water, tank_frame, some, NULL);
    tank_shake(&t, 1, 0.1, 0.5, 0.01);
    for (int i = 0; i < n; i++)
        tank_rates(&t, 0, t.y, t.ydot);
    printf("%d right-hand sides, %ld numbers, %s\n", n, t.n, in_table("absent") ? "more" : "as is");
    tank_free(&t);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(state_holds_what_the_scene_names),
        cmocka_unit_test(densities_that_evolve_are_not_summed),
        cmocka_unit_test(named_it_has_a_column),
    };

    if (argc == 1)
        return cmocka_run_group_tests_name("absent", tests, NULL, NULL);
    count(atoi(argv[1]));
    return 0;
}
