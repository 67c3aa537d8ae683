/* polytope.c -- convex polytopes against closed forms, and what defines them. */
#include "base/status.h"
#include "shapes/layers-polytope.h"
#include "shapes/polygon-parts.h"
#include "shapes/shape-polygon.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>

#define check(good, ...)           \
    do {                           \
        if (!(good))               \
            fail_msg(__VA_ARGS__); \
    } while (0)

enum { MANY = 60 };

static void near(double found, double expected, double tolerance, const char *what)
{
    check(fabs(found - expected) <= tolerance, "%s: found %.15g, expected %.15g within %g", what,
          found, expected, tolerance);
}

static double chance(unsigned *seed) /* -1 to 1 */
{
    *seed = *seed * 1664525u + 1013904223u;
    return *seed / 2147483648.0 - 1;
}

static struct polytope hull(const double (*x)[DIM], int n)
{
    struct polytope p;

    assert_int_equal(polytope_hull(x, n, &p), STATUS_DONE);
    return p;
}

/* A box of these sides about `at`, with a point inside and one on a face that are no corners. */
static struct polytope box(const double *side, const double *at)
{
    double x[(1 << DIM) + 2][DIM];

    for (int i = 0; i < 1 << DIM; i++)
        for (int d = 0; d < DIM; d++)
            x[i][d] = at[d] + (i >> d & 1 ? 0.5 : -0.5) * side[d];
    for (int d = 0; d < DIM; d++) {
        x[1 << DIM][d] = at[d] + 0.1 * side[d];
        x[(1 << DIM) + 1][d] = at[d] + (d == 0 ? 0.5 : 0.2) * side[d];
    }
    return hull((const double (*)[DIM])x, (1 << DIM) + 2);
}

/* Points on a ball, so that all are corners. */
static struct polytope pebble(unsigned seed)
{
    double x[MANY][DIM];

    for (int i = 0; i < MANY; i++) {
        double length = 0;
        for (int d = 0; d < DIM; d++) {
            x[i][d] = chance(&seed);
            length = hypot(length, x[i][d]);
        }
        for (int d = 0; d < DIM; d++)
            x[i][d] /= length;
    }
    return hull((const double (*)[DIM])x, MANY);
}

static const double side[3] = { 0.3, 0.2, 0.5 }, place[3] = { 100, -7, 3 };

static void a_box_has_its_numbers(void **state)
{
    struct polytope p = box(side, place);
    struct polytope_moments m;
    double volume = 1, surface = 0, deepest;

    (void)state;
    for (int d = 0; d < DIM; d++)
        volume *= side[d];
    for (int d = 0; d < DIM; d++)
        surface += 2 * volume / side[d];
    polytope_moments(&p, &m);
    assert_int_equal(p.corners, 1 << DIM);
    assert_int_equal(p.faces, 2 * DIM);
    assert_int_equal(p.edges, DIM == 2 ? 0 : 12);
    near(m.volume, volume, 1e-12 * volume, "volume");
    near(polytope_surface(&p), surface, 1e-12 * surface, "surface");
    assert_int_equal(polytope_deepest(&p, &deepest), STATUS_DONE);
    near(deepest, 0.1, 2e-4, "deepest place");
    for (int d = 0; d < DIM; d++) {
        near(m.centre[d], place[d], 1e-11, "centre");
        for (int k = 0; k < DIM; k++)
            near(m.second[d][k], d == k ? volume * side[d] * side[d] / 12 : 0, 1e-12 * volume,
                 "second moment");
    }
    polytope_free(&p);
}

/* With a right angle at the origin and legs 3, 4 (, 12). */
static void a_corner_has_its_inscribed_ball(void **state)
{
    const double leg[3] = { 3, 4, 12 };
    double x[DIM + 1][DIM] = { { 0 } }, deepest, surface = 0, volume = 1;
    struct polytope_moments m;

    (void)state;
    for (int d = 0; d < DIM; d++) {
        x[d + 1][d] = leg[d];
        volume *= leg[d] / (d + 1);
    }
    struct polytope p = hull((const double (*)[DIM])x, DIM + 1);
    polytope_moments(&p, &m);
    surface = polytope_surface(&p);
    near(m.volume, volume, 1e-12 * volume, "volume");
    for (int d = 0; d < DIM; d++)
        near(m.centre[d], leg[d] / (DIM + 1), 1e-12, "centre");
    near(m.second[0][1], -12.0 * volume / ((DIM + 1) * (DIM + 1) * (DIM + 2)), 1e-9, "product");
    assert_int_equal(polytope_deepest(&p, &deepest), STATUS_DONE);
    near(deepest, DIM * volume / surface, 1e-3 * deepest, "radius of the inscribed ball");
    polytope_free(&p);
}

