/* spread.c -- unit tests of error bars: statistics of known numbers, bands of tables, when they
 * grow wide, particles apart, and shifts of particles at the start. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "scratch.h"

#include "base/status.h"
#include "plan/disturb.h"
#include "study/quantity.h"
#include "study/spread-inside.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A textbook's numbers: mean 5, variance 32/7; 2.364624 is the 97.5 % point with 7 degrees of
 * freedom, 12.706205 that with 1. */
static void test_sample(void **state)
{
    const double eight[] = { 2, 4, 4, 4, 5, 5, 7, 9 }, two[] = { -1, NAN, 3, INFINITY };
    struct sample s;

    (void)state;
    sample_make(&s, 8, eight);
    assert_int_equal(s.n, 8);
    near(s.mean, 5, 1e-14);
    near(s.sd, sqrt(32. / 7), 1e-14);
    near(s.low, 2, 0);
    near(s.high, 9, 0);
    near(s.half, 2.3646242516 * sqrt(32. / 7 / 8), 1e-9);
    sample_make(&s, 4, two);
    assert_int_equal(s.n, 2);
    near(s.mean, 1, 0);
    near(s.sd, sqrt(8), 1e-14);
    near(s.half, 12.7062047362 * 2, 1e-9);
    near(sample_mean(4, two), 1, 0);
}

static void test_sample_of_equals(void **state)
{
    const double same[] = { 0.1, 0.1, 0.1 }, none[] = { NAN };
    struct sample s;

    (void)state;
    sample_make(&s, 3, same);
    near(s.mean, 0.1, 0);
    near(s.sd, 0, 0);
    near(s.half, 0, 0);
    sample_make(&s, 1, same);
    near(s.mean, 0.1, 0);
    assert_true(isnan(s.sd) && isnan(s.half));
    sample_make(&s, 1, none);
    assert_int_equal(s.n, 0);
    assert_true(isnan(s.mean) && isnan(s.low) && isnan(s.sd));
    near(sample_inside(3), 0.5, 0);
    near(sample_inside(9), 0.8, 1e-15);
    near(sample_doubt(9), 0.25, 0);
}

enum { RUNS = 3 };

/* Three runs below scratch, the second of which failed, each with a FILE. */
static struct spread_order order = { .runs = RUNS, .share = 0.1, .quiet = true, .size = 1e-6 };

static void make_runs(struct spread *s, struct member *member, const char *file,
                      const char *const text[RUNS])
{
    *s = (struct spread){ .order = &order, .member = member, .done = 2,
                          .facts = { .until = 4, .dimension = 2 } };
    snprintf(s->home.directory, sizeof s->home.directory, "%s", scratch);
    for (int i = 0; i < RUNS; i++) {
        char path[MEMBER_PATH];
        FILE *to;
        member[i] = (struct member){ .ended = true, .code = i == 1 ? STATUS_FAILED : STATUS_DONE };
        snprintf(member[i].name, sizeof member[i].name, "seed-%d", i + 1);
        member_path(&s->home, &member[i], "snapshots", path);
        assert_int_equal(aside_directory(path), STATUS_DONE);
        member_path(&s->home, &member[i], file, path);
        to = fopen(path, "w");
        assert_non_null(to);
        fputs(text[i], to);
        fclose(to);
    }
}

/* Columns: a falls to -4 in the mean, b.fx and b.fy are one vector. */
static const char *const forces[RUNS] = {
    "# units: s,Pa,N,N\nt,a,b.fx,b.fy\n0,1,3,4\n1,-3,0,0\n2,-1,3,4\n4,0,3,4\n",
    "# units: s,Pa,N,N\nt,a,b.fx,b.fy\n0,9,9,9\n",
    "# units: s,Pa,N,N\nt,a,b.fx,b.fy\n0,1,3,4\n1,-1,0,0\n2,-7,3,4\n4,0,3.5,4\n",
};

