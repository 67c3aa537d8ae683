/* rigid-joints.c -- rigid bodies that are held by joints, driven or pulled by springs: books of
 * rates, and motions that have closed forms. */
#include "../unit/tank-run.h"
#include "tank.h"

#include "base/status.h"
#include "bodies/bodies.h"
#include "bodies/rigid-def.h"
#include "state/scales.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { POINTS = 4000, SPINS = TURNING_SPINS, NUMBERS = 24, UP = DIM - 1 };

static const struct scales scales = { .dimension = DIM, .dx = 0.01, .support = 0.03, .hs = 0.015,
                                      .rho0 = 1000, .c0 = 20, .speed = 2, .g = { 1, -10, 3 },
                                      .low = { -1, 0.1, 0.2 }, .fluid = true };

struct one {
    struct body *body;
    struct body_work *work;
    struct layout layout;
    int points;
    double y[NUMBERS], ydot[NUMBERS];
    double x[POINTS][DIM], u[POINTS][DIM], force[POINTS][DIM];
};

static struct one one;

static void near(double found, double expected, double tolerance, const char *what)
{
    check(fabs(found - expected) <= tolerance, "%s: found %.17g, expected %.17g within %g", what,
          found, expected, tolerance);
}

static void make(struct one *o, const struct rigid_def *def, unsigned seed)
{
    memset(o, 0, sizeof *o);
    if (bodies_rigid.make.create(def, &scales, "it", "body.it", &o->body) != STATUS_DONE)
        fail_msg("%s", status_message());
    assert_int_equal(bodies_rigid.make.work(o->body, &o->work), STATUS_DONE);
    assert_int_equal(bodies_rigid.rows(o->body, &o->layout), STATUS_DONE);
    layout_done(&o->layout);
    o->points = bodies_rigid.skin(o->body, NULL, NULL);
    assert_in_range(o->points, 10, POINTS);
    bodies_rigid.start(o->body, &o->layout, o->y);
    for (long i = 0; i < layout_size(&o->layout); i++)
        o->y[i] += 0.5 + 0.4 * tank_random(&seed); /* time stays above 0 */
    bodies_rigid.move(o->body, o->work, &o->layout, 0, o->y, o->x, o->u);
    for (int i = 0; i < o->points; i++)
        for (int d = 0; d < DIM; d++)
            o->force[i][d] = tank_random(&seed);
}

static void end(struct one *o)
{
    bodies_rigid.make.work_free(&o->work);
    bodies_rigid.make.free(&o->body);
}

/* A change of all there is with time, along ydot; four points, so to the fourth order. */
struct rates {
    double energy, momentum[DIM], x[POINTS][DIM];
};

static struct rates rates;

static void differ(struct one *o)
{
    static const double weight[4] = { 1, -8, 8, -1 }, place[4] = { -2, -1, 1, 2 };
    static double x[POINTS][DIM], u[POINTS][DIM];
    const double h = 5e-4;

    memset(&rates, 0, sizeof rates);
    for (int k = 0; k < 4; k++) {
        const double share = weight[k] / (12 * h);
        struct energies e = { 0 };
        double y[NUMBERS], p[DIM] = { 0 };
        for (int i = 0; i < NUMBERS; i++)
            y[i] = o->y[i] + place[k] * h * o->ydot[i];
        bodies_rigid.energy(o->body, o->work, &o->layout, y, &e);
        bodies_rigid.momentum(o->body, o->work, &o->layout, y, p);
        bodies_rigid.move(o->body, o->work, &o->layout, 0, y, x, u);
        rates.energy += share * (e.kinetic + e.potential + e.elastic);
        for (int d = 0; d < DIM; d++)
            rates.momentum[d] += share * p[d];
        for (int i = 0; i < o->points; i++)
            for (int d = 0; d < DIM; d++)
                rates.x[i][d] += share * x[i][d];
    }
}

enum { HINGE = 1, SLIDER = 2, MOTION = 4, SPRING = 8 };

static struct rigid_def tied(unsigned what)
{
    struct rigid_def d = { .shape = "box", .at = { 0.3, 0.4, DIM == 3 ? 0.5 : 0 },
                           .size = { 0.1, 0.2, 0.06 }, .mass = 3, .angle = { 20, -50, 70 } };
    struct rigid_ties *t = &d.ties;

