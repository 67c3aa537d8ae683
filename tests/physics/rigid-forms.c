/* rigid-forms.c -- rigid bodies that are polygons, cylinders and hulls: as boxes where they are
 * boxes, their motion against closed forms, and what they stand and roll on. */
#include "../unit/tank-run.h"
#include "tank.h"

#include "base/status.h"
#include "bodies/rigid-figure.h"
#include "bodies/solid.h"
#include "bodies/turning.h"
#include "eval/observe.h"
#include "plan/inside.h"
#include "shapes/surface.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { UP = DIM - 1 };

#if DIM == 2
#define PLACE "dimension = 2; until = 100.0; domain = { from = [-5.0, 0.0]; to = [5.0, 5.0]; };"
#define HEAVY "gravity = [0.0, -9.81];"
#else
#define PLACE "dimension = 3; until = 100.0;" \
    "domain = { from = [-5.0, -5.0, 0.0]; to = [5.0, 5.0, 5.0]; };"
#define HEAVY "gravity = [0.0, 0.0, -9.81];"
#endif
#define FLOOR "stops = [\"bottom\"]; margin = 0.005;"

static void near(double found, double expected, double tolerance, const char *what)
{
    printf("# %s: %.9g, expected %.9g within %.2g\n", what, found, expected, tolerance);
    check(fabs(found - expected) <= tolerance, "%s: found %.12g, expected %.12g within %g", what,
          found, expected, tolerance);
}

static double *row(const struct tank *t, const char *what)
{
    char name[80];

    snprintf(name, sizeof name, "body.it.%s", what);
    return t->y + tank_at(t, name, NULL);
}

static void refused(const char *body, const char *words)
{
    char scene[1000];
    struct tank t;

    snprintf(scene, sizeof scene, "%s %s body = { it = { at = %s; density = 500.0; %s }; };", PLACE,
             HEAVY, DIM == 2 ? "[0.0, 1.0]" : "[0.0, 0.0, 1.0]", body);
    assert_int_equal(tank_try(&t, scene), STATUS_BAD_SCENE);
    check(strstr(status_message(), words), "\"%s\" does not say \"%s\"", status_message(), words);
    status_clear();
    tank_free(&t);
}

/* A box, and the same by its corners: they are one, and so is what the ground does to them when
 * they are that much deeper. */
static void moves_as_the_box(const char *box, const char *other, double down)
{
    struct tank t[2];

    for (int i = 0; i < 2; i++) {
        tank_make(&t[i], PLACE HEAVY "body = { it = {", i ? other : box, "}; };", NULL);
        row(&t[i], "x")[UP] -= down;
        tank_rates(&t[i], 0, t[i].y, t[i].ydot);
    }
    check(t[0].ydot[row(&t[0], "v") + UP - t[0].y] > 10, "the ground does not push");
    for (long i = 0; i < tank_at(&t[0], "contacts.slip", NULL); i++) {
        near(t[1].y[i], t[0].y[i], 1e-12, "state");
        near(t[1].ydot[i], t[0].ydot[i], 1e-9 * (1 + fabs(t[0].ydot[i])), "its rate");
    }
    tank_free(&t[0]);
    tank_free(&t[1]);
}

/* What pictures show of a body encloses its volume; polygons in circles of n corners less. */
static void encloses(const char *body, double volume)
{
    struct surface s = { 0 };
    struct tank t;

    tank_make(&t, PLACE HEAVY "body = { it = { at = ", DIM == 2 ? "[0.1, 2.0]" : "[0.1, 0.0, 2.0]",
              "; density = 500.0; ", body, "}; };", NULL);
    assert_int_equal(plan_body_look(t.plan, 0, &s), STATUS_DONE);
    near(surface_volume(&s), volume, 1e-12, body);
    surface_free(&s);
    tank_free(&t);
}

