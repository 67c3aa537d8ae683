/* study.c -- unit tests of the room study: lists, tables, errors of known size, growth of a
 * disturbance, medians, and children with a limit of time. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "scratch.h"

#include "base/status.h"
#include "study/children.h"
#include "study/error.h"
#include "study/growth.h"
#include "study/point.h"
#include "study/result.h"
#include "study/tabulate.h"
#include "study/words.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static const char *put(const char *name, const char *text)
{
    static char path[4][128];
    static int turn;
    char *to = path[turn++ % 4];
    FILE *file;

    snprintf(to, sizeof path[0], "%s/%s", scratch, name);
    file = fopen(to, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
    return to;
}

static void test_words(void **state)
{
    struct words l;

    (void)state;
    assert_int_equal(words_split(&l, "cks43,leapfrog@0.25", "--methods"), STATUS_DONE);
    assert_int_equal(l.n, 2);
    assert_string_equal(l.word[0], "cks43");
    assert_string_equal(l.word[1], "leapfrog@0.25");
    words_free(&l);
    assert_int_equal(words_split(&l, "[0,-9.81],(1,[2,3]),\"a,b\",x", "--sweep"), STATUS_DONE);
    assert_int_equal(l.n, 4);
    assert_string_equal(l.word[0], "[0,-9.81]");
    assert_string_equal(l.word[1], "(1,[2,3])");
    assert_string_equal(l.word[2], "\"a,b\"");
    words_free(&l);
    assert_int_equal(words_split(&l, "a,,b", "--tols"), STATUS_BAD_SCENE);
    assert_non_null(strstr(status_message(), "--tols"));
    words_free(&l);
    status_clear();
}

static void test_table(void **state)
{
    struct table t;

    (void)state;
    assert_true(table_read(&t, put("a.csv", "# units: s,m,,\nt,x,what,y\n0,1.5,\"far\",-2\n"
                                            "0.1,nan,2b,\n0.2,7\n")));
    assert_int_equal(t.columns, 4);
    assert_int_equal(t.rows, 3);
    assert_int_equal(table_column(&t, "y"), 3);
    assert_int_equal(table_column(&t, "z"), -1);
    near(t.value[1], 1.5, 0);
    near(t.value[3], -2, 0);
    assert_true(isnan(t.value[2]));
    assert_true(isnan(t.value[4 + 1]));
    assert_true(isnan(t.value[4 + 2]));
    assert_true(isnan(t.value[4 + 3]));
    near(t.value[8 + 1], 7, 0);
    assert_true(isnan(t.value[8 + 2]));
    table_free(&t);
    assert_false(table_read(&t, "/no/such/table.csv"));
    table_free(&t);
    assert_false(table_read(&t, put("b.csv", "# nothing\n")));
}

static void test_numbers_of_a_run(void **state)
{
    struct result r;

    (void)state;
    put("run.json", "{\n  \"status\": \"done\",\n  \"steps\": 83,\n  \"cpu_s\": 0.5,\n"
                    "  \"limited_by\": {\n    \"error\": 45\n  },\n  \"energy_defect\": -8e-05,\n"
                    "  \"mean_step\": null\n}\n");
    result_read(&r, scratch);
    near(r.steps, 83, 0);
    near(r.cpu, 0.5, 0);
    near(r.energy_defect, -8e-5, 0);
    assert_true(isnan(r.mean_step));
    assert_true(isnan(r.passes));
    assert_true(isnan(r.error[RESULT_FRONT]));
    result_read(&r, "/no/such/run");
    assert_true(isnan(r.steps));
}

/* Two tables by their text, compared. */
static double apart(double (*how)(const struct table *, const struct table *), const char *run,
                    const char *reference)
{
    struct table a, b;
    double error;

    assert_true(table_read(&a, put("a.csv", run)));
    assert_true(table_read(&b, put("b.csv", reference)));
    error = how(&a, &b);
    table_free(&a);
    table_free(&b);
    return error;
}

/* (3, 4) and (0, 0) off: sqrt(25 / 2); the wall does not count. */
static void test_positions(void **state)
{
    const char *reference = "x,y,ux,kind\n0,0,9,0\n1,1,9,0\n5,5,9,1\n";

    (void)state;
    near(apart(error_positions, "x,y,ux,kind\n3,4,0,0\n1,1,0,0\n9,9,0,1\n", reference),
         sqrt(12.5), 1e-14);
    near(apart(error_positions, "x,y,z,kind\n0,0,2,0\n", "x,y,z,kind\n0,0,0,0\n"), 2, 1e-14);
    assert_true(isnan(apart(error_positions, "x,y,ux,kind\n3,4,0,0\n", reference)));
    assert_true(isnan(apart(error_positions, "x,y,ux,kind\n3,4,0,1\n", "x,y,ux,kind\n3,4,0,1\n")));
    assert_true(isnan(apart(error_positions, "x,y\n3,4\n", "x,y\n3,4\n")));
}

