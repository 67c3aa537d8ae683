/* shape.c -- tests of the shapes of src/space: what they refuse, what is inside. */
#include "base/status.h"
#include "shapes/shape.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

#define MISSING { NAN, NAN, NAN }

/* As the reader of scenes leaves a shape of which only the type is given. */
static struct shape given(const char *type)
{
    return (struct shape){ .type = type, .from = MISSING, .to = MISSING, .centre = MISSING,
                           .axis = MISSING,
                           .radius = NAN, .height = NAN, .high = { 1, 1, 1 }, .thickness = 0.1 };
}

static void assert_refused(struct shape s, const char *text)
{
    status_clear();
    assert_int_equal(shape_check(&s, "wall.block", "a.scene:7"), STATUS_BAD_SCENE);
    if (!strstr(status_message(), text))
        fail_msg("\"%s\" does not say \"%s\"", status_message(), text);
    assert_non_null(strstr(status_message(), "a.scene:7: wall.block: "));
    status_clear();
    shape_free(&s);
}

static void assert_accepted(struct shape *s)
{
    status_clear();
    if (shape_check(s, "wall.block", "a.scene:7"))
        fail_msg("%s", status_message());
}

static struct shape box(const double *from, const double *to)
{
    struct shape s = given("box");

    memcpy(s.from, from, DIM * sizeof *from);
    memcpy(s.to, to, DIM * sizeof *to);
    assert_accepted(&s);
    return s;
}

static struct shape ball(double x, double y, double z, double radius)
{
    struct shape s = given(DIM == 2 ? "disc" : "sphere");
    const double centre[3] = { x, y, z };

    memcpy(s.centre, centre, DIM * sizeof *centre);
    s.radius = radius;
    return s;
}

/* Points of the shape among n^DIM at the centres of cells of [0,1]^DIM. */
static long inside(const struct shape *s, int n)
{
    long count = 0;

    for (int k = 0; k < (DIM == 2 ? 1 : n); k++)
        for (int j = 0; j < n; j++)
            for (int i = 0; i < n; i++) {
                const double x[3] = { (i + 0.5) / n, (j + 0.5) / n, (k + 0.5) / n };

                count += shape_contains(s, x);
            }
    return count;
}

static void sides_have_the_bits_of_their_names(void **state)
{
    const char *const names[3][2] = { { "left", "right" },
                                      { DIM == 2 ? "bottom" : "front", DIM == 2 ? "top" : "back" },
                                      { "bottom", "top" } };
    unsigned all = 0;

    (void)state;
    for (int axis = 0; axis < DIM; axis++)
        for (int high = 0; high < 2; high++) {
            const unsigned bit = shape_side(axis, high);

            assert_string_equal(shape_sides[__builtin_ctz(bit)], names[axis][high]);
            all |= bit;
        }
    assert_int_equal(all, (1 << 2 * DIM) - 1);
    assert_null(shape_sides[2 * DIM]);
}

static void parameters_describe_themselves(void **state)
{
    (void)state;
    assert_string_equal(shape_params[0].key, "type");
    assert_ptr_equal(shape_params[0].words, shape_types);
    for (const struct param *row = shape_params + 1; row->key; row++) {
        const bool place = !strcmp(row->unit, "m") || !strcmp(row->key, "axis");

        assert_true(strlen(row->about) > 10);
        assert_true(place ? isnan(row->fallback) : row->fallback == 0);
        assert_true(row->min < row->max || row->words);
        assert_true(place || !strcmp(row->key, "angle") || !strcmp(row->key, "fill"));
    }
}

static void missing_keys_are_named(void **state)
{
    struct shape s = given(DIM == 2 ? "disc" : "sphere");

    (void)state;
    assert_refused(s, DIM == 2 ? "a disc needs centre and radius"
                               : "a sphere needs centre and radius");
    s.radius = 1;
    assert_refused(s, "needs centre and radius");
    assert_refused(given("box"), "a box needs from and to");
    s = given("box");
    s.from[0] = s.from[1] = s.from[2] = 0;
    assert_refused(s, "a box needs from and to");
    s = given("frame");
    s.thickness = 0;
    assert_refused(s, "it needs one layer or more");
}

