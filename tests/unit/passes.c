/* passes.c -- tests of passes: their order by what they need and provide, what is refused, and
 * a pass that solves for a pressure between the others of an evaluation. */
#include "../physics/tank.h"
#include "base/status.h"
#include "eval/passes.h"
#include "space/record.h"

#include <math.h>
#include <string.h>

enum { A = 1 << 0, B = 1 << 1, C = 1 << 2, D = 1 << 3 }; /* fields                  */

#define PASS(NAME, NEEDS, NEIGHBOURS, PROVIDES, ADDS)                                         \
    { .name = (NAME), .needs = (NEEDS), .neighbours = (NEIGHBOURS), .provides = (PROVIDES),     \
      .adds = (ADDS) }

static void check_order(const struct plan_pass *pass, int n, const char *expected)
{
    char found[100] = "";

    for (int i = 0; i < n; i++)
        strcat(found, pass[i].name);
    assert_string_equal(found, expected);
}

static void each_finds_what_it_reads(void **state)
{
    struct plan_pass pass[] = {
        PASS("w", C, 0, D, 0),      /* waits for what its owner reads  */
        PASS("x", 0, B, C, 0),      /* and its neighbours              */
        PASS("b", 0, 0, 0, B),      /* b and a stay in this order      */
        PASS("a", 0, 0, 0, B),
        PASS("y", A, 0, B, 0),      /* A is given                      */
    };

    (void)state;
    check_order(pass, passes_order(pass, 5, A, D), "ybaxw");
}

static void those_that_wait_for_nothing_stay(void **state)
{
    struct plan_pass pass[] = { PASS("c", A, 0, C, 0), PASS("b", A, 0, B, 0),
                                PASS("d", A, 0, D, 0) };

    (void)state;
    check_order(pass, passes_order(pass, 3, A, B | C | D), "cbd");
}

static void what_nothing_asks_for_is_left_out(void **state)
{
    struct plan_pass pass[] = { PASS("d", A, 0, D, 0), PASS("c", B, 0, C, 0),
                                PASS("b", A, 0, B, 0), PASS("e", A, 0, 0, D) };

    (void)state;
    check_order(pass, passes_order(pass, 4, A, C), "bc");
}

static void check_refusal(struct plan_pass *pass, int n, const char *const *words)
{
    assert_int_equal(passes_order(pass, n, A, D), -1);
    for (int i = 0; words[i]; i++)
        if (!strstr(status_message(), words[i]))
            fail_msg("'%s' lacks '%s'", status_message(), words[i]);
    status_clear();
}

static void circles_are_named(void **state)
{
    struct plan_pass circle[] = { PASS("outside", B, 0, D, 0), PASS("one", C, 0, B, 0),
                                  PASS("two", 0, B, C, 0) };
    const char *const words[] = { "circle", "\"one\" waits for", "\"two\" waits for", NULL };
    struct plan_pass lacks[] = { PASS("one", C, 0, D, 0) };
    const char *const missing[] = { "no pass provides", "\"one\"", NULL };
    struct plan_pass twice[] = { PASS("one", 0, 0, D, 0), PASS("two", 0, 0, D, 0) };
    const char *const both[] = { "\"two\" provides", "already", NULL };

    (void)state;
    check_refusal(circle, 3, words);
    check_refusal(lacks, 1, missing);
    check_refusal(twice, 2, both);
}

/* --- of a plan ------------------------------------------------------------------- */

static const char *const scenes[] = {
    TANK_EFFECTS, TANK_SUMMED, "walls = \"adami\"; effects = { summation = { }; pressure = { }; "
                               "particle-shifting = { }; };",
    "effects = { continuity = { }; pressure = { }; laminar-viscosity = { mu = 0.7; side = "
    "\"implicit\"; stick = \"face\"; }; };",
};
enum { SCENES = sizeof scenes / sizeof scenes[0] };

/* Whatever is asked: what a pass reads has been provided before, by a pass that is asked too. */
static void every_question_is_whole(void **state)
{
    (void)state;
    for (int k = 0; k < SCENES; k++) {
        struct tank t;
        tank_make(&t, tank_water, tank_frame, scenes[k], NULL);
        const struct plan_passes *all = &t.plan->passes;
        unsigned made = 0;
        for (int i = 0; i < all->n; i++)
            made |= all->pass[i].provides;
        for (int q = 0; q < PASS_QUESTIONS; q++) {
            unsigned there = ~made;
            if ((1 << q) & (PASS_FOR_IMPLICIT | PASS_FOR_DENSITIES))
                there |= PASS_PUSH; /* never looks ahead in accelerations */
            for (int i = 0; i < all->n; i++) {
                const struct plan_pass *p = &all->pass[i];
                if (!(p->pass->asked & (1u << q)))
                    continue;
                if ((p->needs | p->neighbours | p->adds) & ~there)
                    fail_msg("scene %d, question %d: %s lacks %x", k, q, p->name,
                             (p->needs | p->neighbours | p->adds) & ~there);
                there |= p->provides;
            }
        }
        tank_free(&t);
    }
}

