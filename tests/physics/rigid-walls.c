/* rigid-walls.c -- rigid bodies on walls of every shape: what lies on them, slides down them and
 * fits between them, against closed forms. */
#include "../unit/tank-run.h"
#include "tank.h"

#include "base/status.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { UP = DIM - 1 };

#if DIM == 2
#define PLACE "dimension = 2; until = 100.0; spacing = 0.05; gravity = [0.0, -9.81];" \
    "domain = { from = [-5.0, -1.0]; to = [5.0, 5.0]; };"
#else
#define PLACE "dimension = 3; until = 100.0; spacing = 0.05; gravity = [0.0, 0.0, -9.81];" \
    "domain = { from = [-5.0, -5.0, -1.0]; to = [5.0, 5.0, 5.0]; };"
#endif

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

/* A body that is a little deep in a wall: two ways to tell the wall, one rate. */
static void one_wall(const char *wall, const char *other, const char *body)
{
    struct tank t[2];

    for (int i = 0; i < 2; i++) {
        tank_make(&t[i], PLACE "wall = { block = {", i ? other : wall, "}; };", body, NULL);
        row(&t[i], "x")[UP] -= 0.001;
        tank_rates(&t[i], 0, t[i].y, t[i].ydot);
    }
    check(t[0].ydot[row(&t[0], "v") + UP - t[0].y] > 10, "the wall does not push");
    for (long i = 0; i < tank_at(&t[0], "contacts.slip", NULL); i++)
        near(t[1].ydot[i], t[0].ydot[i], 1e-9 * (1 + fabs(t[0].ydot[i])), "its rate");
    tank_free(&t[0]);
    tank_free(&t[1]);
}

/* After 0.3 s from rest without friction. */
static void slides(const char *scene, double slope, const char *what)
{
    struct tank t;

    tank_make(&t, PLACE, scene, NULL);
    tank_run(&t, "erk4", 1e-4, 0.3);
    near(hypot(row(&t, "v")[0], row(&t, "v")[UP]), 9.81 * sin(slope) * 0.3, 0.002, what);
    near(atan2(-row(&t, "v")[UP], fabs(row(&t, "v")[0])), slope, 0.002, "direction");
    tank_free(&t);
}

/* `down` is what contacts yield under the weight. */
static void rests(const char *scene, double x, double up, double down, const char *what)
{
    struct tank t;

    tank_make(&t, PLACE, scene, NULL);
    tank_run(&t, "cks43", 1e-3, 3);
    near(row(&t, "x")[0], x, 1e-3, what);
    near(row(&t, "x")[UP], up - 0.5 * down, 0.5 * down, "height");
    near(row(&t, "v")[UP], 0, 1e-6, "speed");
    tank_free(&t);
}

#if DIM == 2

#define VALLEY "wall = { valley = { type = \"polygon\"; points = ([-1.0, 0.0], [1.0, 0.0], [1.0, 1.2], " \
    "[0.0, 0.2], [-1.0, 1.2]); }; };"

static void a_block_by_its_corners_is_a_box(void **state)
{
    (void)state;
    one_wall("type = \"box\"; from = [-0.5, 0.0]; to = [0.7, 0.4];",
             "type = \"polygon\"; points = ([-0.5, 0.0], [-0.5, 0.4], [0.7, 0.4], [0.7, 0.0]);",
             "body = { it = { at = [0.0, 0.5]; size = [0.3, 0.2]; density = 500.0; spin = 1.0; "
             "velocity = [0.3, 0.0]; }; };");
}

static void a_disc_slides_into_a_valley_and_rests_there(void **state)
{
    (void)state;
    slides(VALLEY "body = { it = { shape = \"disc\"; radius = 0.1; at = [0.4292893219, 0.7707106781]; "
           "friction = 0.0; density = 500.0; softness = 0.01; }; };", M_PI / 4, "speed of a disc");
    slides(VALLEY "body = { it = { shape = \"polygon\"; points = ([0.0, 0.0], [0.3, 0.3], [0.15, 0.45], "
           "[-0.15, 0.15]); at = [0.5, 0.7]; friction = 0.0; density = 500.0; softness = 0.01; }; };",
           M_PI / 4, "speed of a block");
    rests(VALLEY "body = { it = { shape = \"disc\"; radius = 0.1; at = [0.02, 0.4]; density = 500.0; "
          "restitution = 0.3; }; };", 0, 0.2 + 0.1 * M_SQRT2, 1e-3, "the middle of the valley");
}