static void senseless_values_are_refused(void **state)
{
    struct shape s = given("box");

    (void)state;
    for (int d = 0; d < 3; d++) {
        s.from[d] = 1;
        s.to[d] = 2;
    }
    s.to[1] = 1;
    assert_refused(s, "along y from is 1 m and to is 1 m");
    s.to[1] = INFINITY;
    assert_refused(s, "a box needs from and to");
    assert_refused(ball(0, 0, 0, 0), "needs one above 0");
    assert_refused(ball(0, 0, 0, -1), "needs one above 0");
    s = given("frame");
    s.open = (1 << 2 * DIM) - 1;
    assert_refused(s, "every side of this frame is open");
    s = given("frame");
    s.high[1] = 0;
    assert_refused(s, "from 0 m to 0 m along y");
}

static void unknown_types_are_refused(void **state)
{
    (void)state;
    assert_refused(given("cone"), "there is no type \"cone\"");
    assert_refused(given(NULL), "there is no type \"\"");
    assert_refused(given(DIM == 2 ? "sphere" : "disc"),
                   DIM == 2 ? "one of box, polygon, disc or frame" : "one of box, sphere, cylinder, hull or frame");
}

static void keys_of_other_types_are_refused(void **state)
{
    struct shape s = ball(0, 0, 0, 1);

    (void)state;
    s.to[0] = s.to[1] = s.to[2] = 1;
    assert_refused(s, "takes no to; leave it out");
    s = given("box");
    s.radius = 1;
    assert_refused(s, "a box takes no radius");
    s = given("frame");
    s.from[0] = s.from[1] = s.from[2] = 1;
    assert_refused(s, "a frame takes no from");
    s = given("box");
    s.points.n = 3;
    assert_refused(s, "a box takes no points");
    s = ball(0, 0, 0, 1);
    s.angle = -30;
    assert_refused(s, DIM == 2 ? "a disc takes no angle" : "a sphere takes no angle");
    s = given("box");
    s.fill = "layers";
    assert_refused(s, "a box takes no fill = \"layers\"");
    s = given("frame");
    s.fill = "layers";
    assert_refused(s, "a frame takes no fill = \"layers\"");
    s = ball(0, 0, 0, 1);
    s.fill = "layers";
    assert_accepted(&s);
}

static void boxes_share_no_point_of_their_border(void **state)
{
    const double from[3] = { 0, 0, 0 }, to[3] = { 0.5, 1, 1 }, from2[3] = { 0.5, 0, 0 },
                 to2[3] = { 1, 1, 1 };
    const struct shape a = box(from, to), b = box(from2, to2);

    (void)state;
    for (int i = 0; i <= 4; i++)
        for (int j = 0; j <= 4; j++) {
            const double x[3] = { 0.25 * i, 0.25 * j, 0.5 };

            assert_int_equal(shape_contains(&a, x) + shape_contains(&b, x), i < 4 && j < 4);
        }
}

/* A quarter turn exchanges the sides of a box about its centre (0.5, 0.4, ..). */
static void a_quarter_turn_exchanges_the_sides(void **state)
{
    const double from[3] = { 0.125, 0.3, 0.25 }, to[3] = { 0.875, 0.5, 0.75 };
    const double low[3] = { 0.4, 0.025, 0.25 }, high[3] = { 0.6, 0.775, 0.75 };
    const double angles[] = { 90, -90, 270, -270, 180, 360 };

    (void)state;
    for (int i = 0; i < 6; i++) {
        const bool odd = i < 4;
        struct shape a = box(from, to);
        const struct shape b = box(odd ? low : from, odd ? high : to);
        double l[3], h[3];

        a.angle = angles[i];
        for (double x = 0.01; x < 1; x += 0.0237)
            for (double y = 0.01; y < 1; y += 0.0237)
                assert_int_equal(shape_contains(&a, (double[3]){ x, y, 0.3 }),
                                 shape_contains(&b, (double[3]){ x, y, 0.3 }));
        shape_bounds(&a, l, h);
        for (int d = 0; d < DIM; d++)
            assert_true(fabs(l[d] - b.from[d]) < 1e-15 && fabs(h[d] - b.to[d]) < 1e-15);
    }
}