/* The fluid's density, then that of walls, which is made of it, then what reads both. */
static void sums_follow_from_what_they_read(void **state)
{
    static const char *const expected[] = { "effects.summation", "walls",
                                            "effects.particle-shifting" };
    struct tank t;
    int n = 0;

    (void)state;
    tank_make(&t, tank_water, tank_frame, scenes[2], NULL);
    for (int i = 0; i < t.plan->passes.n; i++)
        if (t.plan->passes.pass[i].of)
            assert_string_equal(t.plan->passes.pass[i].name, expected[n++]);
    assert_int_equal(n, 3);
    tank_free(&t);
}

/* --- a pressure that is solved for ------------------------------------------------ */

static double *others; /* what the solve has found of accelerations */

/* Its answer is twice the pressure of the equation of state. */
static int solve(struct evaluation *e, const struct plan_field *of)
{
    const size_t n = (size_t)particles_count(e->view.p, KIND_FLUID) * DIM;

    (void)of;
    memcpy(others, spread_velocities(e->m, e->ydot), n * sizeof *others);
    for (int s = 0; s < e->m->list->listed; s++)
        e->m->work->record[(size_t)s * RECORD + RECORD_P2] *= 2;
    return STATUS_DONE;
}

static const struct pass solving = {
    .name = "solve", .kind = PASS_SOLVE, .needs = PASS_OTHERS | PASS_RECORDS,
    .adds = PASS_PRESSURE | PASS_SOLID_PRESSURE,
    .asked = PASS_FOR_RATES | PASS_FOR_APART | PASS_FOR_VELOCITIES, .run = solve,
};

/* The lines of the program, and one more. */
static const struct pass *table_with_solve(void)
{
    struct pass *table;
    int n = 0;

    while (passes_table[n].name)
        n++;
    table = test_calloc((size_t)n + 2, sizeof *table);
    table[0] = solving;
    memcpy(table + 1, passes_table, (size_t)n * sizeof *table);
    return table;
}

static int place_of(const struct plan *p, const char *name)
{
    for (int i = 0; i < p->passes.n; i++)
        if (strcmp(p->passes.pass[i].name, name) == 0)
            return i;
    return -1;
}

/* All but the pressure comes first, and is what an evaluation without pressure gives; then
 * the pressure, then the laws: twice the pressure gives twice its acceleration. */
static void a_solve_needs_accelerations(void **state)
{
    const struct pass *table = table_with_solve();

    (void)state;
    for (int k = 0; k < SCENES; k += 3) {
        struct tank t;
        tank_make(&t, tank_water, tank_frame, scenes[k], NULL);
        tank_shake(&t, 7, 0.1, 0.2, 0.01);
        const size_t n = (size_t)particles_count(t.plan->particles, KIND_FLUID) * DIM;
        const long at = layout_at(moment_layout(t.moment), t.plan->row.u);
        double *without = test_calloc((size_t)t.n, sizeof *without);
        double *usual = test_calloc((size_t)t.n, sizeof *usual);
        others = test_calloc(n, sizeof *others);
        assert_int_equal(place_of(t.plan, "all but pressure"), -1);
        assert_int_equal(moment_eval(t.moment, (struct ask){ .sides = ASK_EXPLICIT | ASK_IMPLICIT,
                                     .without_pressure = true }, 0, t.y, without), STATUS_DONE);
        assert_int_equal(moment_eval(t.moment, ASK_ALL, 0, t.y, usual), STATUS_DONE);
        assert_int_equal(passes_make((struct plan *)t.plan, table), STATUS_DONE);
        assert_true(place_of(t.plan, "records") < place_of(t.plan, "all but pressure"));
        assert_true(place_of(t.plan, "all but pressure") < place_of(t.plan, "solve"));
        assert_true(place_of(t.plan, "solve") < place_of(t.plan, "laws between particles"));
        assert_int_equal(moment_eval(t.moment, ASK_ALL, 0, t.y, t.ydot), STATUS_DONE);
        assert_memory_equal(others, without + at, n * sizeof *others);
        for (size_t i = 0; i < n; i++) {
            const double rest = without[(size_t)at + i], all = usual[(size_t)at + i];
            const double found = t.ydot[(size_t)at + i] - rest, expected = 2 * (all - rest);
            if (!(fabs(found - expected) <= 1e-9 * (1 + fabs(rest) + fabs(all))))
                fail_msg("scene %d, %zu: %g, expected %g", k, i, found, expected);
        }
        test_free(others);
        test_free(usual);
        test_free(without);
        tank_free(&t);
    }
    test_free((void *)table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_finds_what_it_reads),
        cmocka_unit_test(those_that_wait_for_nothing_stay),
        cmocka_unit_test(what_nothing_asks_for_is_left_out),
        cmocka_unit_test(circles_are_named),
        cmocka_unit_test(every_question_is_whole),
        cmocka_unit_test(sums_follow_from_what_they_read),
        cmocka_unit_test(a_solve_needs_accelerations),
    };

    return cmocka_run_group_tests_name("passes", tests, NULL, NULL);
}
