/* rigid-stops.c -- rigid bodies on sides of the domain: impacts, rest, friction, rolling, against
 * closed forms; slopes are made by turning gravity. */
#include "../unit/tank-run.h"
#include "tank.h"

#include "base/status.h"
#include "bodies/touch.h"
#include "bodies/turning.h"
#include "plan/inside.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#if DIM == 2
#define HEAD "dimension = 2;"
#define VECTOR(x, y, up) "[" x ", " up "]"
#define ROUND "disc"
#define TURNED "20.0"
static const double roll = 2 / 3.0; /* 1/(1 + I/(m R^2)) */
#else
#define HEAD "dimension = 3;"
#define VECTOR(x, y, up) "[" x ", " y ", " up "]"
#define ROUND "sphere"
#define TURNED "[20.0, 30.0, 10.0]"
static const double roll = 5 / 7.0;
#endif

#define PLACE                                                                            \
    HEAD "until = 100.0; domain = { from = " VECTOR("-50.0", "-50.0", "0.0") "; to = "   \
    VECTOR("50.0", "50.0", "50.0") "; };"
#define BOX(up, keys)                                                                    \
    "body = { it = { at = " VECTOR("0.0", "0.0", up) "; size = "                         \
    VECTOR("0.15", "0.15", "0.15") "; mass = 2.7; stops = [\"bottom\"]; margin = 0.005;" keys "}; };"
#define BALL(keys)                                                                       \
    "body = { it = { shape = \"" ROUND "\"; at = " VECTOR("0.0", "0.0", "0.1")           \
    "; radius = 0.1; mass = 2.7; stops = [\"bottom\"]; margin = 0.005; softness = 0.1;" keys "}; };"

enum { UP = DIM - 1 };

static void near(double found, double expected, double tolerance, const char *what)
{
    printf("# %s: %.9g, expected %.9g within %.2g\n", what, found, expected, tolerance);
    check(fabs(found - expected) <= tolerance, "%s: found %.12g, expected %.12g within %g", what,
          found, expected, tolerance);
}

static void begin(struct tank *t, double slope, const char *body)
{
    char text[200];
    const double g = 9.81, across = g * sin(slope * M_PI / 180), down = -g * cos(slope * M_PI / 180);

    if (DIM == 2)
        snprintf(text, sizeof text, "gravity = [%.15e, %.15e];", across, down);
    else
        snprintf(text, sizeof text, "gravity = [%.15e, 0.0, %.15e];", across, down);
    tank_make(t, PLACE, text, body, NULL);
}

static const double *row(const struct tank *t, const char *name)
{
    return t->y + tank_at(t, name, NULL);
}

/* By a program apart from this one, whose integration was solved for eta with the same cut. */
static void damping_gives_the_restitution(void **state)
{
    static const double known[][2] = { { 0.3, 1.1119 }, { 0.5, 0.5708 }, { 0.6, 0.4044 },
                                       { 0.8, 0.1663 }, { 0.95, 0.0369 } };

    (void)state;
    for (int i = 0; i < 5; i++)
        near(touch_damping(known[i][0]), known[i][1], 1e-3, "eta");
    near(touch_damping(1), 0, 0, "eta of no damping");
}

/* A ball thrown at the bottom, without weight, comes back with e v, whatever v. */
static void a_ball_bounces(void **state)
{
    static const char *const speed[] = { "-0.05", "-0.2", "-1.0", "-2.0" };
    static const double v[] = { 0.05, 0.2, 1, 2 };

    (void)state;
    for (int i = 0; i < 4; i++) {
        struct tank t;
        char body[400];
        snprintf(body, sizeof body, BALL("restitution = 0.6; velocity = " VECTOR("0.0", "0.0", "%s")
                                         ";"), speed[i]);
        tank_make(&t, PLACE, "gravity = " VECTOR("0.0", "0.0", "0.0") ";", body, NULL);
        tank_run(&t, "cks43", 1e-4, 0.2);
        near(row(&t, "body.it.v")[UP] / v[i], 0.6, 5e-4, "restitution");
        tank_free(&t);
    }
}