static void points_in_a_plane_have_none(void **state)
{
    double x[6][DIM] = { { 0 } };

    (void)state;
    for (int i = 0; i < 6; i++) {
        x[i][0] = cos(i);
        x[i][DIM - 1] = DIM == 2 ? 2 * cos(i) + 1 : sin(i) - cos(i);
        if (DIM == 3)
            x[i][1] = sin(i);
    }
    struct polytope p = hull((const double (*)[DIM])x, 6);
    assert_int_equal(p.corners, 0);
    polytope_free(&p);
}

/* No corner lies further along x - nearest: that is what the nearest point is. */
static void nearest_is_nearest(void **state)
{
    unsigned seed = 5;
    struct polytope p = pebble(1);

    (void)state;
    for (int i = 0; i < 400; i++) {
        double x[DIM], to[DIM], away = 0;
        for (int d = 0; d < DIM; d++)
            x[d] = 1.6 * chance(&seed);
        polytope_nearest(&p, x, to);
        near(fmin(polytope_depth(&p, to), 0), 0, 1e-12, "it is in");
        for (int d = 0; d < DIM; d++)
            away = fmax(away, fabs(x[d] - to[d]));
        check((away == 0) == (polytope_depth(&p, x) >= 0), "it moves what is outside");
        for (int k = 0; k < p.corners; k++) {
            double along = 0;
            for (int d = 0; d < DIM; d++)
                along += (x[d] - to[d]) * (p.x[k][d] - to[d]);
            check(along < 1e-12, "corner %d is nearer by %g", k, along);
        }
    }
    polytope_free(&p);
}

static void shrunk_is_below_all_faces(void **state)
{
    struct polytope p = pebble(2), q = { .x = NULL }, none = { .x = NULL };
    double deepest, least = HUGE_VAL;

    (void)state;
    assert_int_equal(polytope_deepest(&p, &deepest), STATUS_DONE);
    assert_int_equal(polytope_shrink(&p, 0.95 * deepest, &q), STATUS_DONE);
    check(q.corners > DIM, "%d corners are left", q.corners);
    for (int i = 0; i < q.corners; i++)
        least = fmin(least, polytope_depth(&p, q.x[i]));
    near(least, 0.95 * deepest, 1e-9, "depth of corners");
    assert_int_equal(polytope_shrink(&p, 1.01 * deepest, &none), STATUS_DONE);
    assert_int_equal(none.corners, 0);
    polytope_free(&p);
    polytope_free(&q);
    polytope_free(&none);
}

static void edges_join_corners_of_two_faces(void **state)
{
    struct polytope p = pebble(3);

    (void)state;
    if (DIM == 3)
        assert_int_equal(p.corners - p.edges + p.faces, 2); /* Euler */
    for (int i = 0; i < p.faces; i++)
        for (int k = 0; k < p.corners; k++) {
            double over = -p.face[i].offset;
            for (int d = 0; d < DIM; d++)
                over += p.face[i].normal[d] * p.x[k][d];
            check(over < 1e-12, "corner %d is %g above face %d", k, over, i);
        }
    polytope_free(&p);
}