static void surfaces_enclose_volumes(void **state)
{
    (void)state;
#if DIM == 2
    encloses("size = [0.3, 0.2]; angle = 20.0;", 0.06);
    encloses("shape = \"disc\"; radius = 0.1;", 32 * sin(2 * M_PI / 64) * 0.01);
    encloses("shape = \"polygon\"; points = ([0.0, 0.0], [0.3, 0.0], [0.3, 0.2], [0.2, 0.1], [0.0, 0.2]);",
             0.045);
#else
    encloses("size = [0.3, 0.2, 0.1]; angle = [20.0, 0.0, 0.0];", 0.006);
    encloses("shape = \"cylinder\"; radius = 0.1; height = 0.3;", 24 * sin(2 * M_PI / 48) * 0.003);
    encloses("shape = \"hull\"; points = ([0.0, 0.0, 0.0], [0.3, 0.0, 0.0], [0.0, 0.3, 0.0], "
             "[0.0, 0.0, 0.3]);", 0.0045);
    encloses("shape = \"compound\"; points = ([0.0, 0.0, 0.0], [0.3, 0.1, 0.1], [0.0, 0.0, 0.1], [0.1, 0.1, 0.3]);",
             0.005);
#endif
}

/* The corner of a turned box, where its pose has it. */
static void surfaces_stand_with_their_body(void **state)
{
    struct surface s = { 0 };
    struct solid_place at;
    struct tank t;
    double x[DIM];

    (void)state;
#if DIM == 2
    const double corner[2] = { 0.1 - 0.15 * 0.5 + 0.1 * sqrt(0.75), 2 - 0.15 * sqrt(0.75) - 0.1 * 0.5 };
    tank_make(&t, PLACE "body = { it = { at = [0.1, 2.0]; size = [0.3, 0.2]; angle = 60.0; "
              "density = 500.0; }; };", NULL);
#else
    const double corner[3] = { 0.1 - 0.15 * 0.5 + 0.1 * sqrt(0.75), -0.15 * sqrt(0.75) - 0.1 * 0.5, 1.95 };
    tank_make(&t, PLACE "body = { it = { at = [0.1, 0.0, 2.0]; size = [0.3, 0.2, 0.1]; "
              "angle = [0.0, 0.0, 60.0]; density = 500.0; }; };", NULL);
#endif
    assert_int_equal(plan_body_look(t.plan, 0, &s), STATUS_DONE);
    observe_stand(t.moment, 0, t.y, &at);
    solid_space(&at, s.x[0], x);
    for (int d = 0; d < DIM; d++)
        near(at.x[d] + x[d], corner[d], 1e-14, "corner");
    surface_free(&s);
    tank_free(&t);
}

/* Bars that cross have no corner in each other. */
#if DIM == 2
#define FIRST "[0.0, 1.0]"
#define CROSSING "[0.4, 0.6]"
#define BESIDE "[0.91, 0.6]"
#define BAR(name, at, long_x, long_y) name " = { shape = \"polygon\"; density = 500.0; at = " at "; "  \
    "points = ([0.0, 0.0], [" long_x ", 0.0], [" long_x ", " long_y "], [0.0, " long_y "]); };"
#else
#define FIRST "[0.0, 0.0, 1.0]"
#define CROSSING "[0.4, -0.4, 1.02]"
#define BESIDE "[0.4, -0.4, 1.11]"
#define BAR(name, at, long_x, long_y) name " = { shape = \"hull\"; density = 500.0; at = " at "; "  \
    "points = ([0.0, 0.0, 0.0], [" long_x ", 0.0, 0.0], [" long_x ", " long_y ", 0.0], "           \
    "[0.0, " long_y ", 0.0], [0.0, 0.0, 0.1], [" long_x ", 0.0, 0.1], [" long_x ", " long_y ", 0.1], " \
    "[0.0, " long_y ", 0.1]); };"
#endif

static void bars_that_cross_are_refused(void **state)
{
    struct tank t;

    (void)state;
    assert_int_equal(tank_try(&t, PLACE "body = {"
                              BAR("a", FIRST, "0.9", "0.1")
                              BAR("b", CROSSING, "0.1", "0.9")
                              "};"), STATUS_BAD_SCENE);
    check(strstr(status_message(), "overlap at t = 0"), "%s", status_message());
    status_clear();
    tank_free(&t);
    assert_int_equal(tank_try(&t, PLACE "body = {"
                              BAR("a", FIRST, "0.9", "0.1")
                              BAR("b", BESIDE, "0.1", "0.9")
                              "};"), STATUS_DONE);
    tank_free(&t);
}

#if DIM == 2

