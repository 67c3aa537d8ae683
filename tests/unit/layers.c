/* layers.c -- tests of layers that follow the outline of a wall: no gaps, no crowds. */
#include "base/status.h"
#include "shapes/shape-polygon.h"
#include "shapes/layers.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

/* Fails with a sentence when `good` is false. */
#define check(good, ...)           \
    do {                           \
        if (!(good))               \
            fail_msg(__VA_ARGS__); \
    } while (0)

static const double dx = 0.04;

static struct points filled(const struct shape *s)
{
    struct points p = { 0 };

    assert_int_equal(layers_fill(s, dx, &p), STATUS_DONE);
    return p;
}

static double distance(const double *a, const double *b)
{
    double r2 = 0;

    for (int d = 0; d < DIM; d++)
        r2 += (a[d] - b[d]) * (a[d] - b[d]);
    return sqrt(r2);
}

/* From x to the nearest point other than number i. */
static double nearest(const struct points *p, const double *x, int i)
{
    double least = HUGE_VAL;

    for (int j = 0; j < p->n; j++)
        if (j != i)
            least = fmin(least, distance(x, p->x[j]));
    return least;
}

/* From the nearest two points to each other. */
static double closest(const struct points *p)
{
    double least = HUGE_VAL;

    for (int i = 0; i < p->n; i++)
        least = fmin(least, nearest(p, p->x[i], i));
    return least;
}

static struct shape ball(double radius, double thickness)
{
    return (struct shape){ .kind = DIM == 2 ? SHAPE_DISC : SHAPE_SPHERE,
                           .centre = { 0.3, -0.2, 0.1 }, .radius = radius,
                           .thickness = thickness };
}

static void words_choose_the_filling(void **state)
{
    struct shape s = ball(1, 0);

    (void)state;
    assert_true(layers_wanted(&s));
    s.fill = "auto";
    assert_true(layers_wanted(&s));
    s.fill = "lattice";
    assert_false(layers_wanted(&s));
    s = (struct shape){ .kind = SHAPE_BOX };
    assert_false(layers_wanted(&s));
    s.kind = SHAPE_FRAME;
    assert_false(layers_wanted(&s));
}

static void steps_are_never_much_too_long(void **state)
{
    (void)state;
    for (double length = 1e-9; length < 30; length += 0.0137) {
        const long n = layers_steps(length * dx, dx);

        assert_true(n >= 1 && length / n <= 1.05 && (n == 1 || length / n > 0.52));
    }
    assert_int_equal(layers_steps(7 * dx, dx), 7);
    assert_int_equal(layers_steps(20.4 * dx, dx), 20);
}

/* Circles (spheres) of radius R - dx/2, R - 3/2 dx, ... with as many points as they are
 * long (large) in spacings. */
static void rings_have_their_number_of_points(void **state)
{
    const struct shape s = ball(10 * dx, 3 * dx);
    struct points p = filled(&s);
    int count[3] = { 0 };

    (void)state;
    for (int i = 0; i < p.n; i++) {
        const double depth = (s.radius - distance(p.x[i], s.centre)) / dx;

        assert_true(fabs(depth - floor(depth) - 0.5) < 1e-9 && depth > 0 && depth < 3);
        count[(int)depth]++;
    }
    for (int k = 0; k < 3; k++) {
        const double r = 9.5 - k, border = DIM == 2 ? 2 * M_PI * r : 4 * M_PI * r * r;

        check(fabs(count[k] / border - 1) < (DIM == 2 ? 0.5 / border : 0.02),
              "layer %d has %d points, its size is %g", k, count[k], border);
    }
    check(closest(&p) > (DIM == 2 ? 0.95 : 0.75) * dx, "two are %g dx apart", closest(&p) / dx);
    points_free(&p);
}

