/* probes.c -- unit tests of probes over an area, in 2D and 3D: their points have equal shares
 * of it, and in a column of water at rest they read the exact mean. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/status.h"
#include "measure/probe-area.h"
#include "measure/probe.h"

#include <math.h>
#include <string.h>

enum { MOST = 20000, UP = DIM - 1, SIDE = DIM == 2 ? 30 : 20 };

static struct scales scales;
static struct particles all;
static struct view view;
static double x[MOST][DIM], p[MOST], spot[MOST][DIM];

/* A cube of water, SIDE spacings of 0.05 m each way, p = rho g (1 - height/top) above its floor. */
static struct crowd *column(void)
{
    struct crowd *c;

    scales = (struct scales){ .dimension = DIM, .dx = 0.05, .support = 0.15, .hs = 0.075 };
    all = (struct particles){ .scales = &scales };
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++)
            for (int k = 0; k < (DIM == 3 ? SIDE : 1); k++) {
                const int site[3] = { i, j, k };
                for (int d = 0; d < DIM; d++)
                    x[all.n][d] = (site[d] + 0.5) * scales.dx;
                p[all.n] = 9810 * (SIDE * scales.dx - x[all.n][UP]);
                all.n++;
            }
    for (int d = 0; d < DIM; d++)
        scales.high[d] = 2 * SIDE * scales.dx;
    for (int k = 1; k <= KINDS; k++)
        all.from[k] = all.n;
    view = (struct view){ .p = &all, .x = { [KIND_FLUID] = &x[0][0] } };
    assert_int_equal(crowd_create(&all, &c), STATUS_DONE);
    crowd_update(c, &view);
    return c;
}

static struct settings_probe probe(void)
{
    struct settings_probe q = { .what = "pressure", .to = { NAN, NAN, NAN }, .radius = NAN };

    for (int d = 0; d < DIM; d++)
        q.at[d] = SIDE * scales.dx / 2;
    return q;
}

static double mean(const struct crowd *c, const struct settings_probe *q, double step)
{
    const int n = probe_area(q, step, NULL);
    double sum = 0;

    assert_in_range(n, 1, MOST);
    assert_int_equal(probe_area(q, step, spot), n);
    for (int i = 0; i < n; i++)
        sum += probe_pressure(c, p, spot[i]);
    return sum / n;
}

static void assert_part(double seen, double wanted, double part)
{
    if (!(fabs(seen - wanted) <= part * fabs(wanted)))
        fail_msg("%.12g is not %.12g", seen, wanted);
}

/* An upright segment (3D: rectangle) within the column; its ends at any place. */
static void test_hydrostatic(void **state)
{
    struct crowd *c = column();
    struct settings_probe q = probe();
    const double low = 0.231, high = 0.6937, top = SIDE * scales.dx;

    (void)state;
    memcpy(q.to, q.at, sizeof q.to);
    q.at[UP] = low;
    q.to[UP] = high;
    if (DIM == 3)
        q.to[0] += 0.1234;
    /* a sum over a lattice is no integral: 0.4 % with three spacings of support */
    assert_part(mean(c, &q, scales.dx / 2), 9810 * (top - (low + high) / 2), 4e-3);
    crowd_free(&c);
}

/* Above the surface the area is dry and reads 0: the mean times the area is the load.  Within H
 * of the surface the fluid around a point lies deeper than the point, which adds a part of
 * rho g H^2 to a load per width, here measured as 0.13 of it: the mark is 0.15. */
static void test_half_wet(void **state)
{
    struct crowd *c = column();
    struct settings_probe q = probe();
    const double top = SIDE * scales.dx, rim = 0.15 * 9810 * scales.support * scales.support;
    double load;

    (void)state;
    memcpy(q.to, q.at, sizeof q.to);
    q.at[UP] = top / 2;
    q.to[UP] = 1.5 * top;
    load = mean(c, &q, scales.dx / 2) * top;
    if (!(fabs(load - 9810 * top * top / 8) < rim))
        fail_msg("load %g is not %g", load, 9810 * top * top / 8);
    assert_true(mean(c, &q, scales.dx / 2) < 9810 * top / 7); /* and half of it is dry */
    crowd_free(&c);
}

/* In 2D along a line that is neither upright nor level; in 3D over a disc that leans. */
static void test_slanted(void **state)
{
    struct crowd *c = column();
    struct settings_probe q = probe();
    const double top = SIDE * scales.dx, depth = top - q.at[UP];

    (void)state;
    if (DIM == 2) {
        q.to[0] = q.at[0] + 0.2;
        q.to[1] = q.at[1] + 0.3;
    } else {
        q.radius = 0.2;
        q.normal[0] = 1;
        q.normal[1] = -0.3;
        q.normal[2] = 2;
    }
    assert_part(mean(c, &q, scales.dx / 2), 9810 * (DIM == 2 ? depth - 0.15 : depth), 4e-3);
    crowd_free(&c);
}

#if DIM == 3
/* Points of a disc: on it, and as evenly spread as its second moment says: R^2/4 along each
 * of its directions, less by what rings are wide. */
static void test_disc(void **state)
{
    struct settings_probe q = { .to = { NAN }, .radius = 0.5, .at = { 1, 2, 3 },
                                .normal = { 0, 3, 4 } };
    const int n = probe_area(&q, 0.02, spot);
    double along = 0, radial = 0;

    (void)state;
    assert_int_equal(n, 4 * 25 * 25);
    for (int i = 0; i < n; i++) {
        const double a[3] = { spot[i][0] - 1, spot[i][1] - 2, spot[i][2] - 3 };
        assert_true(fabs(3 * a[1] + 4 * a[2]) < 1e-12);
        along += a[0] * a[0] / n;
        radial += (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]) / n;
    }
    assert_part(along, 0.25 * 0.25, 2e-3);
    assert_part(radial, 0.5 * 0.25, 2e-3);
}
#endif

static void test_point(void **state)
{
    struct settings_probe q = { .to = { NAN }, .radius = NAN, .at = { 1, 2, 3 } };

    (void)state;
    assert_int_equal(probe_area(&q, 0.02, spot), 1);
    assert_true(spot[0][0] == 1 && spot[0][1] == 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_hydrostatic),
        cmocka_unit_test(test_half_wet),
        cmocka_unit_test(test_slanted),
#if DIM == 3
        cmocka_unit_test(test_disc),
#endif
        cmocka_unit_test(test_point),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