/* How fast the lowest corner of the box goes up, and how far it is above the bottom. */
static double corner_up(const struct tank *t, double *gap)
{
    double R[DIM][DIM], lowest = HUGE_VAL, up = 0;

    turning_matrix(row(t, "body.it.turn"), R);
    for (int i = 0; i < 1 << DIM; i++) {
        double arm[DIM], own[DIM], height = 0, v = row(t, "body.it.v")[UP];
        for (int d = 0; d < DIM; d++) {
            arm[d] = i >> d & 1 ? 0.07 : -0.07;
            height += R[UP][d] * arm[d];
        }
        turning_velocity(row(t, "body.it.spin"), arm, own);
        for (int d = 0; d < DIM; d++)
            v += R[UP][d] * own[d];
        if (height < lowest) {
            lowest = height;
            up = v;
        }
    }
    *gap = row(t, "body.it.x")[UP] + lowest - 0.005;
    return up;
}

/* However far beside the centre: damping goes by the mass that the corner has there. */
static void a_corner_bounces_as_a_ball(void **state)
{
    double gap, up = -1;
    struct tank t;

    (void)state;
    tank_make(&t, PLACE, "gravity = " VECTOR("0.0", "0.0", "0.0") ";",
              BOX("0.13", "softness = 0.003; friction = 0.0; velocity = "
                  VECTOR("0.0", "0.0", "-1.0") "; angle = " TURNED ";"), NULL);
    near(corner_up(&t, &gap), -1, 1e-12, "before");
    for (int i = 0; i < 2000 && !(gap > 0 && up > 0); i++) { /* until it has hit */
        tank_run(&t, "cks43", 1e-5, 1e-4);
        up = corner_up(&t, &gap);
    }
    near(up, 0.6, 1e-2, "restitution of a corner");
    tank_free(&t);
}

/* Dropped by some 0.2 m it hits with a corner. */
static void a_corner_is_booked(void **state)
{
    static const double tol[] = { 1e-2, 1e-3, 1e-5 }, bound[] = { 5e-3, 2e-3, 1e-5 };

    (void)state;
    for (int i = 0; i < 3; i++) {
        struct book_sheet first, last;
        struct tank t;
        begin(&t, 0, BOX("0.3", "angle = " TURNED ";"));
        observe_sheet(t.moment, 0, t.y, &first);
        tank_run(&t, "cks43", tol[i], 0.23);
        observe_sheet(t.moment, 0.23, t.y, &last);
        check(t.y[layout_at(&t.plan->layout, t.plan->book.row) + t.plan->book.contacts] < -0.1, "it has not hit");
        near(book_defect(&first, &last), 0, bound[i] * first.total, "energy of a corner that hits [J]");
        tank_free(&t);
    }
}

static void a_box_comes_to_rest(void **state)
{
    struct tank t;
    double least = HUGE_VAL, most = -HUGE_VAL;

    (void)state;
    begin(&t, 0, BOX("0.076", ""));
    tank_run(&t, "cks43", 1e-2, 2);
    const double at_rest = row(&t, "body.it.x")[UP];
    for (int look = 0; look < 8; look++) {
        tank_run(&t, "cks43", 1e-2, 1);
        least = fmin(least, row(&t, "body.it.x")[UP]);
        most = fmax(most, row(&t, "body.it.x")[UP]);
        check(fabs(row(&t, "body.it.v")[UP]) < 1e-6, "it moves by %g m/s", row(&t, "body.it.v")[UP]);
    }
    tank_free(&t);
    near(fmax(fabs(least - at_rest), fabs(most - at_rest)), 0, 1e-9, "range from 2 to 10 s");
}

/* The angle of friction is 19.29 degrees. */
static void friction_holds_below_its_angle(void **state)
{
    struct tank t;

    (void)state;
    begin(&t, 15, BOX("0.075", "softness = 0.1;"));
    tank_run(&t, "cks43", 1e-2, 4);
    const double early = row(&t, "body.it.x")[0];
    near(row(&t, "body.it.v")[0], 0, 1e-9, "creep at 15 degrees");
    tank_free(&t);
    begin(&t, 15, BOX("0.075", "softness = 0.1;"));
    tank_run(&t, "cks43", 1e-2, 8);
    near(row(&t, "body.it.x")[0], early, 1e-9, "stays at 15 degrees");
    near(early, 0, 50e-6, "slip until it sticks");
    tank_free(&t);
}