static void a_ball_is_covered_and_filled(void **state)
{
    const double volume = DIM == 2 ? M_PI : 4 * M_PI / 3;

    (void)state;
    for (double radius = 0.25; radius < 8; radius += 0.17) {
        const struct shape s = ball(radius * dx, 0);
        struct points p = filled(&s);
        unsigned seed = 1;

        for (int i = 0; i < 300; i++) { /* anywhere in it */
            double x[3], r = 2;

            while (r > 1) {
                r = 0;
                for (int d = 0; d < DIM; d++) {
                    seed = seed * 1664525u + 1013904223u;
                    x[d] = (seed >> 8) / 8388608.0 - 1;
                    r += x[d] * x[d];
                }
            }
            for (int d = 0; d < DIM; d++)
                x[d] = s.centre[d] + s.radius * x[d];
            r = nearest(&p, x, -1) / dx;
            check(r < (DIM == 2 ? 0.95 : 1.1), "radius %g dx: a hole of %g dx", radius, r);
        }
        check(p.n == 1 || closest(&p) > 0.55 * dx, "radius %g dx: two are %g dx apart", radius,
              closest(&p) / dx);
        check(radius < 4 || fabs(p.n / (volume * pow(radius, DIM)) - 1) < 0.1,
              "radius %g dx: %ld points", radius, p.n);
        check(fabs(p.n - layers_estimate(&s, dx)) <= 1 + 0.3 * p.n,
              "radius %g dx: estimate %g of %ld", radius, layers_estimate(&s, dx), p.n);
        points_free(&p);
    }
}

#if DIM == 2
struct outline {
    const char *name;
    int n;
    double x[12][3]; /* in spacings, anticlockwise */
    double corner;   /* how far a place near a corner may be from a point [dx] */
};

/* The triangle has a tip of 20 degrees; sides that are no whole number of spacings. */
static const struct outline outlines[] = {
    { "square", 4, { { 0, 0 }, { 10, 0 }, { 10, 10 }, { 0, 10 } }, 0.71 },
    { "slanted square", 4, { { 0, 0 }, { 9.3, 3.1 }, { 6.2, 12.4 }, { -3.1, 9.3 } }, 0.73 },
    { "triangle", 3, { { 0, 0 }, { 20, -3.5265396 }, { 20, 3.5265396 } }, 0.95 },
    { "L", 6, { { 0, 0 }, { 20, 0 }, { 20, 8 }, { 8, 8 }, { 8, 20 }, { 0, 20 } }, 0.71 },
    { "slanted L", 6, { { 0, 0 }, { 18, 6 }, { 16, 12 }, { 6, 8.6667 }, { 2, 20.6667 },
                        { -4, 18.6667 } }, 0.75 },
    { "star", 10, { { 0, 15 }, { -3.674, 5.057 }, { -14.266, 4.635 }, { -5.944, -1.931 },
                    { -8.817, -12.135 }, { 0, -6.25 }, { 8.817, -12.135 }, { 5.944, -1.931 },
                    { 14.266, 4.635 }, { 3.674, 5.057 } }, 0.8 },
    { "notch", 7, { { 0, 0 }, { 20, 0 }, { 20, 14 }, { 11.5, 14 }, { 10, 5 }, { 8.5, 14 },
                    { 0, 14 } }, 0.75 },
};
enum { TRIANGLE = 2, NOTCH = 6, OUTLINES = sizeof outlines / sizeof *outlines };

static struct shape polygon_of(const struct outline *o, bool clockwise, double (*x)[3])
{
    for (int i = 0; i < o->n; i++)
        for (int d = 0; d < 3; d++)
            x[i][d] = dx * o->x[clockwise ? (o->n - i) % o->n : i][d];
    return (struct shape){ .kind = SHAPE_POLYGON, .points = { o->n, x }, .thickness = 3 * dx };
}

/* Of places along edge i further than `off` dx from corners, the greatest distance to a
 * point [dx]. */
static double gap(const struct shape *s, const struct points *p, int i, double off)
{
    const double *a = s->points.x[i], *b = s->points.x[(i + 1) % s->points.n];
    double most = 0;

    for (int k = 0; k <= 1000; k++) {
        const double x[2] = { a[0] + 1e-3 * k * (b[0] - a[0]), a[1] + 1e-3 * k * (b[1] - a[1]) };

        if (fmin(distance(x, a), distance(x, b)) >= off * dx)
            most = fmax(most, nearest(p, x, -1));
    }
    return most / dx;
}

/* A row at 1/2 spacing with gaps of up to 1.05: every place is within 0.725 of it. */
static void an_outline_has_no_gaps(void **state)
{
    (void)state;
    for (int o = 0; o < OUTLINES; o++) {
        double x[12][3];
        const struct shape s = polygon_of(&outlines[o], false, x);
        struct points p = filled(&s);

        for (int i = 0; i < s.points.n; i++) {
            const double off = o == TRIANGLE ? 5 : 1; /* a tip is that long */

            check(gap(&s, &p, i, off) < hypot(0.5, 0.525) + 1e-9, "%s: %g dx from edge %d",
                  outlines[o].name, gap(&s, &p, i, off), i);
            check(gap(&s, &p, i, 0) < outlines[o].corner, "%s: %g dx from a corner of edge %d",
                  outlines[o].name, gap(&s, &p, i, 0), i);
        }
        points_free(&p);
    }
}