    t->hinges = (what & HINGE) > 0;
    t->hinge = (struct rigid_hinge){ .at = { 0.1, 0.2, 0.7 }, .axis = { DIM == 3, DIM == 3 ? 2 : 0, DIM == 3 ? -0.5 : 0 } };
    if (what & SPRING && what & HINGE) {
        t->hinge.stiffness = 2;
        t->hinge.damping = 0.3;
    }
    t->sliders = (what & SLIDER) > 0;
    t->slider.along[0] = 3;
    t->slider.along[UP] = -1;
    t->motions = (what & MOTION) > 0;
    t->motion = (struct motion){ .velocity = { 0.3, -0.2, 0.1 }, .amplitude = { 0.2, 0.4, 0.1 },
                                 .frequency = 0.6, .phase = 30, .stop = 1e6, .spin = 25,
                                 .swing = 12, .pivot = { 0.5, -0.3, 0.2 } };
    t->springs = what & SPRING ? 3 : 0;
    t->spring[0] = (struct rigid_spring){ .name = "a", .on = { 0.32, 0.45, 0.5 }, .rest = NAN,
                                          .to = { 1, 1, 1 }, .stiffness = 7, .damping = 0.4 };
    t->spring[1] = (struct rigid_spring){ .name = "b", .on = { 0.25, 0.4, 0.5 }, .rest = 0.01,
                                          .to = { -1, 0, 1 }, .stiffness = 5, .damping = 0.2,
                                          .slack = true };
    t->spring[2] = (struct rigid_spring){ .name = "c", .on = { 0.25, 0.4, 0.5 }, .rest = 9,
                                          .to = { -1, 0, 1 }, .stiffness = 5, .slack = true };
    return d;
}

/* However it is held, driven and pulled: work on the skin, of what drives it and of dampers is
 * what its energy grows by; forces, weight and supports are what its momentum grows by; points
 * move as their velocities say. */
static void books_of_rates_close(void **state)
{
    double worst[3] = { 0 };

    (void)state;
    for (unsigned what = 1; what < 16; what++) {
        const struct rigid_def d = tied(what);
        struct body_load given;
        double power = 0;
        if ((what & (HINGE | SLIDER)) == (HINGE | SLIDER))
            continue;
        make(&one, &d, what);
        bodies_rigid.load(one.body, one.work, &one.layout, 0, one.y,
                          (const double (*)[DIM])one.force, one.ydot, &given);
        differ(&one);
        for (int i = 0; i < one.points; i++)
            for (int k = 0; k < DIM; k++) {
                power += one.force[i][k] * one.u[i][k];
                worst[2] = fmax(worst[2], fabs(rates.x[i][k] - one.u[i][k]));
            }
        assert_true(given.damping <= 0);
        assert_true((given.damping < 0) == ((what & SPRING) > 0));
        assert_true((given.driven != 0) == ((what & MOTION) > 0));
        worst[0] = fmax(worst[0], fabs(rates.energy - power - given.driven - given.damping));
        for (int k = 0; k < DIM; k++) {
            double sum = given.support[k] + 3 * scales.g[k];
            for (int i = 0; i < one.points; i++)
                sum += one.force[i][k];
            worst[1] = fmax(worst[1], fabs(rates.momentum[k] - sum));
        }
        end(&one);
    }
    printf("# power %g W, force %g N, velocity %g m/s\n", worst[0], worst[1], worst[2]);
    near(worst[0], 0, 5e-10, "power");
    near(worst[1], 0, 5e-10, "force");
    near(worst[2], 0, 2e-10, "velocity of points");
}

/* Without forces on the skin the power that moves a point of a body that is driven is known:
 * the pose of a wall that moves the same. */
static void a_driven_body_goes_where_a_wall_goes(void **state)
{
    struct rigid_def d = tied(MOTION);
    struct motion_place p;
    double x0[POINTS][DIM], x[DIM], u[DIM], worst = 0;

    (void)state;
    make(&one, &d, 5);
    bodies_rigid.skin(one.body, x0, NULL);
    motion_at(&d.ties.motion, one.y[0], &p);
    for (int i = 0; i < one.points; i++) {
        motion_point(&d.ties.motion, &p, x0[i], x, u);
        for (int k = 0; k < DIM; k++)
            worst = fmax(worst, fmax(fabs(x[k] - one.x[i][k]), fabs(u[k] - one.u[i][k])));
    }
    printf("# %g m or m/s from there\n", worst);
    near(worst, 0, 1e-14, "place or velocity");
    end(&one);
}

/* --- motions with closed forms ----------------------------------------------------- */