/* Corners from the first of them, about which `angle` turns it: its centre is that of the box. */
static void a_polygon_with_four_corners_is_a_box(void **state)
{
    const double c = cos(M_PI / 9), s = sin(M_PI / 9);
    char polygon[400];

    (void)state;
    snprintf(polygon, sizeof polygon, "shape = \"polygon\"; at = [%.15f, %.15f]; points = ([0.0, 0.0], "
             "[0.3, 0.0], [0.3, 0.2], [0.0, 0.2]); angle = 20.0; density = 500.0; spin = 1.0; "
             "velocity = [0.3, 0.0];" FLOOR, 0.1 * s - 0.15 * c, 0.4 - 0.15 * s - 0.1 * c);
    moves_as_the_box("at = [0.0, 0.4]; size = [0.3, 0.2]; angle = 20.0; density = 500.0; spin = 1.0;"
                     "velocity = [0.3, 0.0];" FLOOR, polygon, 0.2575);
}

/* Two feet 0.1 wide below a plate: they stand on the ground on both sides of a step, which is
 * higher than the feet's gap is below their mean. */
static void a_table_stands_over_a_bump(void **state)
{
    struct tank t;

    (void)state;
    tank_make(&t, PLACE HEAVY "spacing = 0.05; wall = { bump = { type = \"box\"; from = [-0.1, 0.0]; "
              "to = [0.1, 0.15]; }; }; body = { it = { shape = \"polygon\"; at = [0.0, 0.002]; "
              "density = 500.0; points = ([-0.3, 0.0], [-0.2, 0.0], [-0.2, 0.2], [0.2, 0.2], "
              "[0.2, 0.0], [0.3, 0.0], [0.3, 0.3], [-0.3, 0.3]);" FLOOR "}; };", NULL);
    const double area = 0.6 * 0.3 - 0.4 * 0.2, centre = (0.18 * 0.15 - 0.08 * 0.1) / area;
    near(row(&t, "x")[1], 0.002 + centre, 1e-12, "its centre at the start");
    tank_run(&t, "cks43", 1e-3, 2);
    near(row(&t, "x")[1], centre, 1e-4, "its centre");
    near(row(&t, "turn")[0], 0, 1e-6, "its angle");
    near(row(&t, "v")[1], 0, 1e-6, "its speed");
    tank_free(&t);
}

/* To the last bit, or a disc would drift to one side. */
static void skins_of_discs_are_their_mirror_images(void **state)
{
    static const double radius[] = { 0.08, 0.083, 0.1, 0.047 };

    (void)state;
    for (int k = 0; k < 4; k++) {
        struct rigid_def d = { .shape = "disc", .radius = radius[k], .density = 700 };
        struct rigid_figure f;
        struct points p = { 0 };
        assert_int_equal(rigid_figure_make(&d, "body.it", &f), STATUS_DONE);
        assert_int_equal(f.form->skin(&f, 0.01, 3, &p), STATUS_DONE);
        check(p.n > 50, "%ld points", p.n);
        for (long i = 0; i < p.n; i++) {
            bool found = false;
            for (long j = 0; j < p.n; j++)
                found |= p.x[j][0] == -p.x[i][0] && p.x[j][1] == p.x[i][1];
            check(found, "radius %g: point %ld has no image", radius[k], i);
        }
        points_free(&p);
        rigid_figure_free(&f);
    }
}

static void refusals_teach(void **state)
{
    (void)state;
    refused("shape = \"polygon\";", "without points it is no polygon");
    refused("shape = \"polygon\"; points = ([0.0, 0.0], [1.0, 0.0]);", "three corners or more");
    refused("shape = \"polygon\"; points = ([0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]);", "crosses");
    refused("shape = \"disc\"; radius = 0.1; points = ([0.0, 0.0], [1.0, 0.0], [0.0, 1.0]);",
            "a disc has no points");
    refused("shape = \"polygon\"; points = ([0.0, 0.0], [1.0, 0.0], [0.0, 1.0]); uplift = true;",
            "flat faces of a box");
}

#else

static struct body_pose pose_of(const struct tank *t)
{
    struct body_pose pose;

    observe_pose(t->moment, 0, t->y, &pose);
    return pose;
}

static const char *const corners =
    "points = ([0.0, 0.0, 0.0], [0.3, 0.0, 0.0], [0.0, 0.2, 0.0], [0.3, 0.2, 0.0], "
    "[0.0, 0.0, 0.15], [0.3, 0.0, 0.15], [0.0, 0.2, 0.15], [0.3, 0.2, 0.15]);";

