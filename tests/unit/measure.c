/* measure.c -- unit tests of the room measure, in 2D and 3D: front, height,
 * probes and pairing on lattices where the answers are known. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/status.h"
#include "measure/crowd.h"
#include "measure/front.h"
#include "measure/pairing.h"
#include "measure/probe.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 20000, UP = DIM - 1 };

/* A tank [0,2] x [0,1] (3D: 0.5 deep), dx = 0.05, H = 3 dx, with a floor and a
 * back wall (x < 0) of three layers. */
static struct scales scales;
static struct particles all;
static struct view view;
static double x[KINDS][MOST][DIM], u[MOST][DIM], p[MOST], m[MOST], rho[MOST];

static void empty_tank(void)
{
    memset(x, 0, sizeof x);
    scales = (struct scales){ .dimension = DIM, .dx = 0.05, .support = 0.15, .hs = 0.075 };
    scales.high[0] = 2;
    scales.high[1] = DIM == 2 ? 1 : 0.5;
    scales.high[UP] = 1;
    all = (struct particles){ .scales = &scales };
}

/* Fluid first, then walls: from[] is kept right for both. */
static void add(enum kind kind, double a, double b, double height)
{
    const int i = particles_count(&all, kind);

    assert_true(i < MOST);
    x[kind][i][0] = a;
    x[kind][i][1] = b;
    x[kind][i][UP] = height;
    for (int k = (int)kind + 1; k <= KINDS; k++)
        all.from[k]++;
    all.n++;
}

/* Lattice sites from (i, height index j) to below (to_i, to_j), all the depth. */
static void add_block(enum kind kind, int i, int to_i, int j, int to_j)
{
    const double dx = scales.dx;

    for (int a = i; a < to_i; a++)
        for (int c = j; c < to_j; c++)
            for (int b = 0; b < (DIM == 3 ? 10 : 1); b++)
                add(kind, (a + 0.5) * dx, (b + 0.5) * dx, (c + 0.5) * dx);
}

static void add_walls(void)
{
    add_block(KIND_WALL, -3, 43, -3, 0);
    add_block(KIND_WALL, -3, 0, 0, 20);
}

static void look(void)
{
    for (int k = 0; k < KINDS; k++)
        view.x[k] = &x[k][0][0];
    view.u[KIND_FLUID] = &u[0][0];
    view.p = &all;
}

static struct crowd *crowd_now(void)
{
    struct crowd *c;

    look();
    assert_int_equal(crowd_create(&all, &c), STATUS_DONE);
    crowd_update(c, &view);
    return c;
}

static struct front front_now(void)
{
    struct crowd *c = crowd_now();
    struct front found;

    front_find(c, &found);
    crowd_free(&c);
    assert_null(c);
    return found;
}

static void assert_near(double seen, double wanted)
{
    if (!(fabs(seen - wanted) < 1e-12))
        fail_msg("%.15g is not %.15g", seen, wanted);
}

/* Counted by hand: sites at r^2 < 9 dx^2 around one; at r = 3 dx kernels are 0. */
static void test_full_lattice(void **state)
{
    (void)state;
    empty_tank();
    assert_int_equal(crowd_full(&scales), DIM == 2 ? 24 : 92);
    scales.support = 2.5 * scales.dx;
    assert_int_equal(crowd_full(&scales), DIM == 2 ? 20 : 80);
}

static void test_column(void **state)
{
    struct front found;

    (void)state;
    empty_tank();
    add_block(KIND_FLUID, 0, 8, 0, 16);
    add_walls();
    found = front_now();
    assert_near(found.x, 7.5 * scales.dx);
    assert_near(found.height, 16 * scales.dx);
}

/* Drops in the air, and single particles on the floor and at the back wall. */
static void test_spray_does_not_count(void **state)
{
    struct front found;

    (void)state;
    empty_tank();
    add_block(KIND_FLUID, 0, 8, 0, 8);
    add_block(KIND_FLUID, 20, 22, 10, 12); /* a drop of four (3D: a thin roll) */
    add(KIND_FLUID, 1.2, 0.25, 0.5 * scales.dx);
    add(KIND_FLUID, 1.3, 0.25, 0.3 * scales.dx); /* pressed onto the floor */
    add(KIND_FLUID, 0.5 * scales.dx, 0.25, 0.8);
    add_walls();
    found = front_now();
    assert_near(found.x, 7.5 * scales.dx);
    assert_near(found.height, 8 * scales.dx);
}