/* Anticlockwise: the middle of the right side goes up. */
static void a_turned_box_stands_where_it_should(void **state)
{
    const double from[3] = { 0.2, 0.4, 0.1 }, to[3] = { 0.8, 0.6, 0.9 };
    const double c = cos(M_PI / 6), s = sin(M_PI / 6);
    struct shape a = box(from, to);
    double low[3], high[3];

    (void)state;
    a.angle = 30;
    for (int end = -1; end <= 1; end += 2)
        for (int side = -1; side <= 1; side += 2)
            for (int in = 0; in < 2; in++) {
                const double u = end * (0.301 - 0.002 * in), v = side * (0.101 - 0.002 * in);
                const double x[3] = { 0.5 + c * u - s * v, 0.5 + s * u + c * v, 0.5 };

                assert_int_equal(shape_contains(&a, x), in);
            }
    assert_int_equal(shape_contains(&a, (double[3]){ 0.5, 0.5, 0.95 }), DIM == 2);
    shape_bounds(&a, low, high);
    assert_true(fabs(high[0] - (0.5 + 0.3 * c + 0.1 * s)) < 1e-15);
    assert_true(fabs(low[1] - (0.5 - 0.3 * s - 0.1 * c)) < 1e-15);
    assert_true(fabs(inside(&a, DIM == 2 ? 1000 : 100) / pow(DIM == 2 ? 1000 : 100, DIM)
                     / (DIM == 2 ? 0.12 : 0.096) - 1) < 5e-3);
}

#if DIM == 3
/* A turn by 120 degrees about (1,1,1) takes x to y, y to z, z to x. */
static void a_turn_about_the_diagonal_exchanges_the_axes(void **state)
{
    const double from[3] = { 0.2, 0.4, 0.45 }, to[3] = { 0.8, 0.6, 0.55 };
    const double low[3] = { 0.45, 0.2, 0.4 }, high[3] = { 0.55, 0.8, 0.6 };
    struct shape a = box(from, to);
    const struct shape b = box(low, high);
    double l[3], h[3];

    (void)state;
    a.angle = 120;
    for (int d = 0; d < 3; d++)
        a.axis[d] = 7;
    assert_accepted(&a);
    for (double x = 0.01; x < 1; x += 0.0437)
        for (double y = 0.01; y < 1; y += 0.0437)
            for (double z = 0.01; z < 1; z += 0.0437)
                assert_int_equal(shape_contains(&a, (double[3]){ x, y, z }),
                                 shape_contains(&b, (double[3]){ x, y, z }));
    shape_bounds(&a, l, h);
    for (int d = 0; d < 3; d++)
        assert_true(fabs(l[d] - b.from[d]) < 1e-14 && fabs(h[d] - b.to[d]) < 1e-14);
}