static void test_bundle(void **state)
{
    struct member member[RUNS];
    struct spread s;
    struct bundle b;
    struct sample found;

    (void)state;
    make_runs(&s, member, "forces.csv", forces);
    assert_true(bundle_read(&b, &s.home, member, RUNS, "forces.csv"));
    assert_int_equal(b.runs, 2); /* not the one that failed */
    assert_int_equal(b.rows, 4);
    near(bundle_time(&b, 3), 4, 0);
    bundle_sample(&b, 2, 1, &found);
    near(found.mean, -4, 0);
    near(found.low, -7, 0);
    near(found.high, -1, 0);
    near(bundle_size(&b, 1, false, true), 4, 0);
    near(bundle_size(&b, 1, true, true), 5, 0); /* from 1 to -4 */
    near(bundle_size(&b, 2, false, false), 3.25, 0);
    near(bundle_size(&b, 3, false, true), hypot(3.25, 4), 1e-14);
    near(bundle_lost(&b, 1, 1.9), 1, 0);
    near(bundle_lost(&b, 1, 2), 2, 0); /* wider than, not as wide as */
    assert_true(isnan(bundle_lost(&b, 1, 6)));
    assert_true(isnan(bundle_lost(&b, 3, 0)));
    bundle_free(&b);
    assert_false(bundle_read(&b, &s.home, member, RUNS, "beam.csv"));
    bundle_free(&b);
}

static void test_scalars(void **state)
{
    const double all[] = { 0, 4 }, part[] = { 1, 2 }, one[] = { 2, 3 },
                 start[] = { 0, 0.5 };
    struct member member[RUNS];
    struct spread s;
    struct bundle b;
    struct sample found;

    (void)state;
    make_runs(&s, member, "forces.csv", forces);
    assert_true(bundle_read(&b, &s.home, member, RUNS, "forces.csv"));
    bundle_scalar(&b, 1, BUNDLE_PEAK, all, &found); /* downwards: -3 and -7 */
    near(found.mean, -5, 0);
    bundle_scalar(&b, 1, BUNDLE_WHEN, all, &found); /* 1 and 2 s */
    near(found.low, 1, 0);
    near(found.high, 2, 0);
    bundle_scalar(&b, 1, BUNDLE_AVERAGE, all, &found); /* (-1 - 2 - 1)/4, (0 - 4 - 7)/4 */
    near(found.high, -1, 1e-15);
    near(found.low, -2.75, 1e-15);
    bundle_scalar(&b, 1, BUNDLE_PEAK, start, &found); /* upwards there: 1 and 1 */
    near(found.low, 1, 0);
    bundle_scalar(&b, 1, BUNDLE_PEAK, one, &found); /* -1 and -7 */
    near(found.mean, -4, 0);
    bundle_scalar(&b, 1, BUNDLE_AVERAGE, part, &found);
    near(found.high, -2, 1e-15);
    near(found.low, -4, 1e-15);
    bundle_scalar(&b, 1, BUNDLE_AVERAGE, one, &found);
    near(found.low, -7, 0);
    bundle_scalar(&b, 2, BUNDLE_END, all, &found);
    near(found.mean, 3.25, 0);
    bundle_free(&b);
}

/* Other times, or another object: no bundle. */
static void test_unlike(void **state)
{
    const char *const times[RUNS] = { "t,x\n0,1\n1,2\n", "t,x\n", "t,x\n0,1\n1.1,2\n" };
    const char *const names[RUNS] = { "t,x\n0,1\n", "t,x\n", "t,y\n0,1\n" };
    struct member member[RUNS];
    struct spread s;
    struct bundle b;

    (void)state;
    make_runs(&s, member, "front.csv", times);
    assert_false(bundle_read(&b, &s.home, member, RUNS, "front.csv"));
    make_runs(&s, member, "front.csv", names);
    assert_false(bundle_read(&b, &s.home, member, RUNS, "front.csv"));
    assert_int_equal(b.runs, 0);
}

/* Variance of {0, 2}: 2; {0, 0}: 0.  A wall does not count; over a side that repeats after
 * 10, 9.9 and 0.1 are 0.2 apart. */