static void a_hull_with_eight_corners_is_a_box(void **state)
{
    char hull[800];

    (void)state;
    snprintf(hull, sizeof hull, "shape = \"hull\"; at = [-0.15, -0.1, 0.325]; %s density = 500.0; "
             "spin = [0.5, 2.0, 1.0]; velocity = [0.3, 0.0, 0.0];" FLOOR, corners);
    moves_as_the_box("at = [0.0, 0.0, 0.4]; size = [0.3, 0.2, 0.15]; density = 500.0; "
                     "spin = [0.5, 2.0, 1.0]; velocity = [0.3, 0.0, 0.0];" FLOOR, hull, 0.3255);
}

/* The same box, its corners told in axes that are turned against it by Q, and turned back by
 * `angle`: all that a scene says and reads is as if its own axes were those it was told in. */
static void a_hull_is_told_by_the_axes_of_its_points(void **state)
{
    const double half[3] = { 0.15, 0.1, 0.075 }, about[3] = { 0.2, 0.5, -0.3 }, spin[3] = { 0.5, 2, 1 };
    double q[4], Q[3][3], own[3] = { 0 }, A[3][3], B[3][3];
    char hull[1500], box[300];
    struct tank t[2];

    (void)state;
    turning_about(about, q);
    turning_matrix(q, Q);
    snprintf(hull, sizeof hull, "shape = \"hull\"; at = [0.0, 0.0, 0.4]; density = 500.0; "
             "spin = [0.5, 2.0, 1.0]; angle = [%.15f, %.15f, %.15f]; points = (", -about[0] * 180 / M_PI,
             -about[1] * 180 / M_PI, -about[2] * 180 / M_PI);
    for (int i = 0; i < 8; i++) {
        double x[3] = { 0 };
        for (int d = 0; d < 3; d++)
            for (int k = 0; k < 3; k++)
                x[d] += Q[d][k] * (i >> k & 1 ? half[k] : -half[k]);
        snprintf(hull + strlen(hull), sizeof hull - strlen(hull), "%s[%.15f, %.15f, %.15f]",
                 i ? ", " : "", x[0], x[1], x[2]);
    }
    strcat(hull, ");");
    for (int k = 0; k < 3; k++)
        for (int d = 0; d < 3; d++)
            own[k] += Q[d][k] * spin[d];
    snprintf(box, sizeof box, "at = [0.0, 0.0, 0.4]; size = [0.3, 0.2, 0.15]; density = 500.0; "
             "spin = [%.15f, %.15f, %.15f];", own[0], own[1], own[2]);
    tank_make(&t[0], PLACE HEAVY "body = { it = {", box, "}; };", NULL);
    tank_make(&t[1], PLACE HEAVY "body = { it = {", hull, "}; };", NULL);
    const struct body_pose first = pose_of(&t[1]);
    for (int i = 0; i < 4; i++)
        near(first.turn[i], i == 0 ? q[0] : -q[i], 1e-9, "turn as given");
    for (int i = 0; i < 3; i++)
        near(first.spin[i], spin[i], 1e-9, "spin as given");
    for (int i = 0; i < 2; i++)
        tank_run(&t[i], "cks43", 1e-6, 0.2);
    const struct body_pose a = pose_of(&t[0]), b = pose_of(&t[1]);
    turning_matrix(a.turn, A);
    turning_matrix(b.turn, B);
    for (int i = 0; i < 9; i++) { /* sides of the box in space, both ways */
        double side = 0;
        for (int k = 0; k < 3; k++)
            side += B[i / 3][k] * Q[k][i % 3];
        near(side, A[i / 3][i % 3], 1e-5, "the same motion");
    }
    tank_free(&t[0]);
    tank_free(&t[1]);
}

/* Down a slope it rolls with 2/3 g sin, as friction is enough for that. */
static void a_log_rolls(void **state)
{
    const double slope = 10 * M_PI / 180;
    char gravity[100];
    struct tank t;

    (void)state;
    snprintf(gravity, sizeof gravity, "gravity = [%.15f, 0.0, %.15f];", 9.81 * sin(slope),
             -9.81 * cos(slope));
    tank_make(&t, PLACE, gravity, "body = { it = { shape = \"cylinder\"; at = [-2.0, 0.0, 0.1]; radius = 0.1; "
              "height = 0.5; density = 500.0; angle = [90.0, 0.0, 0.0];" FLOOR "}; };", NULL);
    tank_run(&t, "cks43", 1e-3, 1);
    near(row(&t, "v")[0], 2 / 3.0 * 9.81 * sin(slope), 0.01 * 9.81 * sin(slope), "speed after 1 s");
    near(row(&t, "x")[2], 0.1, 1e-3, "height");
    near(row(&t, "v")[1], 0, 1e-6, "aside");
    tank_free(&t);
}