static void told_elsewhere_it_is_the_same(void **state)
{
    const double c = cos(0.7), s = sin(0.7), at[3] = { 0.2, -0.1, 0.4 };
    double R[DIM][DIM] = { { 0 } };
    struct polytope p = pebble(4), q;
    struct polytope_moments m, n;
    unsigned seed = 9;

    (void)state;
    R[DIM - 1][DIM - 1] = 1;
    R[0][0] = R[1][1] = c;
    R[1][0] = s;
    R[0][1] = -s;
    assert_int_equal(polytope_copy(&p, &q), STATUS_DONE);
    polytope_tell(&q, at, (double (*const)[DIM])R);
    polytope_moments(&p, &m);
    polytope_moments(&q, &n);
    near(n.volume, m.volume, 1e-12, "volume");
    for (int i = 0; i < 50; i++) {
        double x[DIM], own[DIM] = { 0 };
        for (int d = 0; d < DIM; d++)
            x[d] = chance(&seed);
        for (int k = 0; k < DIM; k++)
            for (int d = 0; d < DIM; d++)
                own[k] += R[d][k] * (x[d] - at[d]);
        near(polytope_depth(&q, own), polytope_depth(&p, x), 1e-12, "depth");
    }
    polytope_free(&p);
    polytope_free(&q);
}

#if DIM == 2
static void parts_of(double (*x)[3], int n, int expected, const char *what)
{
    const struct param_points points = { n, x };
    struct polytope part[32];
    double sum = 0;
    int parts;

    assert_int_equal(polygon_parts(&points, part, &parts), STATUS_DONE);
    for (int i = 0; i < parts; i++) {
        struct polytope_moments m;
        polytope_moments(&part[i], &m);
        check(shape_polygon_contains(&points, m.centre), "%s: the middle of part %d is outside", what, i);
        sum += m.volume;
        polytope_free(&part[i]);
    }
    near(sum, shape_polygon_area(&points), 1e-12, what);
    check(parts == expected, "%s: %d parts, expected %d", what, parts, expected);
}

static void dented_polygons_have_convex_parts(void **state)
{
    double square[4][3] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
    double l[6][3] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
    double back[6][3], star[10][3];
    double straight[7][3] = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };

    (void)state;
    for (int i = 0; i < 6; i++)
        memcpy(back[i], l[5 - i], sizeof *back);
    for (int i = 0; i < 10; i++) {
        star[i][0] = (i % 2 ? 0.4 : 1) * cos(M_PI * i / 5);
        star[i][1] = (i % 2 ? 0.4 : 1) * sin(M_PI * i / 5);
    }
    parts_of(square, 4, 1, "a square");
    parts_of(l, 6, 2, "an L");
    parts_of(back, 6, 2, "an L, clockwise");
    parts_of(straight, 7, 2, "an L with a corner on a side");
    parts_of(star, 10, 5, "a star"); /* its middle is one with a tip or is a part */
}
#else
/* Layer by layer as many points as the lattice of the box has, and in any hull as dense. */
static void layers_fill_hulls(void **state)
{
    const double sides[3] = { 0.3, 0.2, 0.5 }, at[3] = { 0 }, dx = 0.02;
    struct polytope p = box(sides, at), q = pebble(6);
    struct points filled = { .n = 0 };
    struct polytope_moments m;

    (void)state;
    assert_int_equal(layers_polytope(&p, dx, 2, &filled), STATUS_DONE);
    assert_int_equal(filled.n, 15 * 10 * 25 - 11 * 6 * 21);
    points_free(&filled);
    assert_int_equal(layers_polytope(&q, 2.5 * dx, 1000, &filled), STATUS_DONE);
    polytope_moments(&q, &m);
    near(filled.n * pow(2.5 * dx, 3) / m.volume, 1, 0.05, "density of a pebble");
    for (long i = 0; i < filled.n; i++) {
        const double deep = polytope_depth(&q, filled.x[i]) / (2.5 * dx) - 0.5;
        check(fabs(deep - round(deep)) < 1e-6 || deep > 17, "a point %g spacings deep", deep);
    }
    points_free(&filled);
    polytope_free(&p);
    polytope_free(&q);
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_box_has_its_numbers),
        cmocka_unit_test(a_corner_has_its_inscribed_ball),
        cmocka_unit_test(points_in_a_plane_have_none),
        cmocka_unit_test(nearest_is_nearest),
        cmocka_unit_test(shrunk_is_below_all_faces),
        cmocka_unit_test(edges_join_corners_of_two_faces),
        cmocka_unit_test(told_elsewhere_it_is_the_same),
#if DIM == 2
        cmocka_unit_test(dented_polygons_have_convex_parts),
#else
        cmocka_unit_test(layers_fill_hulls),
#endif
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