#if DIM == 2
#define SPACE "dimension = 2; gravity = [0.0, -9.81];"
#define V(x, up) "[" #x ", " #up "]"
#define SIZE "[0.5, 0.02]"
#define AXIS
#define TILTED
#else
#define SPACE "dimension = 3; gravity = [0.0, 0.0, -9.81];"
#define V(x, up) "[" #x ", 0.0, " #up "]"
#define SIZE "[0.5, 0.1, 0.02]"
#define AXIS "axis = [0.0, -2.0, 0.0];"
#define TILTED "axis = [1.0, 1.0, 0.3];"
#endif

static double inertia(void) /* of 1 kg about one end */
{
    return (0.25 + 0.0004) / 12 + 0.0625;
}

/* Quarter of a period over sqrt(I/(M g L)): Abramowitz, Stegun 1965, 17.6. */
static double elliptic(double k)
{
    double a = 1, b = sqrt(1 - k * k);

    for (int i = 0; i < 12; i++) {
        const double mean = 0.5 * (a + b);
        b = sqrt(a * b);
        a = mean;
    }
    return acos(-1) / (2 * a);
}

/* Let go level: after ten periods it is back, at rest. */
static void a_pendulum_keeps_the_time_of_the_elliptic_integral(void **state)
{
    const double quarter = elliptic(sqrt(0.5)) * sqrt(inertia() / (9.81 * 0.25));
    struct tank t;

    (void)state;
    for (int i = 0; i < 2; i++) {
        tank_make(&t, SPACE "until = 100.0; body = { it = { at = " V(0.25, 0.0) "; size = " SIZE
                  "; mass = 1.0; hinge = { at = " V(0.0, 0.0) "; " AXIS " }; }; };", NULL);
        tank_run(&t, "cks43", 1e-9, (i ? 41 : 40) * quarter);
        const double q = t.y[tank_at(&t, "body.it.turned", NULL)];
        const double rate = t.y[tank_at(&t, "body.it.turning", NULL)];
        const double fast = sqrt(2 * 9.81 * 0.25 / inertia());
        printf("# after %d quarters: %.3g rad, %.3g rad/s\n", i ? 41 : 40, q, rate);
        near(q, i ? -acos(-1) / 2 : 0, 1e-5, "angle");
        near(rate, i ? -fast : 0, 1e-5, "rate of turning");
        tank_free(&t);
    }
}

/* 100 s about a tilted axis, with coarse steps: the joint is where it was, to rounding. */
static void a_hinge_does_not_drift(void **state)
{
    struct body_pose pose = { 0 };
    struct tank t;
    double before = 0, after = 0;

    (void)state;
    tank_make(&t, SPACE "until = 101.0; body = { it = { at = " V(0.25, 0.1) "; size = " SIZE
              "; mass = 1.0; hinge = { at = " V(0.0, 0.0) ";"
              TILTED " }; }; };", NULL);
    for (int i = 0; i < 2; i++) {
        double *to = i ? &after : &before;
        observe_pose(t.moment, 0, t.y, &pose);
        for (int d = 0; d < DIM; d++)
            *to += pose.x[d] * pose.x[d];
        if (i == 0)
            tank_run(&t, "cks43", 1e-2, 100);
    }
    printf("# length from the hinge %.17g m, was %.17g m\n", sqrt(after), sqrt(before));
    near(sqrt(after), sqrt(before), 1e-15, "length from the hinge");
    tank_free(&t);
}

/* A bead on a spoke that turns by w: r = r_0 cosh(w t), and its drive gives 2 M w^2 r r'. */
static void a_bead_flies_off_a_spoke(void **state)
{
    const double w = 2, t_end = 1, r_0 = 0.2;
    const double r = r_0 * cosh(w * t_end), v = r_0 * w * sinh(w * t_end);
    struct book_sheet first, last;
    struct tank t;

    (void)state;
    tank_make(&t, DIM == 2 ? "dimension = 2;" : "dimension = 3;", "until = 2.0; gravity = "
              V(0.0, 0.0) "; body = { it = { at = " V(0.2, 0.0) "; size = " SIZE "; mass = 1.0;"
              " slider = { along = " V(1.0, 0.0) "; }; motion = { spin = 114.59155902616465; };"
              " }; };", NULL);
    observe_sheet(t.moment, 0, t.y, &first);
    tank_run(&t, "cks43", 1e-9, t_end);
    observe_sheet(t.moment, t_end, t.y, &last);
    near(r_0 + t.y[tank_at(&t, "body.it.slid", NULL)], r, 1e-6, "radius");
    near(t.y[tank_at(&t, "body.it.sliding", NULL)], v, 1e-6, "speed");
    near(last.energy.kinetic - first.energy.kinetic,
         0.5 * (v * v + w * w * (r * r - r_0 * r_0)), 1e-6, "energy");
    near(book_defect(&first, &last), 0, 1e-6, "energy that nothing gave");
    tank_free(&t);
}