/* Sinking water leaves a film on the wall; the height is that of the water, give
 * or take what of the film stands right on it. */
static void test_film_on_the_wall_does_not_count(void **state)
{
    (void)state;
    empty_tank();
    add_block(KIND_FLUID, 0, 8, 0, 8);
    add_block(KIND_FLUID, 0, 2, 8, 16);
    add_walls();
    assert_true(front_now().height > 7.5 * scales.dx && front_now().height < 10.5 * scales.dx);
}

/* A toe of two layers on the floor is water, up to the last particle but one. */
static void test_thin_toe_counts(void **state)
{
    (void)state;
    empty_tank();
    add_block(KIND_FLUID, 0, 8, 0, 8);
    add_block(KIND_FLUID, 8, 20, 0, 2);
    add_walls();
    assert_true(front_now().x > 17 * scales.dx);
}

static void test_who_left_does_not_count(void **state)
{
    struct front found;

    (void)state;
    empty_tank();
    add_block(KIND_FLUID, 0, 8, 0, 8);
    add_block(KIND_FLUID, 40, 52, 0, 8);      /* beyond the far wall */
    add_block(KIND_FLUID, 0, 8, 22, 30);      /* above the lid       */
    add(KIND_FLUID, 1e30, 0.25, 1e30);
    add(KIND_FLUID, NAN, 0.25, 0.25);
    add_walls();
    found = front_now();
    assert_near(found.x, 7.5 * scales.dx);
    assert_near(found.height, 8 * scales.dx);
}

static void test_no_water(void **state)
{
    (void)state;
    empty_tank();
    assert_true(isnan(front_now().x));
    add(KIND_FLUID, 1, 0.25, 0.5);
    assert_true(isnan(front_now().x));
    assert_near(front_now().height, 0);
}

/* A domain so large that cells of one support would fill the memory. */
static void test_large_domain(void **state)
{
    (void)state;
    empty_tank();
    scales.high[0] = scales.high[UP] = 1e6;
    add_block(KIND_FLUID, 0, 8, 0, 8);
    add_walls();
    assert_near(front_now().x, 7.5 * scales.dx);
}

/* Counting in cells finds what a look at all pairs finds, on points in disorder. */
static void test_cells_miss_no_particle(void **state)
{
    struct crowd *c;
    int water = 0;

    (void)state;
    empty_tank();
    srand(1);
    for (int i = 0; i < (DIM == 2 ? 600 : 3000); i++)
        add(KIND_FLUID, 2.0 * rand() / RAND_MAX, 0.5 * rand() / RAND_MAX, 1.0 * rand() / RAND_MAX);
    look();
    assert_int_equal(crowd_create(&all, &c), STATUS_DONE);
    crowd_update(c, &view);
    for (int i = 0; i < all.n; i++) {
        int near = -1;
        for (int j = 0; j < all.n; j++) {
            double r2 = 0;
            for (int d = 0; d < DIM; d++)
                r2 += pow(x[KIND_FLUID][i][d] - x[KIND_FLUID][j][d], 2);
            near += r2 < scales.support * scales.support;
        }
        assert_int_equal(crowd_is_water(c, i), 2 * near >= crowd_full(&scales));
        water += crowd_is_water(c, i);
    }
    assert_true(water > 20 && water < all.n - 20);
    crowd_free(&c);
}

/* Around a site of a full lattice the mean of a linear field is the field. */
static void test_probe_on_a_linear_field(void **state)
{
    double at[DIM], seen[DIM];
    struct crowd *c;

    (void)state;
    empty_tank();
    add_block(KIND_FLUID, 0, 20, 0, 10);
    c = crowd_now();
    for (int i = 0; i < all.n; i++) {
        const double *y = x[KIND_FLUID][i];
        p[i] = 1000 + 300 * y[0] - 9810 * y[UP];
        for (int d = 0; d < DIM; d++)
            u[i][d] = (d + 1) * y[0] + y[UP];
    }
    at[1] = 5 * scales.dx;
    at[0] = 10 * scales.dx; /* between four (eight) sites: as even as on one */
    at[UP] = 5 * scales.dx;
    if (!(fabs(probe_pressure(c, p, at) - (1000 + 300 * 0.5 - 9810 * 0.25)) < 1e-9))
        fail_msg("pressure %g", probe_pressure(c, p, at));
    probe_velocity(c, at, seen);
    for (int d = 0; d < DIM; d++)
        assert_near(seen[d], (d + 1) * 0.5 + 0.25);
    crowd_free(&c);
}