/* On its end: neither the rod with its round ends nor the rim lets it fall. */
static void a_cylinder_stands(double height, const char *text)
{
    struct tank t;
    double R[3][3];
    char body[300];

    snprintf(body, sizeof body, "body = { it = { shape = \"cylinder\"; at = [0.0, 0.0, %g]; radius = 0.1; "
             "height = %g; density = 500.0; angle = [2.0, 1.0, 0.0];" FLOOR "}; };", 0.5 * height + 0.008,
             height);
    tank_make(&t, PLACE HEAVY, body, NULL);
    tank_run(&t, "cks43", 1e-3, 3);
    turning_matrix(row(&t, "turn"), R);
    near(R[2][2], 1, 1e-6, text);
    near(row(&t, "x")[2], 0.5 * height, 3e-4, "height of its centre");
    tank_free(&t);
}

static void cylinders_stand(void **state)
{
    (void)state;
    a_cylinder_stands(0.3, "a long one is upright");
    a_cylinder_stands(0.06, "a flat one is upright");
}

/* --- several convex parts ------------------------------------------------------------- */

/* Two halves, one of them a hull of its own that is turned inside out, are the box of both. */
static void halves_weigh_what_the_box_does(void **state)
{
    double x[][3] = { { 0.3, 0.2, 0 }, { 0.1, 0, 0.1 }, { 0, 0, 0 }, { 0.1, 0.2, 0.1 } };
    struct rigid_def box = { .shape = "box", .size = { 0.3, 0.2, 0.1 }, .density = 700 };
    struct rigid_def def = { .shape = "compound", .points = { 4, x }, .corners = 2, .density = 700 };
    struct rigid_figure a, b;

    (void)state;
    assert_int_equal(rigid_figure_make(&box, "body.it", &a), STATUS_DONE);
    assert_int_equal(rigid_figure_make(&def, "body.it", &b), STATUS_DONE);
    near(b.volume, a.volume, 1e-15, "volume");
    near(b.reach, a.reach, 1e-15, "reach");
    for (int k = 0; k < DIM; k++) {
        near(b.gyration[k], a.gyration[k], 1e-15, "gyration");
        near(b.centre[k], 0.5 * box.size[k], 1e-15, "centre");
        near(b.span[k], box.size[k], 1e-15, "span");
    }
    rigid_figure_free(&a);
    rigid_figure_free(&b);
}

/* A T of two bars: centre and moments by the theorem of Steiner. */
static void a_tee_weighs_what_its_bars_do(void **state)
{
    double x[][3] = { { -0.3, -0.05, 0.4 }, { 0.3, 0.05, 0.5 }, { -0.05, -0.05, 0 }, { 0.05, 0.05, 0.4 } };
    struct rigid_def def = { .shape = "compound", .points = { 4, x }, .corners = 2, .density = 1000 };
    const double m[2] = { 0.006, 0.004 }, up[2] = { 0.45, 0.2 }, all = m[0] + m[1];
    const double centre = (m[0] * up[0] + m[1] * up[1]) / all;
    double about[3] = { m[0] * (0.1 * 0.1 + 0.1 * 0.1) / 12 + m[1] * (0.1 * 0.1 + 0.4 * 0.4) / 12,
                        m[0] * (0.6 * 0.6 + 0.1 * 0.1) / 12 + m[1] * (0.1 * 0.1 + 0.4 * 0.4) / 12,
                        m[0] * (0.6 * 0.6 + 0.1 * 0.1) / 12 + m[1] * (0.1 * 0.1 + 0.1 * 0.1) / 12 };
    struct rigid_figure f;
    double sum = 0, found = 0;

    (void)state;
    for (int i = 0; i < 2; i++) {
        about[0] += m[i] * (up[i] - centre) * (up[i] - centre);
        about[1] += m[i] * (up[i] - centre) * (up[i] - centre);
    }
    assert_int_equal(rigid_figure_make(&def, "body.it", &f), STATUS_DONE);
    near(f.volume, all, 1e-15, "volume");
    near(f.centre[2], centre, 1e-15, "centre");
    for (int k = 0; k < 3; k++) { /* in whatever order its axes come */
        double least = 1;
        for (int i = 0; i < 3; i++)
            least = fmin(least, fabs(f.gyration[i] - about[k] / all));
        near(least, 0, 1e-15, "a principal moment");
        sum += about[k] / all;
        found += f.gyration[k];
    }
    near(found, sum, 1e-15, "all of them");
    rigid_figure_free(&f);
}