static void shores_without_end_are_refused(void **state)
{
    static char scene[60000];
    struct tank t;

    (void)state;
    strcpy(scene, PLACE "wall = { coast = { type = \"polygon\"; points = ([-1.0, 0.0], [1.0, 0.0]");
    for (int i = 0; i < 1100; i++)
        snprintf(scene + strlen(scene), sizeof scene - strlen(scene), ", [%.6f, %.6f]", 1 - i / 550.0,
                 0.5 + 0.1 * sin(0.01 * i));
    strcat(scene, "); }; }; body = { it = { at = [0.0, 2.0]; size = [0.3, 0.2]; density = 500.0; }; };");
    assert_int_equal(tank_try(&t, scene), STATUS_BAD_SCENE);
    check(strstr(status_message(), "wall.coast: a polygon that bodies touch may have 1000 corners"), "%s",
          status_message());
    status_clear();
    tank_free(&t);
}

#else

#define RAMP "wall = { ramp = { type = \"hull\"; points = ([0.0, 0.0, 0.0], [2.0, 0.0, 0.0], " \
    "[2.0, 0.0, 1.0], [0.0, 1.0, 0.0], [2.0, 1.0, 0.0], [2.0, 1.0, 1.0]); }; };"
#define LOGS "wall = { left = { type = \"cylinder\"; centre = [-0.15, 0.0, 0.0]; radius = 0.1; height = 1.0; " \
    "axis = [0.0, 1.0, 0.0]; }; right = { type = \"cylinder\"; centre = [0.15, 0.0, 0.0]; "             \
    "radius = 0.1; height = 1.0; axis = [0.0, 1.0, 0.0]; }; };"

static void a_block_by_its_corners_is_a_box(void **state)
{
    (void)state;
    one_wall("type = \"box\"; from = [-0.5, -0.4, 0.0]; to = [0.7, 0.3, 0.4];",
             "type = \"hull\"; points = ([-0.5, -0.4, 0.0], [0.7, -0.4, 0.0], [-0.5, 0.3, 0.0], "
             "[0.7, 0.3, 0.0], [-0.5, -0.4, 0.4], [0.7, -0.4, 0.4], [-0.5, 0.3, 0.4], [0.7, 0.3, 0.4]);",
             "body = { it = { at = [0.0, 0.0, 0.475]; size = [0.3, 0.2, 0.15]; density = 500.0; "
             "spin = [0.5, 2.0, 1.0]; velocity = [0.3, 0.0, 0.0]; }; };");
}

/* Its lowest edge runs along the ramp's line of fall: cylinder and box lie on their sides. */
static void things_slide_down_a_ramp(void **state)
{
    (void)state;
    slides(RAMP "body = { it = { shape = \"sphere\"; radius = 0.1; at = [1.4552786405, 0.5, 0.8394427191]; "
           "friction = 0.0; density = 500.0; softness = 0.01; }; };", atan(0.5), "speed of a ball");
    slides(RAMP "body = { it = { size = [0.3, 0.2, 0.2]; at = [1.4552786405, 0.5, 0.8394427191]; "
           "angle = [0.0, -26.565051177, 0.0]; friction = 0.0; density = 500.0; softness = 0.01; }; };",
           atan(0.5), "speed of a block");
}

static void a_ball_rests_between_logs(void **state)
{
    (void)state;
    rests(LOGS "body = { it = { shape = \"sphere\"; radius = 0.2; at = [0.01, 0.0, 0.3]; density = 500.0; "
          "restitution = 0.3; }; };", 0, sqrt(0.3 * 0.3 - 0.15 * 0.15), 3e-3, "the middle between logs");
}

#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_block_by_its_corners_is_a_box),
#if DIM == 2
        cmocka_unit_test(a_disc_slides_into_a_valley_and_rests_there),
        cmocka_unit_test(shores_without_end_are_refused),
#else
        cmocka_unit_test(things_slide_down_a_ramp),
        cmocka_unit_test(a_ball_rests_between_logs),
#endif
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