/* w(0) = 1 and w(1/2) = 3/16. */
static void test_probe_weighs(void **state)
{
    const double at[DIM] = { 0.5 };
    struct crowd *c;

    (void)state;
    empty_tank();
    add(KIND_FLUID, 0.5, 0, 0);
    add(KIND_FLUID, 0.5 + 0.5 * scales.support, 0, 0);
    c = crowd_now();
    p[0] = 0;
    p[1] = 19;
    assert_near(probe_pressure(c, p, at), 3);
    crowd_free(&c);
}

/* A drop at the edge of the support is hardly felt; its velocity is. */
static void test_a_drop_is_no_impact(void **state)
{
    const double at[DIM] = { 0.5 };
    const double part = 3.0 / 16 / ((DIM == 2 ? M_PI / 7 * 9 : 2 * M_PI / 21 * 27) / 16);
    double seen[DIM];
    struct crowd *c;

    (void)state;
    empty_tank();
    add(KIND_FLUID, 0.5 + 0.5 * scales.support, 0, 0);
    c = crowd_now();
    p[0] = 1000;
    u[0][0] = 7;
    if (!(fabs(probe_pressure(c, p, at) - 1000 * fmin(part, 1)) < 1e-9))
        fail_msg("%g of the pressure, %g expected", probe_pressure(c, p, at) / 1000, part);
    assert_true(part < 0.8);
    probe_velocity(c, at, seen);
    assert_near(seen[0], 7);
    crowd_free(&c);
}

/* At a wall the gauge reads a mean of the fluid within the support, no more. */
static void test_probe_at_a_wall_and_in_the_air(void **state)
{
    double at[DIM] = { 0.5 }, seen[DIM];
    struct crowd *c;

    (void)state;
    empty_tank();
    add_block(KIND_FLUID, 0, 20, 0, 10);
    c = crowd_now();
    for (int i = 0; i < all.n; i++)
        p[i] = 9810 * (0.5 - x[KIND_FLUID][i][UP]);
    at[1] = DIM == 3 ? 0.25 : 0;
    assert_true(probe_pressure(c, p, at) < 9810 * 0.5);
    assert_true(probe_pressure(c, p, at) > 9810 * (0.5 - 0.4 * scales.support));
    at[UP] = 0.9;
    assert_true(probe_pressure(c, p, at) == 0);
    probe_velocity(c, at, seen);
    assert_true(seen[0] == 0 && seen[UP] == 0);
    at[UP] = 1e30; /* far out of all cells */
    assert_true(probe_pressure(c, p, at) == 0);
    crowd_free(&c);
}

static void test_probe_of_height(void **state)
{
    double at[DIM] = { 12 * 0.05 };
    struct crowd *c;

    (void)state;
    empty_tank();
    scales.low[UP] = -0.1; /* heights are above the lowest point */
    add_block(KIND_FLUID, 0, 8, 0, 12);
    add_block(KIND_FLUID, 8, 24, 0, 6);
    add_walls();
    look();
    assert_int_equal(crowd_create(&all, &c), STATUS_DONE);
    crowd_update(c, &view);
    at[1] = DIM == 3 ? 0.25 : 0;
    assert_near(probe_height(c, at, DIM - 1), 0.1 + 6 * scales.dx);
    at[0] = 4 * 0.05;
    assert_near(probe_height(c, at, 1), 0.1 + 12 * scales.dx);
    at[0] = 1.8;
    assert_near(probe_height(c, at, DIM - 1), 0);
    crowd_free(&c);
}

/* Masses of a lattice; densities `times` that of it. */
static struct pairing_index pairing_now(double times)
{
    struct pairing *g;
    struct pairing_index found;

