/* fused.c -- laws in one loop give what they give one after the other, to the bit, and
 * every loop that is written is met here. */
#include "tank.h"

#include "plan/inside.h"
#include "space/laws.h"

#include <stdlib.h>
#include <string.h>

static const char *const physics[] = {
    "effects = { continuity = { }; pressure = { }; };",
    "effects = { continuity = { }; pressure = { }; density-diffusion = { delta = 0.1; }; };",
    "effects = { continuity = { }; pressure = { }; artificial-viscosity = { alpha = 0.1; };"
    " density-diffusion = { delta = 0.1; }; };",
    "walls = \"adami\"; effects = { continuity = { }; pressure = { };"
    " laminar-viscosity = { mu = 0.7; }; density-diffusion = { delta = 0.1; }; };",
    "walls = \"adami\"; " TANK_SLIPS,
    "walls = \"contact\"; " TANK_SLIPS,
};
enum { PHYSICS = sizeof physics / sizeof physics[0] };

static const char *const wide[] = { "2", "4", "8" };
enum { WIDTHS = sizeof wide / sizeof wide[0] };

enum { HALVES = 3, TABLES = HALVES * KINDS * KINDS, LOOPS = 14 };
static const unsigned half[HALVES] = { 0, ASK_DENSITIES, ASK_VELOCITIES };

/* All tables of a plan. */
static struct pairs_table *tables(const struct tank *t, int i)
{
    struct pairs_table *const half_table[HALVES] = { t->plan->table.all,
                                                     t->plan->table.densities,
                                                     t->plan->table.velocities };

    return &half_table[i / (KINDS * KINDS)][i % (KINDS * KINDS)];
}

/* leans: gravity pulls sideways, too. */
static void make(struct tank *t, const char *which, bool leans)
{
    char water[2000];

    snprintf(water, sizeof water, "%s", tank_bare_water);
    if (leans)
        memcpy(strstr(water, "gravity = [0"), "gravity = [4", strlen("gravity = [4"));
    tank_make(t, water, tank_frame, "kernel = { support = 2.5; };", which, NULL);
    tank_shake(t, 7, 0.2, 1.0, 0.02);
}

/* Rates of the whole and of both halves, and forces on the tank. */
static double *everything(struct tank *t)
{
    double *all = test_malloc(HALVES * (t->n + DIM) * sizeof *all);

    for (int h = 0; h < HALVES; h++) {
        double *rates = all + h * (t->n + DIM);

        assert_int_equal(moment_eval(t->moment, ASK_HALF(half[h], 0), 0.01, t->y, rates), 0);
        memcpy(rates + t->n, moment_force(t->moment, 1), DIM * sizeof *rates);
    }
    return all;
}

/* Notes the loops that are in use; how many were new. */
static int note_loops(const struct tank *t, pairs_laws **loops, int n)
{
    for (int i = 0; i < TABLES; i++) {
        struct pairs_table one = *tables(t, i);
        int k = 0;

        t->plan->engine->sum->arrange(&one, false);
        if (tables(t, i)->n == 0 || tables(t, i)->laws == one.laws)
            continue;
        while (k < n && loops[k] != tables(t, i)->laws)
            k++;
        if (k == n)
            loops[n++] = tables(t, i)->laws;
    }
    return n;
}

/* Rates by loops and by laws in turn, which are tables with no loop. */
static void compare(struct tank *t, const char *what, const char *width)
{
    double *fused = everything(t);

    for (int i = 0; i < TABLES; i++) {
        t->plan->engine->sum->arrange(tables(t, i), false);
        assert_null(tables(t, i)->straight);
    }
    double *in_turn = everything(t);
    check(memcmp(fused, in_turn, HALVES * (t->n + DIM) * sizeof *fused) == 0,
          "%s, lanes %s: other bits in one loop", what, width);
    test_free(fused);
    test_free(in_turn);
}

static void check_width(const char *width)
{
    pairs_laws *loops[TABLES];
    int n = 0;

    setenv("STIFFWATER_LANES", width, 1);
    for (int which = 0; which < PHYSICS; which++)
        for (int form = 0; form < 4; form++) {
            const bool without = form & 1, leans = form & 2;
            struct tank t;
            char text[400], *diffusion;

            snprintf(text, sizeof text, "%s", physics[which]);
            diffusion = strstr(text, " density-diffusion");
            if (without && diffusion)
                strcpy(diffusion, " };");
            make(&t, text, leans);
            n = note_loops(&t, loops, n);
            compare(&t, text, width);
            tank_free(&t);
        }
    check(n == LOOPS, "lanes %s: %d loops of %d were met", width, n, LOOPS);
    unsetenv("STIFFWATER_LANES");
}

static void one_loop_gives_the_same_bits(void **state)
{
    (void)state;
    for (int l = 0; l < WIDTHS; l++)
        check_width(wide[l]);
}

/* Does a table have a loop of its own, from the list or from a block of rows? */
static bool has_loop(const struct tank *t, const struct pairs_table *table)
{
    struct pairs_table one = *table;

    t->plan->engine->sum->arrange(&one, false);
    return table->n > 0 && (table->straight || table->laws != one.laws);
}

/* There the loop takes rows from the list where registers are many. */
static void single_precision_gives_the_same_bits(void **state)
{
    (void)state;
    for (int l = 0; l < WIDTHS; l++)
        for (int form = 0; form < 2 * PHYSICS; form++) {
            struct tank t;
            char text[400];
            int n = 0;

            setenv("STIFFWATER_LANES", wide[l], 1);
            snprintf(text, sizeof text, "precision = \"single\"; %s", physics[form / 2]);
            make(&t, text, form % 2);
            for (int i = 0; i < TABLES; i++)
                n += has_loop(&t, tables(&t, i));
            check(n > 0, "%s, lanes %s: no loop in single precision", text, wide[l]);
            compare(&t, text, wide[l]);
            tank_free(&t);
        }
    unsetenv("STIFFWATER_LANES");
}

/* A law that is not the usual one of its part, a law between, or another kernel. */
static void what_no_loop_is_written_for_runs_in_turn(void **state)
{
    static const char *const others[] = {
        "kernel = { support = 2.5; }; effects = { continuity = { }; pressure = { };"
        " artificial-viscosity = { only_approaching = true; }; };",
        "kernel = { support = 2.5; }; effects = { continuity = { }; pressure = { };"
        " artificial-viscosity = { }; laminar-viscosity = { }; };",
        "kernel = { type = \"cubic-spline\"; support = 2.5; }; effects = { continuity = { };"
        " pressure = { }; };",
        TANK_SEED_KERNELS "effects = { continuity = { }; pressure = { }; };",
    };

    (void)state;
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        struct tank t;

        tank_make(&t, tank_bare_water, tank_frame, others[i], NULL);
        struct pairs_table *whole = tables(&t, KIND_FLUID * KINDS + KIND_FLUID), one = *whole;
        t.plan->engine->sum->arrange(&one, false);
        check(whole->laws == one.laws, "%s: a loop for other laws is used", others[i]);
        tank_free(&t);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_loop_gives_the_same_bits),
        cmocka_unit_test(single_precision_gives_the_same_bits),
        cmocka_unit_test(what_no_loop_is_written_for_runs_in_turn),
    };

    return cmocka_run_group_tests_name("fused", tests, NULL, NULL);
}