/* A box on its side, turned about x by 30 degrees: y goes towards z. */
static void a_box_turns_about_any_axis(void **state)
{
    struct shape a = box((double[3]){ 0.1, 0.2, 0.4 }, (double[3]){ 0.9, 0.8, 0.6 });
    const double c = cos(M_PI / 6), s = sin(M_PI / 6);

    (void)state;
    a.angle = 30;
    a.axis[0] = 2;
    a.axis[1] = a.axis[2] = 0;
    for (int in = 0; in < 2; in++) {
        const double v = 0.301 - 0.002 * in;
        assert_int_equal(shape_contains(&a, (double[3]){ 0.5, 0.5 + c * v, 0.5 + s * v }), in);
        assert_int_equal(shape_contains(&a, (double[3]){ 0.5, 0.5 - c * v, 0.5 - s * v }), in);
    }
    assert_false(shape_contains(&a, (double[3]){ 0.5, 0.5 + c * 0.299, 0.5 - s * 0.299 }));
    assert_true(fabs(inside(&a, 100) / 1e6 / 0.096 - 1) < 5e-3);
}

static struct shape cylinder(double a, double b, double c)
{
    struct shape s = given("cylinder");

    for (int d = 0; d < 3; d++)
        s.centre[d] = 0.5;
    s.axis[0] = a;
    s.axis[1] = b;
    s.axis[2] = c;
    s.radius = 0.2;
    s.height = 0.5;
    assert_accepted(&s);
    return s;
}

/* By counting, by how far it reaches, and by both ends. */
static void a_cylinder_has_its_volume_and_direction(void **state)
{
    const double axis[3][3] = { { 0, 0, 3 }, { 1, 0, 0 }, { 1, -2, 0.5 } };

    (void)state;
    for (int k = 0; k < 3; k++) {
        const struct shape s = cylinder(axis[k][0], axis[k][1], axis[k][2]);
        const double n = sqrt(axis[k][0] * axis[k][0] + axis[k][1] * axis[k][1]
                              + axis[k][2] * axis[k][2]);
        double low[3], high[3];

        /* a circle of 20 cells' radius among cells holds 0.6 % too many */
        assert_true(fabs(inside(&s, 100) / 1e6 / (M_PI * 0.04 * 0.5) - 1) < 7e-3);
        shape_bounds(&s, low, high);
        for (int d = 0; d < 3; d++) {
            const double e = axis[k][d] / n, reach = 0.25 * fabs(e) + 0.2 * sqrt(1 - e * e);
            assert_true(fabs(low[d] - (0.5 - reach)) < 1e-12);
            assert_true(fabs(high[d] - (0.5 + reach)) < 1e-12);
        }
        for (int end = -1; end <= 1; end += 2)
            for (int in = 0; in < 2; in++) {
                double x[3];
                for (int d = 0; d < 3; d++)
                    x[d] = 0.5 + end * (0.2501 - 0.0002 * in) * axis[k][d] / n;
                assert_int_equal(shape_contains(&s, x), in);
            }
    }
}

static void senseless_cylinders_are_refused(void **state)
{
    struct shape s = cylinder(0, 0, 1);

    (void)state;
    s.height = NAN;
    assert_refused(s, "a cylinder needs centre, radius and height");
    s.height = 0;
    assert_refused(s, "height is 0 m, but a cylinder needs one above 0");
    s.height = 1;
    s.radius = 0;
    assert_refused(s, "radius is 0 m, but a cylinder needs one above 0");
    s.radius = 1;
    s.axis[1] = INFINITY;
    assert_refused(s, "which is no direction");
    s = given("box");
    s.height = 1;
    assert_refused(s, "a box takes no height");
    s = ball(0, 0, 0, 1);
    s.axis[0] = 1;
    s.axis[1] = s.axis[2] = 0;
    assert_refused(s, "a sphere takes no axis");
}
#endif

static void a_ball_holds_its_volume(void **state)
{
    struct shape s = ball(0.5, 0.45, 0.55, 0.4);
    const int n = DIM == 2 ? 1000 : 100;
    const double volume = DIM == 2 ? M_PI * 0.16 : 4 * M_PI / 3 * 0.064;
    double low[3], high[3];

    (void)state;
    assert_accepted(&s);
    assert_true(fabs(inside(&s, n) / pow(n, DIM) / volume - 1) < (DIM == 2 ? 1e-3 : 5e-3));
    shape_bounds(&s, low, high);
    for (int d = 0; d < DIM; d++)
        assert_true(low[d] == s.centre[d] - 0.4 && high[d] == s.centre[d] + 0.4);
}