static void test_apart(void **state)
{
    const char *const pictures[RUNS] = {
        "# units: m,m,,\nx,y,kind\n0,9.9,0\n3,1,0\n5,5,1\n", "x,y,kind\n",
        "# units: m,m,,\nx,y,kind\n2,0.1,0\n3,1,0\n9,9,1\n",
    };
    struct member member[RUNS];
    struct spread s;

    (void)state;
    make_runs(&s, member, "snapshots/0000.csv", pictures);
    s.facts.dx = 0.5;
    s.facts.period[1] = 10;
    spread_apart_read(&s);
    assert_int_equal(s.apart.n, 1);
    near(s.apart.worst[0], sqrt(2 + 0.02) / 0.5, 1e-12);
    near(s.apart.rms[0], sqrt((2 + 0.02) / 2) / 0.5, 1e-12);
    near(s.apart.lost, 0, 0);
    s.facts.dx = 0;
    spread_apart_read(&s);
    assert_int_equal(s.apart.n, 0);
}

static void test_quantities(void **state)
{
    (void)state;
    for (int i = 0; i < SPREAD_INSIDE_TABLES; i++)
        assert_non_null(quantity_tables[i]);
    assert_null(quantity_tables[SPREAD_INSIDE_TABLES]);
    assert_int_equal(quantity_find(1, "right.ix")->tells, 1u << BUNDLE_END);
    assert_true(quantity_find(1, "right.fx")->tells & 1u << BUNDLE_PEAK);
    assert_true(quantity_find(0, "x")->change);
    assert_int_equal(quantity_find(2, "plate.mid_x")->tells, 0);
    assert_false(quantity_find(3, "P1")->change);
}

/* The band of a is wider than a tenth of 4 from 1 s on, that of b.fx, of a vector of size
 * 5.2, nearly so at the end. */
static void test_lost(void **state)
{
    struct member member[RUNS];
    struct spread s;

    (void)state;
    make_runs(&s, member, "forces.csv", forces);
    assert_true(bundle_read(&s.bundle[1], &s.home, member, RUNS, "forces.csv"));
    near(spread_lost(&s, 1, 1), 1, 0);
    assert_true(isnan(spread_lost(&s, 1, 2)));
    order.share = 0.5 / 5.2;
    near(spread_lost(&s, 1, 2), 4, 0);
    order.share = 0.1;
    bundle_free(&s.bundle[1]);
}

enum { MANY = 20000 };

static void test_disturbance(void **state)
{
    static double x[MANY * DIM], other[MANY * DIM];
    const struct settings_disturbance s = { 0.01, 3 }, same = { 0.01, 3 }, seed = { 0.01, 4 },
                                      none = { 0, 3 };
    double sum = 0, sum2 = 0, product = 0, most = 0;
    int equal = 0;

    (void)state;
    disturb_positions(&s, 0.5, x, MANY);
    disturb_positions(&seed, 0.5, other, MANY);
    for (int i = 0; i < MANY * DIM; i++) {
        const double v = x[i] / 0.005;
        most = fmax(most, fabs(v));
        sum += v;
        sum2 += v * v;
        product += v * other[i] / 0.005;
        equal += x[i] == other[i];
    }
    assert_true(most <= 1 && most > 0.999);
    near(sum / (MANY * DIM), 0, 0.015);          /* sd 0.577/200 or less */
    near(sum2 / (MANY * DIM), 1. / 3, 0.01);     /* even between -1 and 1 */
    near(product / (MANY * DIM), 0, 0.01);       /* seeds know nothing of each other */
    assert_int_equal(equal, 0);
    memset(other, 0, sizeof other);
    disturb_positions(&same, 0.5, other, 10); /* of fewer particles the same */
    assert_memory_equal(x, other, 10 * DIM * sizeof *x);
    other[0] = 0.3;
    disturb_positions(&none, 0.5, other, 1);
    near(other[0], 0.3, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sample),
        cmocka_unit_test(test_sample_of_equals),
        cmocka_unit_test_setup_teardown(test_bundle, scratch_make, scratch_remove),
        cmocka_unit_test_setup_teardown(test_scalars, scratch_make, scratch_remove),
        cmocka_unit_test_setup_teardown(test_unlike, scratch_make, scratch_remove),
        cmocka_unit_test_setup_teardown(test_apart, scratch_make, scratch_remove),
        cmocka_unit_test(test_quantities),
        cmocka_unit_test_setup_teardown(test_lost, scratch_make, scratch_remove),
        cmocka_unit_test(test_disturbance),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