/* Two feet below a plate stand on the ground on both sides of a bump, which the hull of all would lie on. */
static void a_table_of_boxes_stands_over_a_bump(void **state)
{
    struct tank t;

    (void)state;
    tank_make(&t, PLACE HEAVY "spacing = 0.05; wall = { bump = { type = \"box\"; from = [-0.1, -0.3, 0.0]; "
              "to = [0.1, 0.3, 0.15]; }; }; body = { it = { shape = \"compound\"; at = [0.0, 0.0, 0.002]; "
              "density = 500.0; points = ([-0.3, -0.2, 0.0], [-0.2, 0.2, 0.2], [0.2, -0.2, 0.0], [0.3, 0.2, 0.2], "
              "[-0.3, -0.2, 0.2], [0.3, 0.2, 0.3]);" FLOOR "}; };", NULL);
    const double area = 0.6 * 0.3 - 0.4 * 0.2, centre = (0.18 * 0.15 - 0.08 * 0.1) / area;
    near(row(&t, "x")[UP], 0.002 + centre, 1e-12, "its centre at the start");
    tank_run(&t, "cks43", 1e-3, 2);
    near(row(&t, "x")[UP], centre, 1e-4, "its centre");
    for (int d = 0; d < 3; d++) {
        near(row(&t, "spin")[d], 0, 1e-6, "its spin");
        near(row(&t, "v")[d], 0, 1e-6, "its speed");
    }
    tank_free(&t);
}

static void compounds_teach(void **state)
{
    (void)state;
    refused("shape = \"compound\";", "without points it is no compound");
    refused("shape = \"compound\"; points = ([0.0, 0.0, 0.0], [1.0, 1.0, 1.0], [1.0, 0.0, 0.0]);",
            "no whole number of parts");
    refused("shape = \"compound\"; points = ([0.0, 0.0, 0.0], [1.0, 1.0, 0.0]);", "part 1: its two points");
    refused("shape = \"compound\"; points = ([0.0, 0.0, 0.0], [1.0, 1.0, 1.0], [0.5, 0.5, 0.5], [2.0, 2.0, 2.0]);",
            "parts 2 and 1 overlap");
    refused("shape = \"compound\"; corners = 4; points = ([0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], "
            "[1.0, 1.0, 0.0]);", "lie in one plane");
    refused("size = [1.0, 1.0, 1.0]; corners = 4;", "a box has no corners");
}

static void refusals_teach(void **state)
{
    (void)state;
    refused("shape = \"hull\"; points = ([0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], "
            "[1.0, 1.0, 0.0]);", "lie in one plane");
    refused("shape = \"hull\";", "without points it is no hull");
    refused("shape = \"cylinder\"; radius = 0.1;", "without height it is no cylinder");
    refused("shape = \"sphere\"; radius = 0.1; height = 0.2;", "a sphere has no height");
    refused("shape = \"cylinder\"; radius = 0.1; height = 0.2; margin = 0.2;", "margin");
}

#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
#if DIM == 2
        cmocka_unit_test(a_polygon_with_four_corners_is_a_box),
        cmocka_unit_test(a_table_stands_over_a_bump),
        cmocka_unit_test(skins_of_discs_are_their_mirror_images),
#else
        cmocka_unit_test(a_hull_with_eight_corners_is_a_box),
        cmocka_unit_test(a_hull_is_told_by_the_axes_of_its_points),
        cmocka_unit_test(a_log_rolls),
        cmocka_unit_test(cylinders_stand),
        cmocka_unit_test(halves_weigh_what_the_box_does),
        cmocka_unit_test(a_tee_weighs_what_its_bars_do),
        cmocka_unit_test(a_table_of_boxes_stands_over_a_bump),
        cmocka_unit_test(compounds_teach),
#endif
        cmocka_unit_test(bars_that_cross_are_refused),
        cmocka_unit_test(surfaces_enclose_volumes),
        cmocka_unit_test(surfaces_stand_with_their_body),
        cmocka_unit_test(refusals_teach),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