#if DIM == 3

static struct shape hull(double (*x)[3], int n)
{
    struct shape s = given("hull");

    s.points = (struct param_points){ .x = x, .n = n };
    return s;
}

/* Half a cube, cut from edge to edge; places on the cut are in it or not. */
static void a_hull_holds_its_volume(void **state)
{
    double x[][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 1 }, { 0, 1, 0 }, { 1, 1, 0 }, { 1, 1, 1 } };
    struct shape s = hull(x, 6);
    double low[3], high[3];
    const double deep[3] = { 0.75, 0.5, 0.125 }, out[3] = { 0.25, 0.5, 0.5 };

    (void)state;
    assert_accepted(&s);
    assert_true(fabs(inside(&s, 50) / pow(50, 3) - 0.5) < 0.011);
    shape_bounds(&s, low, high);
    for (int d = 0; d < 3; d++)
        assert_true(low[d] == 0 && high[d] == 1);
    assert_true(fabs(shape_depth(&s, deep) - 0.125) < 1e-12);
    assert_true(shape_depth(&s, out) == 0);
    shape_free(&s);
}

/* Two halves of a cube, whose common face has places of the middle row. */
static void hulls_share_no_point_of_their_border(void **state)
{
    double low[8][3], high[8][3];
    long all = 0;

    (void)state;
    for (int i = 0; i < 8; i++)
        for (int d = 0; d < 3; d++) {
            const double x = i >> d & 1;
            low[i][d] = d == 2 ? 0.5 * x : x;
            high[i][d] = d == 2 ? 0.5 + 0.5 * x : x;
        }
    for (int k = 0; k < 2; k++) {
        struct shape s = hull(k ? high : low, 8);
        assert_accepted(&s);
        all += inside(&s, 11);
        shape_free(&s);
    }
    assert_int_equal(all, 11 * 11 * 11);
}

static void bad_hulls_are_refused(void **state)
{
    double flat[][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } };
    double odd[][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, INFINITY } };

    (void)state;
    assert_refused(hull(flat, 3), "a hull needs points, four or more; 3 given");
    assert_refused(hull(flat, 4), "its 4 points lie in one plane");
    assert_refused(hull(odd, 4), "point 4 of points is no place");
}

#endif

/* Domain 1/2 wide in the middle of the cube, shell of 1/8: cells of 1/16. */
static void a_frame_holds_the_shell_for_all_open_sides(void **state)
{
    (void)state;
    for (unsigned open = 0; open < (1u << 2 * DIM) - 1; open++) {
        struct shape s = given("frame");
        long outer = 1, inner = 1;

        s.thickness = 0.125;
        s.open = open;
        for (int d = 0; d < DIM; d++) {
            s.low[d] = 0.25;
            s.high[d] = 0.75;
            inner *= 8;
            outer *= 8 + 2 * !(open & shape_side(d, false)) + 2 * !(open & shape_side(d, true));
        }
        assert_accepted(&s);
        assert_int_equal(inside(&s, 16), outer - inner);
    }
}

/* With the top open the side walls end at the domain's top. */
static void an_open_side_takes_its_corners_with_it(void **state)
{
    struct shape s = given("frame");
    double x[3] = { -0.05, 0.5, 0.5 }, corner[3] = { -0.05, -0.05, -0.05 };

    (void)state;
    s.open = shape_side(DIM - 1, true);
    assert_accepted(&s);
    assert_true(shape_contains(&s, corner));
    x[DIM - 1] = 0.999;
    assert_true(shape_contains(&s, x));
    x[DIM - 1] = 1;
    assert_false(shape_contains(&s, x));
}