    look();
    for (int i = 0; i < MOST; i++) {
        m[i] = 1000 * pow(scales.dx, DIM);
        rho[i] = 1000 * times;
    }
    all.m = m;
    view.rho[KIND_FLUID] = rho;
    assert_int_equal(pairing_create(&all, &g), STATUS_DONE);
    pairing_find(g, &view, &found);
    pairing_free(&g);
    assert_null(g);
    return found;
}

static void test_a_lattice_has_no_pairs(void **state)
{
    struct pairing_index found;

    (void)state;
    empty_tank();
    add_block(KIND_FLUID, 0, 8, 0, 8);
    add_walls();
    found = pairing_now(1);
    assert_near(found.share, 0);
    assert_near(found.mean, 1);
    assert_near(found.least, 1);
    found = pairing_now(pow(1.5, DIM)); /* as dense, each has less room than dx */
    assert_near(found.mean, 1.5);
}

/* Each particle twice, 0.2 dx apart: twice the density. */
static void test_pairs_are_pairs(void **state)
{
    struct pairing_index found;

    (void)state;
    empty_tank();
    add_block(KIND_FLUID, 0, 8, 0, 8);
    add_block(KIND_FLUID, 0, 8, 0, 8);
    for (int i = all.n / 2; i < all.n; i++)
        x[KIND_FLUID][i][UP] += 0.2 * scales.dx;
    found = pairing_now(2);
    assert_near(found.share, 1);
    assert_near(found.mean, 0.2 * pow(2, 1.0 / DIM));
    assert_near(found.least, 0.2 * pow(2, 1.0 / DIM));
}

/* A quarter of the fluid is paired; fluid outside, and solids, are in no pairs. */
static void test_pairs_are_counted(void **state)
{
    const int layer = DIM == 3 ? 80 : 8; /* 8 x 10 sites of the depth, or 8 */
    struct pairing_index found;

    (void)state;
    empty_tank();
    add_block(KIND_FLUID, 0, 8, 0, 7);
    add_block(KIND_FLUID, 0, 8, 0, 1);
    for (int i = 7 * layer; i < 8 * layer; i++)
        x[KIND_FLUID][i][UP] += 0.3 * scales.dx;
    add(KIND_WALL, 2.5 * scales.dx, 0.5 * scales.dx, 5.5 * scales.dx);
    add(KIND_FLUID, 2.5, 0.25, 0.5);
    add(KIND_FLUID, 2.5, 0.25, 0.5);
    add(KIND_FLUID, NAN, 0.25, 0.5);
    found = pairing_now(1);
    assert_near(found.share, 0.25);
    assert_near(found.least, 0.3);
    assert_near(found.mean, (2 * 0.3 + 0.7 + 5) / 8); /* 0.7: those above the pairs */
}

static void test_loners_have_no_neighbour(void **state)
{
    struct pairing_index found;

    (void)state;
    empty_tank();
    found = pairing_now(1);
    assert_true(found.share == 0 && isnan(found.mean) && isnan(found.least));
    add(KIND_FLUID, 0.5, 0.25, 0.5);
    add(KIND_FLUID, 0.5 + 1.01 * scales.support, 0.25, 0.5);
    found = pairing_now(1);
    assert_true(found.share == 0 && isnan(found.mean) && isnan(found.least));
    x[KIND_FLUID][1][0] = 0.5 + 0.99 * scales.support;
    assert_near(pairing_now(1).mean, 0.99 * scales.support / scales.dx);
}

/* What cells find is what a look at all pairs finds, on points in disorder, thick
 * and thin. */