/* The reference goes 4 far and comes back; the run is off by 0, 1, 2: sqrt(5/3) / 4. */
static void test_front(void **state)
{
    const char *reference = "t,x,height\n0,1,8\n1,5,8\n2,2,8\n";

    (void)state;
    near(apart(error_front, "t,x,height\n0,1,0\n1,6,0\n2,0,0\n", reference), sqrt(5. / 3) / 4,
         1e-14);
    near(apart(error_front, "t,x,height\n0,1,0\n1,nan,0\n2,0,0\n", reference), sqrt(4. / 3) / 4,
         1e-14);
    assert_true(isnan(apart(error_front, "t,x,height\n0,1,0\n1,4,0\n", reference)));
    assert_true(isnan(apart(error_front, "t,x,height\n0,1,0\n1,4,0\n1.5,3,0\n", reference)));
    assert_true(isnan(apart(error_front, "t,x,height\n0,1,0\n", "t,x,height\n0,1,0\n")));
}

static void test_impulse_and_tip(void **state)
{
    (void)state;
    near(apart(error_impulse, "t,a.fx,a.ix,b.iy\n0,5,0,0\n1,7,2,6\n",
               "t,a.fx,a.ix,b.iy\n0,0,0,0\n1,0,3,4\n"), sqrt((1 + 4) / 2.) / 5, 1e-14);
    near(apart(error_tip, "t,p.tip_x,p.tip_y,p.tip_angle\n0,0,0,0\n1,1,7,9\n",
               "t,p.tip_x,p.tip_y,p.tip_angle\n0,0,0,0\n1,3,4,0\n"), sqrt(13 / 2.) / 5, 1e-14);
    near(apart(error_body, "t,b.x,b.z,b.vx,b.contact_x\n0,5,1,0,0\n1,8,1,7,9\n",
               "t,b.x,b.z,b.vx,b.contact_x\n0,1,1,0,0\n1,4,5,2,3\n"), sqrt(16. / 2) / 5, 1e-14);
    assert_true(isnan(apart(error_tip, "t,a.ix\n0,0\n1,1\n", "t,a.ix\n0,0\n1,2\n")));
    assert_true(isnan(apart(error_impulse, "t,a.ix\n0,0\n1,1\n", "t,b.ix\n0,0\n1,2\n")));
}

/* With another spacing the same front begins half a spacing further back. */
static void test_change(void **state)
{
    (void)state;
    near(apart(error_front, "t,x\n0,0.5,\n1,2.5\n", "t,x\n0,1\n1,3\n"), 0, 1e-14);
    near(apart(error_probe, "t,p\n0,1\n1,4\n", "t,p\n0,2\n1,5\n"), sqrt(2 / 2.) / 5, 1e-14);
}

/* Means count where there are some. */
static void test_probe(void **state)
{
    (void)state;
    near(apart(error_probe, "t,p,p.mean\n0,9,0\n1,9,1\n", "t,p,p.mean\n0,0,0\n1,0,4\n"),
         sqrt(9 / 2.) / 4, 1e-14);
    assert_true(isnan(apart(error_probe, "t,p\n0,1\n", "t,p\n0,0\n")));
}

/* An object's impulse for 100 rows of 0.01: a force of 3 with a blow of `blow' through a row and
 * a half, of which a mean over 0.02 has less, and one of 4 on another object. */
static void write_impulses(char *to, double blow, double other)
{
    double ix = 0;

    to += sprintf(to, "t,a.fx,a.ix,a.iy,b.ix,b.iy\n");
    for (int i = 0; i <= 100; i++) {
        to += sprintf(to, "%g,99,%.17g,0,0,%.17g\n", 0.01 * i, ix, -0.01 * i * other);
        ix += 0.01 * 3 + (i == 40 ? 0.01 * blow : i == 41 ? 0.005 * blow : 0);
    }
}

static void test_force(void **state)
{
    static char run[8192], reference[8192];

    (void)state;
    write_impulses(run, 12, 4);      /* 3 + 0.75 * 12 = 12 */
    write_impulses(reference, 7, 4); /* 8.25 */
    near(apart(error_force, run, reference), 12 / 8.25 - 1, 1e-12);
    write_impulses(run, 0, 4);
    near(apart(error_force, run, reference), 1 - 4 / 8.25, 1e-12);
    assert_true(isnan(apart(error_force, run, "t,a.fx,a.ix,a.iy,b.ix,b.iy\n0,0,0,0,0,0\n")));
}