#if DIM == 2
static struct shape polygon(int n, double (*x)[3])
{
    struct shape s = given("polygon");

    s.points = (struct param_points){ n, x };
    return s;
}

static void bad_polygons_are_refused(void **state)
{
    double bow[][3] = { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 2 } };
    double flat[][3] = { { 0, 0 }, { 1, 1 }, { 2, 2 } };
    double closed[][3] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 0 } };
    double spike[][3] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 1, 0.5 }, { 0, 1 } };
    double touch[][3] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 0 }, { 0, 1 } };
    double blank[][3] = { { 0, 0 }, { 1, 0 }, { 1, NAN } };

    (void)state;
    assert_refused(given("polygon"), "a polygon needs points, three corners or more; 0 given");
    assert_refused(polygon(2, bow), "three corners or more; 2 given");
    assert_refused(polygon(4, bow), "the edge from corner 1 to 2 crosses or touches the edge from"
                                    " corner 3 to 4");
    assert_refused(polygon(3, flat), "enclose no area");
    assert_refused(polygon(4, closed), "corners 4 and 1 of points are both (0, 0)");
    assert_refused(polygon(5, spike), "touches");
    assert_refused(polygon(5, touch), "touches");
    assert_refused(polygon(3, blank), "corner 3 of points is not a number");
}

/* A dent makes it non-convex; the area is summed edge by edge. */
static void a_polygon_holds_its_area_either_way_round(void **state)
{
    double left[][3] = { { 0.1, 0.1 }, { 0.9, 0.1 }, { 0.9, 0.9 }, { 0.5, 0.3 }, { 0.1, 0.6 } };
    double right[5][3];
    double low[2], high[2], area = 0;

    (void)state;
    for (int i = 0; i < 5; i++) {
        memcpy(right[i], left[4 - i], sizeof *left);
        area += 0.5 * (left[i][0] * left[(i + 1) % 5][1] - left[(i + 1) % 5][0] * left[i][1]);
    }
    struct shape a = polygon(5, left), b = polygon(5, right);
    assert_accepted(&a);
    assert_accepted(&b);
    assert_true(fabs(inside(&a, 1000) * 1e-6 / area - 1) < 1e-3);
    assert_int_equal(inside(&a, 1000), inside(&b, 1000));
    shape_bounds(&a, low, high);
    assert_true(low[0] == 0.1 && low[1] == 0.1 && high[0] == 0.9 && high[1] == 0.9);
}

/* Two triangles make the unit square; the diagonal passes through lattice points. */
static void polygons_share_no_point_of_their_border(void **state)
{
    double lower[][3] = { { 0, 0 }, { 1, 0 }, { 1, 1 } };
    double upper[][3] = { { 1, 1 }, { 0, 1 }, { 0, 0 } };
    struct shape a = polygon(3, lower), b = polygon(3, upper);

    (void)state;
    assert_accepted(&a);
    assert_accepted(&b);
    for (int i = 0; i <= 30; i++)
        for (int j = 0; j <= 30; j++) {
            const double x[2] = { i / 30.0, j / 30.0 };

            assert_int_equal(shape_contains(&a, x) + shape_contains(&b, x), i < 30 && j < 30);
        }
}
#endif

/* Directions spread over the circle, or over the ball by a spiral. */
static void direction(int i, int n, double *e)
{
    const double z = DIM == 2 ? 0 : 1 - (2 * i + 1.0) / n, round = sqrt(1 - z * z);
    const double turn = DIM == 2 ? 2 * M_PI * i / n : 2.399963229728653 * i;

    e[0] = round * cos(turn);
    e[1] = round * sin(turn);
    e[2] = z;
}

/* The largest ball around x that stays inside has the radius that the shape says: nothing
 * of a ball a little smaller is outside, and something of one a little larger is. */