/* theta'' of a pendulum whose hinge is shaken up and down, typed anew. */
static double shaken(double t, double theta)
{
    const double w = 2 * acos(-1) * 2, up = -0.1 * w * w * sin(w * t);

    return -0.25 * (9.81 + up) * cos(theta) / inertia();
}

static void a_pendulum_feels_its_hinge_shaken(void **state)
{
    const double h = 1e-4;
    double theta = 0, rate = 0;
    struct tank t;

    (void)state;
    tank_make(&t, SPACE "until = 2.0; body = { it = { at = " V(0.25, 0.0) "; size = " SIZE
              "; mass = 1.0; hinge = { at = " V(0.0, 0.0) "; " AXIS " }; motion = { amplitude = "
              V(0.0, 0.1) "; frequency = 2.0; }; }; };", NULL);
    tank_run(&t, "cks43", 1e-9, 1);
    for (int i = 0; i < 10000; i++) { /* Runge-Kutta-Nystrom */
        const double s = i * h, k1 = shaken(s, theta);
        const double k2 = shaken(s + h / 2, theta + h / 2 * rate + h * h / 8 * k1);
        const double k3 = shaken(s + h, theta + h * rate + h * h / 2 * k2);
        theta += h * rate + h * h / 6 * (k1 + 2 * k2);
        rate += h / 6 * (k1 + 4 * k2 + k3);
    }
    printf("# %.9f rad, by another integration %.9f\n", t.y[tank_at(&t, "body.it.turned", NULL)],
           theta);
    near(t.y[tank_at(&t, "body.it.turned", NULL)], theta, 1e-6, "angle");
    near(t.y[tank_at(&t, "body.it.turning", NULL)], rate, 1e-5, "rate of turning");
    tank_free(&t);
}

/* k = 200, c = 4, M = 2: x = e^{-t} (cos w t + sin(w t)/w) x_0, w = sqrt(99); at right angles a
 * line that hangs through and gives nothing. */
static void a_spring_swings_and_its_damper_takes(void **state)
{
    const double w = sqrt(99), t_end = 1;
    const double x = 0.1 * exp(-t_end) * (cos(w * t_end) + sin(w * t_end) / w);
    struct book_sheet first, last;
    struct body_pose pose;
    struct tank t;

    (void)state;
    tank_make(&t, DIM == 2 ? "dimension = 2;" : "dimension = 3;", "until = 2.0; gravity = "
              V(0.0, 0.0) "; body = { it = { at = " V(1.1, 0.0) "; size = " SIZE "; mass = 2.0;"
              " spring = { one = { on = " V(1.1, 0.0) "; to = " V(0.0, 0.0) "; stiffness = 200.0;"
              " damping = 4.0; rest = 1.0; }; line = { on = " V(1.1, 0.0) "; to = " V(1.1, 1.0)
              "; stiffness = 1e3; rest = 1.05; slack = true; }; }; }; };", NULL);
    observe_sheet(t.moment, 0, t.y, &first);
    near(first.energy.elastic, 1, 1e-12, "energy of the spring");
    tank_run(&t, "cks43", 1e-8, t_end);
    observe_sheet(t.moment, t_end, t.y, &last);
    observe_pose(t.moment, 0, t.y, &pose);
    near(pose.x[0] - 1, x, 1e-6, "length of the spring");
    near(pose.support[0], -200 * (pose.x[0] - 1) - 4 * pose.v[0], 1e-9, "force of the spring");
    near(book_defect(&first, &last), 0, 1e-6, "energy that nothing gave");
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(books_of_rates_close),
        cmocka_unit_test(a_driven_body_goes_where_a_wall_goes),
        cmocka_unit_test(a_pendulum_keeps_the_time_of_the_elliptic_integral),
        cmocka_unit_test(a_hinge_does_not_drift),
        cmocka_unit_test(a_bead_flies_off_a_spoke),
        cmocka_unit_test(a_pendulum_feels_its_hinge_shaken),
        cmocka_unit_test(a_spring_swings_and_its_damper_takes),
    };

    return cmocka_run_group_tests_name("rigid-joints", tests, NULL, NULL);
}