static void points_are_apart_inside_and_deep_enough(void **state)
{
    (void)state;
    for (int o = 0; o < OUTLINES; o++) {
        double x[12][3];
        const struct shape s = polygon_of(&outlines[o], false, x);
        struct points p = filled(&s);
        int shallow = 0, stray = 0;

        check(closest(&p) > 0.6 * dx, "%s: two are %g dx apart", outlines[o].name,
              closest(&p) / dx);
        for (int i = 0; i < p.n; i++) {
            check(shape_polygon_contains(&s.points, p.x[i]), "%s: point %d is outside",
                  outlines[o].name, i);
            const double deep = shape_polygon_distance(&s.points, p.x[i]) / dx;
            shallow += deep < 0.499;
            stray += fabs(deep - floor(deep) - 0.5) > 0.3; /* in no row */
        }
        check(shallow <= 5, "%s: %d points near the outline", outlines[o].name, shallow); /* tips */
        check(o != NOTCH || stray == 0, "%s: %d points between rows", outlines[o].name, stray);
        points_free(&p);
    }
}

/* Sides of whole spacings: three rows of the lattice. */
static void straight_corners_make_the_lattice(void **state)
{
    const int count[] = { 84, 204 };

    (void)state;
    for (int k = 0; k < 2; k++) {
        double x[12][3];
        const struct shape s = polygon_of(&outlines[3 * k], false, x);
        struct points p = filled(&s);

        check(p.n == count[k], "%s: %ld points", outlines[3 * k].name, p.n);
        for (int i = 0; i < p.n; i++)
            for (int d = 0; d < 2; d++) {
                const double site = p.x[i][d] / dx - 0.5;

                check(fabs(site - rint(site)) < 1e-9, "%s: a point at %g", outlines[3 * k].name,
                      site);
            }
        points_free(&p);
    }
}

static void corners_may_go_round_either_way(void **state)
{
    (void)state;
    for (int o = 0; o < OUTLINES; o++) {
        double x[12][3], y[12][3];
        const struct shape s = polygon_of(&outlines[o], false, x);
        const struct shape r = polygon_of(&outlines[o], true, y);
        struct points p = filled(&s), q = filled(&r);

        assert_int_equal(p.n, q.n);
        for (int i = 0; i < p.n; i++)
            check(nearest(&q, p.x[i], -1) < 1e-12, "%s: (%g, %g) is on one side only",
                  outlines[o].name, p.x[i][0], p.x[i][1]);
        points_free(&p);
        points_free(&q);
    }
}

/* A circle given by many corners is a ring, whatever the length of its edges. */
static void a_round_polygon_is_divided_evenly(void **state)
{
    const struct shape disc = ball(10 * dx, 3 * dx);
    struct points ring = filled(&disc);

    (void)state;
    for (int n = 12; n < 200; n += 11) {
        double x[200][3] = { { 0 } };
        struct shape s = { .kind = SHAPE_POLYGON, .points = { n, x }, .thickness = 3 * dx };

        for (int i = 0; i < n; i++) {
            x[i][0] = 10 * dx * cos(2 * M_PI * i / n);
            x[i][1] = 10 * dx * sin(2 * M_PI * i / n);
        }
        struct points p = filled(&s);
        check(closest(&p) > 0.9 * dx, "%d corners: two are %g dx apart", n, closest(&p) / dx);
        check(labs(p.n - ring.n) <= 6, "%d corners: %ld points, a disc has %ld", n, p.n, ring.n);
        for (int i = 0; i < n; i++)
            check(gap(&s, &p, i, 0) < 0.83, "%d corners: %g dx from edge %d", n,
                  gap(&s, &p, i, 0), i);
        points_free(&p);
    }
    points_free(&ring);
}