static void check_depth(const struct shape *s, const double *x)
{
    const double depth = shape_depth(s, x);
    int out[2] = { 0, 0 };

    assert_int_equal(depth > 0, shape_contains(s, x));
    for (int i = 0; i < 4000 && depth > 0; i++)
        for (int k = 0; k < 2; k++) {
            double e[3], to[3];
            direction(i, 4000, e);
            for (int d = 0; d < 3; d++)
                to[d] = x[d] + (k ? 1.01 : 0.999999) * depth * e[d];
            out[k] += !shape_contains(s, to);
        }
    if (depth > 0 && (out[0] > 0 || out[1] == 0))
        fail_msg("%s: at (%g, %g, %g) depth %g, but %d and %d points are outside", s->type, x[0],
                 x[1], x[2], depth, out[0], out[1]);
}

static void depth_is_the_way_to_the_outline(void **state)
{
    struct shape all[5] = { box((double[3]){ 0.2, 0.1, 0.3 }, (double[3]){ 0.7, 0.9, 0.8 }),
                            ball(0.5, 0.4, 0.5, 0.4), given("frame"), given("frame") };
    int n = 4;

    (void)state;
    all[0].angle = 25;
    assert_accepted(&all[1]);
    for (int i = 2; i < 4; i++) {
        for (int d = 0; d < DIM; d++) {
            all[i].low[d] = 0.3;
            all[i].high[d] = 0.6;
        }
        all[i].thickness = 0.2;
        all[i].open = i == 3 ? shape_side(DIM - 1, true) : 0;
        assert_accepted(&all[i]);
    }
#if DIM == 2
    double corner[5][3] = { { 0.1, 0.1 }, { 0.9, 0.2 }, { 0.5, 0.4 }, { 0.8, 0.9 }, { 0.2, 0.7 } };
    struct shape polygon = given("polygon");
    polygon.points = (struct param_points){ 5, corner };
    assert_accepted(&polygon);
    all[n++] = polygon;
#else
    all[n++] = cylinder(1, -2, 0.5);
#endif
    for (int s = 0; s < n; s++)
        for (int i = 0; i < 200; i++) {
            const double x[3] = { fmod(0.5 + 0.7548776662 * i, 1), fmod(0.5 + 0.5698402910 * i, 1),
                                  fmod(0.5 + 0.8191725134 * i, 1) };
            check_depth(&all[s], x);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depth_is_the_way_to_the_outline),
#if DIM == 3
        cmocka_unit_test(a_turn_about_the_diagonal_exchanges_the_axes),
        cmocka_unit_test(a_box_turns_about_any_axis),
        cmocka_unit_test(a_cylinder_has_its_volume_and_direction),
        cmocka_unit_test(senseless_cylinders_are_refused),
#endif
        cmocka_unit_test(sides_have_the_bits_of_their_names),
        cmocka_unit_test(parameters_describe_themselves),
        cmocka_unit_test(missing_keys_are_named),
        cmocka_unit_test(senseless_values_are_refused),
        cmocka_unit_test(unknown_types_are_refused),
        cmocka_unit_test(keys_of_other_types_are_refused),
        cmocka_unit_test(boxes_share_no_point_of_their_border),
        cmocka_unit_test(a_quarter_turn_exchanges_the_sides),
        cmocka_unit_test(a_turned_box_stands_where_it_should),
        cmocka_unit_test(a_ball_holds_its_volume),
        cmocka_unit_test(a_frame_holds_the_shell_for_all_open_sides),
        cmocka_unit_test(an_open_side_takes_its_corners_with_it),
#if DIM == 2
        cmocka_unit_test(bad_polygons_are_refused),
        cmocka_unit_test(a_polygon_holds_its_area_either_way_round),
        cmocka_unit_test(polygons_share_no_point_of_their_border),
#else
        cmocka_unit_test(a_hull_holds_its_volume),
        cmocka_unit_test(hulls_share_no_point_of_their_border),
        cmocka_unit_test(bad_hulls_are_refused),
#endif
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