static void test_nearest_of_all(void **state)
{
    (void)state;
    for (int n = 100; n <= 1600; n *= 2) {
        struct pairing_index found, seen = { .least = INFINITY };
        int company = 0;

        empty_tank();
        srand(n);
        for (int i = 0; i < n; i++)
            add(KIND_FLUID, 2.0 * rand() / RAND_MAX, 0.5 * rand() / RAND_MAX,
                1.0 * rand() / RAND_MAX);
        found = pairing_now(1);
        for (int i = 0; i < n; i++) {
            double best = scales.support * scales.support;
            for (int j = 0; j < n; j++) {
                double r2 = 0;
                for (int d = 0; d < DIM; d++)
                    r2 += pow(x[KIND_FLUID][i][d] - x[KIND_FLUID][j][d], 2);
                best = j != i ? fmin(best, r2) : best;
            }
            if (best == scales.support * scales.support)
                continue;
            company++;
            seen.share += sqrt(best) < 0.5 * scales.dx;
            seen.mean += sqrt(best) / scales.dx;
            seen.least = fmin(seen.least, sqrt(best) / scales.dx);
        }
        assert_near(found.share, seen.share / n);
        assert_near(found.mean, seen.mean / company);
        assert_near(found.least, seen.least);
        assert_true(seen.share > 0 && company > n / 4);
    }
}

/* Where directions repeat: neighbours are found beyond the sides, and nothing depends
 * on where the sides lie nor on how many lengths away a particle is. */
static void test_where_directions_repeat(void **state)
{
    struct pairing_index first, found;
    double at[DIM], pressure, seen[DIM], now[DIM];
    struct crowd *c;
    int water = 0;

    (void)state;
    empty_tank();
    for (int d = 0; d < DIM; d++)
        scales.period[d] = scales.high[d];
    srand(2);
    for (int i = 0; i < (DIM == 2 ? 450 : 3000); i++)
        add(KIND_FLUID, 2.0 * rand() / RAND_MAX, 0.5 * rand() / RAND_MAX, 1.0 * rand() / RAND_MAX);
    for (int i = 0; i < all.n; i++) {
        p[i] = rand();
        u[i][0] = rand();
        at[i % DIM] = 0.01;
    }
    first = pairing_now(1);
    c = crowd_now();
    pressure = probe_pressure(c, p, at);
    probe_velocity(c, at, seen);
    for (int i = 0; i < all.n; i++) {
        int near = -1;
        for (int j = 0; j < all.n; j++) {
            double r2 = 0;
            for (int d = 0; d < DIM; d++)
                r2 += pow(remainder(x[KIND_FLUID][i][d] - x[KIND_FLUID][j][d],
                                    scales.period[d]), 2);
            near += r2 < scales.support * scales.support;
        }
        assert_int_equal(crowd_is_water(c, i), 2 * near >= crowd_full(&scales));
        water += crowd_is_water(c, i);
    }
    assert_true(water > 20 && water < all.n - 20);
    crowd_free(&c);
    for (int i = 0; i < all.n; i++)
        for (int d = 0; d < DIM; d++)
            x[KIND_FLUID][i][d] += scales.period[d] * (0.4 + i % 5 - 2);
    for (int d = 0; d < DIM; d++)
        at[d] += scales.period[d] * (0.4 - d);
    found = pairing_now(1);
    c = crowd_now();
    assert_near(found.share, first.share);
    assert_near(found.mean, first.mean);
    assert_near(found.least, first.least);
    assert_near(probe_pressure(c, p, at) / pressure, 1);
    probe_velocity(c, at, now);
    assert_near(now[0] / seen[0], 1);
    crowd_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_full_lattice),
        cmocka_unit_test(test_column),
        cmocka_unit_test(test_spray_does_not_count),
        cmocka_unit_test(test_film_on_the_wall_does_not_count),
        cmocka_unit_test(test_thin_toe_counts),
        cmocka_unit_test(test_who_left_does_not_count),
        cmocka_unit_test(test_no_water),
        cmocka_unit_test(test_large_domain),
        cmocka_unit_test(test_cells_miss_no_particle),
        cmocka_unit_test(test_probe_on_a_linear_field),
        cmocka_unit_test(test_probe_weighs),
        cmocka_unit_test(test_a_drop_is_no_impact),
        cmocka_unit_test(test_probe_at_a_wall_and_in_the_air),
        cmocka_unit_test(test_probe_of_height),
        cmocka_unit_test(test_a_lattice_has_no_pairs),
        cmocka_unit_test(test_pairs_are_pairs),
        cmocka_unit_test(test_pairs_are_counted),
        cmocka_unit_test(test_loners_have_no_neighbour),
        cmocka_unit_test(test_nearest_of_all),
        cmocka_unit_test(test_where_directions_repeat),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