/* What it gains while friction is being wound up goes down with the softness. */
static void above_it_slides_as_coulomb_says(void **state)
{
    const double a = 9.81 * (sin(M_PI / 6) - 0.35 * cos(M_PI / 6));
    double off[2];

    (void)state;
    for (int i = 0; i < 2; i++) {
        struct tank t;
        begin(&t, 30, i ? BOX("0.075", "softness = 0.03;") : BOX("0.075", "softness = 0.1;"));
        tank_run(&t, "cks43", 1e-2, 1);
        off[i] = row(&t, "body.it.v")[0] - a;
        near(row(&t, "body.it.v")[0], a, 2e-3 * a, "v after 1 s at 30 degrees");
        tank_free(&t);
    }
    check(fabs(off[1]) < 0.6 * fabs(off[0]), "softer is not further off: %g, %g", off[0], off[1]);
}

/* It rolls at 15 degrees; at 60 it slips, and spins up by friction alone. */
static void a_ball_rolls(void **state)
{
    const double inertia = 1 / roll - 1; /* over m R^2 */
    struct tank t;

    (void)state;
    begin(&t, 15, BALL(""));
    tank_run(&t, "cks43", 1e-3, 1);
    near(row(&t, "body.it.v")[0], roll * 9.81 * sin(M_PI / 12), 1e-4, "rolls");
    tank_free(&t);
    begin(&t, 60, BALL(""));
    tank_run(&t, "cks43", 1e-3, 1);
    const double *spin = row(&t, "body.it.spin");
    near(row(&t, "body.it.v")[0], 9.81 * (sin(M_PI / 3) - 0.35 * cos(M_PI / 3)), 1e-4, "slips");
    near(0.1 * (DIM == 2 ? -spin[0] : spin[DIM / 2]), 0.35 * 9.81 * cos(M_PI / 3) / inertia, 1e-4,
         "spins");
    tank_free(&t);
}

/* A turned box is thrown down: its corners hit, rub and turn it; the book closes. */
static void books_close_in_tumbling(void **state)
{
    struct book_sheet first, last;
    struct tank t;

    (void)state;
    for (int i = 0; i < 2; i++) {
        static const double tol[] = { 1e-3, 1e-5 }, bound[] = { 2e-3, 1e-5 };
        const double thrown = 10; /* what it can lose [J], about */
        begin(&t, 10, BOX("0.3", "velocity = " VECTOR("1.0", "0.3", "-1.0") "; angle = "
                          TURNED ";"));
        observe_sheet(t.moment, 0, t.y, &first);
        tank_run(&t, "cks43", tol[i], 1);
        observe_sheet(t.moment, 1, t.y, &last);
        const double *work = t.y + layout_at(&t.plan->layout, t.plan->book.row)
                           + t.plan->book.contacts;
        near(book_defect(&first, &last), 0, bound[i] * thrown, "energy");
        near(book_momentum_defect(&first, &last), 0, 1e-8, "momentum");
        check(work[0] < -0.1 && work[1] < -0.1, "sides take energy: %g, %g J", work[0], work[1]);
        near(work[0] + work[1], last.total - first.total, bound[i] * thrown, "works of sides");
        tank_free(&t);
    }
}

static void overlap_at_the_start_is_refused(void **state)
{
    struct tank t;

    (void)state;
    assert_int_equal(tank_try(&t, PLACE "gravity = " VECTOR("0.0", "0.0", "-9.81") ";"
                              BOX("0.07", "")), STATUS_BAD_SCENE);
    assert_non_null(strstr(status_message(), ") and the bottom of the domain overlap at t = 0: they are 0.005 m inside"));
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(damping_gives_the_restitution),
        cmocka_unit_test(a_ball_bounces),
        cmocka_unit_test(a_corner_bounces_as_a_ball),
        cmocka_unit_test(a_corner_is_booked),
        cmocka_unit_test(a_box_comes_to_rest),
        cmocka_unit_test(friction_holds_below_its_angle),
        cmocka_unit_test(above_it_slides_as_coulomb_says),
        cmocka_unit_test(a_ball_rolls),
        cmocka_unit_test(books_close_in_tumbling),
        cmocka_unit_test(overlap_at_the_start_is_refused),
    };

    return cmocka_run_group_tests_name("rigid-stops", tests, NULL, NULL);
}