/* Plates of any thickness from 0.6 spacings on: no hole, no crowd. */
static void a_thin_plate_is_filled(void **state)
{
    (void)state;
    for (double thick = 0.6; thick < 8; thick += 0.07) {
        const double a = 0.9701 * dx, b = 0.2425 * dx;
        double x[][3] = { { 0, 0 }, { 20 * a, 20 * b }, { 20 * a - thick * b, 20 * b + thick * a },
                          { -thick * b, thick * a } };
        const struct shape s = { .kind = SHAPE_POLYGON, .points = { 4, x } };
        struct points p = filled(&s);
        double hole = 0;

        for (double u = 0.5; u < 20; u += 0.31)
            for (double v = 0; v <= thick; v += 0.1) {
                const double at[2] = { u * a - v * b, u * b + v * a };
                hole = fmax(hole, nearest(&p, at, -1) / dx);
            }
        check(hole < 1.05, "%g dx thick: a hole of %g dx", thick, hole);
        check(thick < 1.7 || gap(&s, &p, 0, 1) < 0.726, "%g dx thick: %g dx from its face", thick,
              gap(&s, &p, 0, 1)); /* both faces have a row of their own */
        check(closest(&p) > 0.5 * dx, "%g dx thick: two are %g dx apart", thick,
              closest(&p) / dx);
        check(p.n <= layers_estimate(&s, dx) + 2, "%g dx thick: %ld points, estimate %g", thick,
              p.n, layers_estimate(&s, dx));
        points_free(&p);
    }
}

static void bare_places_are_found(void **state)
{
    double x[][3] = { { 0, 0 }, { 10 * dx, 0 }, { 10 * dx, 4 * dx }, { 5 * dx, 4 * dx },
                      { 5 * dx, 9 * dx }, { 4.6 * dx, 9 * dx }, { 4.6 * dx, 4 * dx },
                      { 0, 4 * dx } };
    const struct shape s = { .kind = SHAPE_POLYGON, .points = { 8, x } };
    struct points p = filled(&s);
    double at[2];
    bool bare;

    (void)state;
    assert_int_equal(layers_bare(&s, dx, &p, at, &bare), STATUS_DONE);
    assert_true(bare && at[1] > 4 * dx && at[0] > 4.5 * dx && at[0] < 5.1 * dx);
    points_free(&p);
    x[5][0] = x[6][0] = 4.2 * dx;
    p = filled(&s);
    assert_int_equal(layers_bare(&s, dx, &p, at, &bare), STATUS_DONE);
    assert_false(bare);
    points_free(&p);
}
#endif

#if DIM == 3
/* All points of three layers are inside, none deeper than 2.5 spacings, none nearer to another
 * than 0.7, and nothing of the surface is further than 1.1 from a point. */
static void a_cylinder_is_covered_by_its_layers(void **state)
{
    struct shape s = { .type = "cylinder", .kind = SHAPE_CYLINDER, .radius = 5.3 * dx,
                       .height = 12.7 * dx, .centre = { 0.1, -0.2, 0.3 }, .axis = { 1, 2, -1 },
                       .thickness = 3 * dx };
    const double k[3] = { 1 / sqrt(6), 2 / sqrt(6), -1 / sqrt(6) }; /* e and f are across it */
    const double e[3] = { 1 / sqrt(2), 0, 1 / sqrt(2) };
    const double f[3] = { 1 / sqrt(3), -1 / sqrt(3), -1 / sqrt(3) };
    struct points p = filled(&s);

    (void)state;
    for (long i = 0; i < p.n; i++) {
        const double deep = shape_depth(&s, p.x[i]) / dx;
        check(deep > 0.49 && deep < 2.51, "point %ld is %g dx deep", i, deep);
    }
    check(closest(&p) > 0.7 * dx, "two points are only %g dx apart", closest(&p) / dx);
    for (int i = 0; i < 2000; i++) {
        const double turn = 2.399963229728653 * i, up = s.height * (i / 1999.0 - 0.5);
        double x[3];
        for (int d = 0; d < 3; d++)
            x[d] = s.centre[d] + s.radius * (cos(turn) * e[d] + sin(turn) * f[d]) + up * k[d];
        check(nearest(&p, x, -1) < 1.1 * dx, "at %d the nearest point is %g dx away", i,
              nearest(&p, x, -1) / dx);
    }
    points_free(&p);
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(words_choose_the_filling),
        cmocka_unit_test(steps_are_never_much_too_long),
        cmocka_unit_test(rings_have_their_number_of_points),
        cmocka_unit_test(a_ball_is_covered_and_filled),
#if DIM == 2
        cmocka_unit_test(an_outline_has_no_gaps),
        cmocka_unit_test(points_are_apart_inside_and_deep_enough),
        cmocka_unit_test(straight_corners_make_the_lattice),
        cmocka_unit_test(corners_may_go_round_either_way),
        cmocka_unit_test(a_round_polygon_is_divided_evenly),
        cmocka_unit_test(a_thin_plate_is_filled),
        cmocka_unit_test(bare_places_are_found),
#else
        cmocka_unit_test(a_cylinder_is_covered_by_its_layers),
#endif
    };

    return cmocka_run_group_tests_name("layers", tests, NULL, NULL);
}
