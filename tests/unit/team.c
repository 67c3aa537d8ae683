/* team.c -- a run finds the number of threads that makes it fastest, and seldom tries others. */
#include "run/team.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

/* A machine: how long a pass takes with so many threads [s], by its own count of steps. */
typedef double machine(int threads, int step);

enum { PASSES = 4 }; /* of a step */

/* So many steps; returns the threads at the end, and how many each step had. */
static int run_steps(struct team *t, machine *pass, int from, int to, int *had)
{
    static int threads;

    for (int i = from; i < to; i++) {
        if (i == 0)
            threads = t->most;
        if (had)
            had[threads]++;
        threads = team_step(t, PASSES * pass(threads, i), PASSES);
    }
    return threads;
}

static double ideal(int threads, int step)
{
    (void)step;
    return 1e-3 / threads;
}

/* Three fifths cannot be shared: four threads are 1.14 times as fast as two, eight 1.08 as four. */
static double serial(int threads, int step)
{
    (void)step;
    return 1e-3 * (0.6 + 0.4 / threads);
}

/* Each pass pays for its threads: 0.90, 0.75, 0.825 ms of 1, 2, 4. */
static double far(int threads, int step)
{
    (void)step;
    return 0.6e-3 / threads + 0.15e-3 * threads + 0.15e-3 * (threads == 1);
}

static double small(int threads, int step)
{
    (void)step;
    return threads == 1 ? 0.5e-3 : 0.6e-3;
}

/* Every seventh step something else has a core. */
static double shared(int threads, int step)
{
    return ideal(threads, step) * (step % 7 ? 1 : 8);
}

/* For a window's steps something else has a core. */
static int burst;

static double disturbed(int threads, int step)
{
    return serial(threads, step) * (step >= burst && step < burst + 6 ? 8 : 1);
}

/* The first step of more threads than before wakes them: as long as fifty. */
static double cold(int threads, int step)
{
    static int before;
    const bool changed = threads > before;

    before = threads;
    return serial(threads, step) * (changed ? 50 : 1);
}

/* In the middle of the run another program comes. */
static double busy(int threads, int step)
{
    return step < 4000 || threads == 1 ? ideal(threads, step) : 4e-3;
}

/* What it has found after so many steps, be it in a trial or not. */
static int after(machine *pass, int most, int steps)
{
    struct team t;

    team_start(&t, most, false);
    run_steps(&t, pass, 0, steps, NULL);
    return t.now;
}

static void test_ends(void **state)
{
    (void)state;
    assert_int_equal(after(ideal, 16, 4000), 16);
    assert_int_equal(after(serial, 8, 4000), 4);
    assert_int_equal(after(far, 8, 4000), 2);
    assert_int_equal(after(small, 2, 4000), 1);
    assert_int_equal(after(small, 64, 1000), 1);
    assert_int_equal(after(shared, 4, 4000), 4);
    assert_int_equal(after(ideal, 3, 4000), 3);
    assert_int_equal(after(cold, 4, 4000), 4);
}

/* Whatever part of the first trial it falls into. */
static void test_burst(void **state)
{
    (void)state;
    for (burst = 0; burst < 150; burst++)
        assert_int_equal(after(disturbed, 2, 150), 2);
}

static void test_changes(void **state)
{
    int had[9] = { 0 };
    struct team t;

    (void)state;
    team_start(&t, 2, false);
    assert_int_equal(run_steps(&t, busy, 0, 4000, NULL), 2);
    assert_int_equal(run_steps(&t, busy, 4000, 8000, NULL), 1);
    assert_int_equal(run_steps(&t, ideal, 8000, 16000, NULL), 2);
    team_start(&t, 8, false);
    assert_int_equal(run_steps(&t, small, 0, 4000, NULL), 1);
    assert_int_equal(run_steps(&t, serial, 4000, 20000, had), 4);
    assert_in_range(had[8], 10, 400);
}

/* Trials are a small part of a run of 40 s, whether others are faster or not. */
static void test_cost(void **state)
{
    int had[3] = { 0 }, ideally[3] = { 0 };
    struct team t;

    (void)state;
    team_start(&t, 2, false);
    run_steps(&t, small, 0, 20000, had);
    assert_in_range(had[2], 20, 500);
    assert_true(fabs(team_mean(&t) - (had[1] + 1.2 * had[2] * 2) / (had[1] + 1.2 * had[2])) < 1e-9);
    team_start(&t, 2, false);
    run_steps(&t, ideal, 0, 20000, ideally);
    assert_in_range(ideally[1], 20, 500);
}

static void test_fixed(void **state)
{
    int had[9] = { 0 };
    struct team t;

    (void)state;
    team_start(&t, 8, true);
    run_steps(&t, small, 0, 4000, had);
    assert_int_equal(had[8], 4000);
    assert_true(team_mean(&t) == 8);
}

/* Without sums over pairs there is nothing to judge by. */
static void test_nothing(void **state)
{
    struct team t;

    (void)state;
    team_start(&t, 2, false);
    for (int i = 0; i < 4000; i++)
        assert_int_equal(team_step(&t, 1e-3, 0), 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ends), cmocka_unit_test(test_burst), cmocka_unit_test(test_changes),
        cmocka_unit_test(test_cost), cmocka_unit_test(test_fixed), cmocka_unit_test(test_nothing),
    };

    return cmocka_run_group_tests_name("team", tests, NULL, NULL);
}