static void test_growth(void **state)
{
    double t[100], d[100];
    struct growth found;

    (void)state;
    for (int i = 0; i < 100; i++) {
        t[i] = 0.01 * (i + 1);
        d[i] = 1e-6 * 9.81 * t[i] * t[i] / 2 * exp(7 * t[i]);
    }
    growth_fit(&found, 100, t, d, 1e-6, 9.81, 1.0);
    near(found.rate, 7, 1e-9);
    near(found.until, 0.65, 1e-12); /* ln(100)/7 = 0.658 */
    growth_fit(&found, 100, t, d, 1e-6, 9.81, 1e-8);
    assert_true(isnan(found.rate));
    growth_fit(&found, 100, t, d, 1e-6, 0, 1.0);
    assert_true(isnan(found.rate));
}

static void test_median(void **state)
{
    double median, range, odd[] = { 5, 1, 2 }, even[] = { 8, 1, 2, 4 };

    (void)state;
    tabulate_spread(odd, 3, &median, &range);
    near(median, 2, 0);
    near(range, 4, 0);
    tabulate_spread(even, 4, &median, &range);
    near(median, 3, 0);
    near(range, 7, 0);
    tabulate_spread(odd, 1, &median, &range);
    near(median, 1, 0);
    assert_true(isnan(range));
    tabulate_spread(odd, 0, &median, &range);
    assert_true(isnan(median));
}

/* A run that ended, of a method without tolerances. */
static struct trial ended_trial(struct point *p, const char *method, double cpu, double passes,
                                double front, double energy)
{
    struct trial t = { .point = p, .run.ended = true };

    snprintf(t.method, sizeof t.method, "%s", method);
    t.result = (struct result){ .cpu = cpu, .passes = passes, .energy_defect = energy };
    for (int i = 0; i < RESULT_ERRORS; i++)
        t.result.error[i] = NAN;
    t.result.error[RESULT_FRONT] = front;
    return t;
}

static void read_file(const char *name, char *to, size_t size)
{
    char path[128];
    FILE *from;

    snprintf(path, sizeof path, "%s/%s", scratch, name);
    from = fopen(path, "r");
    assert_non_null(from);
    to[fread(to, 1, size - 1, from)] = '\0';
    fclose(from);
}

static void expect_line(const char *text, const char *line)
{
    if (!strstr(text, line))
        fail_msg("\"%s\" is missing in:\n%s", line, text);
}

/* `slow' takes fewer passes, `quick' fewer seconds; `rough' is cheapest, and has the sign of its
 * energy only; `lost' did not come to its end and is no cheapest run. */
static void test_cheapest(void **state)
{
    const struct compare_order order = { .quiet = true };
    struct point p = { .facts = { .title = "Four", .dimension = 2 } };
    struct trial trial[] = {
        ended_trial(&p, "slow", 2, 100, 1e-3, 1e-2), ended_trial(&p, "quick", 1, 200, 1e-3, 1e-2),
        ended_trial(&p, "rough", 0.5, 50, 0.2, -5), ended_trial(&p, "lost", 0.1, 10, NAN, 1e-9),
    };
    struct study s = { .order = &order, .points = 1, .cases = 4, .trials = 4, .point = &p,
                       .trial = trial };
    char text[4096];

    (void)state;
    trial[3].run.code = STATUS_FAILED;
    strcpy(trial[3].run.message, "it | ran away");
    snprintf(s.home.directory, sizeof s.home.directory, "%s", scratch);
    assert_int_equal(tabulate_best(&s), STATUS_DONE);
    read_file("compare.md", text, sizeof text);
    expect_line(text, "\n| CPU time; error at most | front | energy [J/m] |\n");
    expect_line(text, "\n| 1e+1 | rough, 0.5 s | rough, 0.5 s |\n");
    expect_line(text, "\n| 1e+0 | rough, 0.5 s | quick, 1 s |\n");
    expect_line(text, "\n| 1e-2 | quick, 1 s | quick, 1 s |\n");
    expect_line(text, "\n| pair passes; error at most | front | energy [J/m] |\n");
    expect_line(text, "\n| 1e-2 | slow, 100 | slow, 100 |\n");
    expect_line(text, "\n3 of 4 runs came to their end");
    expect_line(text, "\n| lost | failed | it / ran away |\n");
}

/* Free fall by ten spacings of 2 mm: 0.0639 s. */
static void test_early_time(void **state)
{
    (void)state;
    assert_int_equal(point_pieces(1.0, 2e-3, 9.81, 0), 16);
    assert_int_equal(point_pieces(0.01, 2e-3, 9.81, 0), 1);
    assert_int_equal(point_pieces(100, 2e-3, 9.81, 0), 50);
    assert_int_equal(point_pieces(1.0, 0, 0, 0), 10);
    assert_int_equal(point_pieces(1.0, 2e-3, 9.81, 0.1), 10);
    assert_int_equal(point_pieces(1.0, 2e-3, 9.81, 0.3), 4);
    assert_int_equal(point_pieces(1.0, 2e-3, 9.81, 1e-6), 999); /* pictures that a run can make */
}

/* What children_run() tells, for the three tests below. */
static int begun[8], ended[8], begins, ends, most;

static bool begin(void *self, int i)
{
    begun[begins++] = i;
    return !self || i != 1;
}

static int end(void *self, int i)
{
    (void)self;
    ended[ends++] = i;
    return STATUS_DONE;
}

static void look(void *self, int running)
{
    (void)self;
    if (running > most)
        most = running;
}

static int asked_at_once(void)
{
    return begins > 0 ? SIGINT : 0;
}

static double clock_now(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

#define SHELL(text) (char *const[]){ "/bin/sh", "-c", text, NULL }

static void test_children(void **state)
{
    char said[96], line[64] = "";
    struct child child[] = { { .words = SHELL("echo here; sleep 0.2; exit 3") },
                             { .words = SHELL("exit 0") },
                             { .words = SHELL("kill -9 $$") } };
    const struct children_watch watch = { begin, end, look, NULL, &child };
    FILE *file;

    (void)state;
    snprintf(said, sizeof said, "%s", put("said", ""));
    child[0].said = said;
    child[1].said = child[2].said = "/dev/null";
    begins = ends = most = 0;
    assert_int_equal(children_run(child, 3, 1, &watch), STATUS_DONE);
    assert_int_equal(child[0].code, 3);
    assert_int_equal(child[2].code, -9);
    assert_false(child[1].ended); /* left out by begin() */
    assert_int_equal(begins, 3);
    assert_int_equal(ends, 2);
    assert_int_equal(most, 1);
    file = fopen(said, "r");
    assert_non_null(fgets(line, sizeof line, file));
    fclose(file);
    assert_string_equal(line, "here\n");
}

static void test_budget(void **state)
{
    struct child child[] = {
        { .words = SHELL("exec sleep 30"), .said = "/dev/null", .budget = 0.1 },
        { .words = SHELL("trap 'exit 7' TERM; while :; do sleep 0.05; done"), .said = "/dev/null",
          .budget = 1 },
        { .words = SHELL("sleep 0.1"), .said = "/dev/null", .budget = 20 },
    };
    const struct children_watch watch = { begin, end, look, NULL, NULL };
    const double start = clock_now();

    (void)state;
    begins = ends = most = 0;
    assert_int_equal(children_run(child, 3, 2, &watch), STATUS_DONE);
    assert_true(clock_now() - start < 15);
    assert_true(child[0].late);
    assert_int_equal(child[0].code, -SIGTERM);
    assert_true(child[1].late);
    assert_int_equal(child[1].code, 7);
    assert_false(child[2].late);
    assert_int_equal(child[2].code, 0);
    assert_int_equal(ended[0], 0);
    assert_int_equal(most, 2);
}

static void test_stopped(void **state)
{
    struct child child[] = { { .words = SHELL("exec sleep 30"), .said = "/dev/null" },
                             { .words = SHELL("exit 0"), .said = "/dev/null" } };
    const struct children_watch watch = { begin, end, look, asked_at_once, NULL };
    const double start = clock_now();

    (void)state;
    begins = ends = most = 0;
    assert_int_equal(children_run(child, 2, 1, &watch), STATUS_STOPPED);
    assert_true(clock_now() - start < 15);
    assert_int_equal(begins, 1);
    assert_int_equal(ends, 0);
    assert_int_equal(child[0].code, -SIGTERM);
    status_clear();
}

static void test_no_such_program(void **state)
{
    struct child child = { .words = (char *const[]){ "/no/such/program", NULL },
                           .said = "/dev/null" };
    const struct children_watch watch = { begin, end, look, NULL, NULL };

    (void)state;
    begins = 0;
    if (children_run(&child, 1, 1, &watch) == STATUS_DONE)
        assert_int_equal(child.code, 127);
    else
        assert_non_null(strstr(status_message(), "/no/such/program"));
    status_clear();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_words),
        cmocka_unit_test(test_table),
        cmocka_unit_test(test_numbers_of_a_run),
        cmocka_unit_test(test_positions),
        cmocka_unit_test(test_front),
        cmocka_unit_test(test_impulse_and_tip),
        cmocka_unit_test(test_change),
        cmocka_unit_test(test_probe),
        cmocka_unit_test(test_force),
        cmocka_unit_test(test_growth),
        cmocka_unit_test(test_median),
        cmocka_unit_test(test_cheapest),
        cmocka_unit_test(test_early_time),
        cmocka_unit_test(test_children),
        cmocka_unit_test(test_budget),
        cmocka_unit_test(test_stopped),
        cmocka_unit_test(test_no_such_program),
    };

    return cmocka_run_group_tests_name("study", tests, scratch_make, scratch_remove);
}
