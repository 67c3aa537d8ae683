/* rigid.c -- rigid bodies: their members against sums typed anew, their motion against Euler's
 * closed form, and the books of those that water meets. */
#include "../unit/tank-run.h"
#include "tank.h"

#include "base/status.h"
#include "bodies/bodies.h"
#include "bodies/rigid-figure.h"
#include "state/scales.h"
#include "time/method.h"

#include <math.h>
#include <string.h>

enum { POINTS = 4000, SPINS = TURNING_SPINS };

static const struct scales scales = { .dimension = DIM, .dx = 0.01, .support = 0.03, .hs = 0.015,
                                      .rho0 = 1000, .c0 = 20, .speed = 2, .g = { 1, -10, 3 },
                                      .low = { -1, 0.1, 0.2 }, .fluid = true };

struct one {
    struct body *body;
    struct body_work *work;
    struct layout layout;
    int points;
    double y[16], ydot[16];
    double x[POINTS][DIM], u[POINTS][DIM], force[POINTS][DIM];
};

static struct one one;

static void make(struct one *o, const struct rigid_def *def, unsigned seed)
{
    const struct body_kind *kind = &bodies_rigid;

    memset(o, 0, sizeof *o);
    if (kind->make.create(def, &scales, "it", "body.it", &o->body) != STATUS_DONE)
        fail_msg("%s", status_message());
    assert_int_equal(kind->make.work(o->body, &o->work), STATUS_DONE);
    assert_int_equal(kind->rows(o->body, &o->layout), STATUS_DONE);
    layout_done(&o->layout);
    o->points = kind->skin(o->body, NULL, NULL);
    assert_in_range(o->points, 10, POINTS);
    kind->start(o->body, &o->layout, o->y);
    for (long i = 0; i < layout_size(&o->layout); i++)
        o->y[i] += 0.7 * tank_random(&seed);
    kind->move(o->body, o->work, &o->layout, 0, o->y, o->x, o->u);
    for (int i = 0; i < o->points; i++)
        for (int d = 0; d < DIM; d++)
            o->force[i][d] = tank_random(&seed);
}

static void end(struct one *o)
{
    bodies_rigid.make.work_free(&o->work);
    bodies_rigid.make.free(&o->body);
}

static struct body_load load(struct one *o)
{
    struct body_load out;

    bodies_rigid.load(o->body, o->work, &o->layout, 0, o->y, (const double (*)[DIM])o->force,
                      o->ydot, &out);
    return out;
}

static double energy_after(struct one *o, double h)
{
    struct energies e = { 0 };
    double y[16];

    for (int i = 0; i < 16; i++)
        y[i] = o->y[i] + h * o->ydot[i];
    bodies_rigid.energy(o->body, o->work, &o->layout, y, &e);
    return e.kinetic + e.potential;
}

static struct rigid_def box_def(unsigned held)
{
    return (struct rigid_def){ .shape = "box", .at = { 0.3, 0.4, 0.5 }, .size = { 0.1, 0.2, 0.06 },
                               .mass = 3, .angle = { 20, -50, 70 }, .held = held };
}

/* All that a figure of these owns is there after the end of it. */
static struct rigid_figure inertia_of(struct rigid_def def, double *inertia)
{
    struct rigid_figure figure;

    assert_int_equal(rigid_figure_make(&def, "body.it", &figure), STATUS_DONE);
    rigid_figure_inertia(&figure, rigid_figure_mass(&figure, &def), inertia);
    rigid_figure_free(&figure);
    return figure;
}

static struct rigid_def ball_def(void)
{
    return (struct rigid_def){ .shape = DIM == 2 ? "disc" : "sphere", .radius = 0.05,
                               .at = { 0.3, 0.4, 0.5 }, .density = 700 };
}

static void near(double found, double expected, double tolerance, const char *what)
{
    check(fabs(found - expected) <= tolerance, "%s: found %.17g, expected %.17g within %g", what,
          found, expected, tolerance);
}

/* Whatever is held: the power of forces on points and of what holds is what its energy grows by,
 * momentum grows by forces, weight and supports. */
static void work_on_the_skin_is_work_on_the_body(void **state)
{
    (void)state;
    for (unsigned held = 0; held < 2u << DIM; held++) {
        const struct rigid_def box = box_def(held);
        double power = 0, p[DIM] = { 0 };
        make(&one, &box, 7 + held);
        const struct body_load given = load(&one);
        for (int i = 0; i < one.points; i++)
            for (int d = 0; d < DIM; d++)
                power += one.force[i][d] * one.u[i][d];
        const double h = 1e-4, rate = (energy_after(&one, h) - energy_after(&one, -h)) / (2 * h);
        near(rate, power + given.driven + given.damping, 1e-7, "dE/dt");
        bodies_rigid.momentum(one.body, one.work, &one.layout, one.ydot, p);
        for (int d = 0; d < DIM; d++) {
            double sum = given.support[d] + bodies_rigid.weight(one.body) * scales.g[d];
            for (int i = 0; i < one.points; i++)
                sum += one.force[i][d];
            near(p[d], sum, 1e-10, "dP/dt");
            check(!(held & 1u << d) || p[d] == 0, "held direction %d moves", d);
        }
        end(&one);
    }
}

/* Points move as their velocities say, and keep their distances. */
static void points_follow_the_body(void **state)
{
    static double before[POINTS][DIM], after[POINTS][DIM], u[POINTS][DIM];
    const struct rigid_def box = box_def(0);
    const double h = 1e-5;

    (void)state;
    make(&one, &box, 3);
    load(&one);
    for (int k = -1; k <= 1; k += 2) {
        double y[16];
        for (int i = 0; i < 16; i++)
            y[i] = one.y[i] + k * h * one.ydot[i];
        bodies_rigid.move(one.body, one.work, &one.layout, 0, y, k < 0 ? before : after, u);
    }
    const int last = one.points - 1;
    double apart = 0, box2 = 0;
    for (int d = 0; d < DIM; d++) {
        for (int i = 0; i < one.points; i++)
            near((after[i][d] - before[i][d]) / (2 * h), one.u[i][d], 1e-7, "velocity of a point");
        apart += pow(one.x[last][d] - one.x[0][d], 2);
        box2 += pow(box.size[d] - scales.dx, 2); /* corners stand half a spacing inside */
    }
    near(sqrt(apart), sqrt(box2), 1e-12, "corner to corner");
    end(&one);
}

/* Change of momentum about the origin of space is the moment of all forces there:
 * d/dt (M X x V + R I Omega), by differences. */
static void angular_momentum_is_that_of_the_forces(void **state)
{
    const struct rigid_def box = box_def(0);
    const int a = DIM == 2 ? 0 : 1, b = DIM == 2 ? 1 : 2; /* the axis across a and b */
    double l[2], moment = 0, inertia[SPINS], X[2][DIM];

    (void)state;
    inertia_of(box, inertia);
    make(&one, &box, 11);
    load(&one);
    const double h = 1e-5;
    for (int k = 0; k < 2; k++) {
        double y[16], R[DIM][DIM];
        for (int i = 0; i < 16; i++)
            y[i] = one.y[i] + (2 * k - 1) * h * one.ydot[i];
        const double *v = y + layout_at(&one.layout, 2), *spin = y + layout_at(&one.layout, 3);
        memcpy(X[k], y, sizeof X[k]);
        l[k] = 3 * (X[k][a] * v[b] - X[k][b] * v[a]);
        turning_matrix(y + layout_at(&one.layout, 1), R);
        for (int i = 0; i < SPINS; i++)
            l[k] += (DIM == 2 ? 1 : R[0][i % DIM]) * inertia[i] * spin[i];
    }
    for (int i = 0; i < one.points; i++)
        moment += one.x[i][a] * one.force[i][b] - one.x[i][b] * one.force[i][a];
    moment += 3 * (one.y[a] * scales.g[b] - one.y[b] * scales.g[a]);
    near((l[1] - l[0]) / (2 * h), moment, 1e-6 * (1 + fabs(moment)), "dL/dt");
    end(&one);
}

/* A sum over a filled skin is what the formula of inertia integrates, up to 2.1 %: half a point
 * in each of the five rings of a disc. */
static void inertia_is_that_of_its_points(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        struct rigid_def def = k ? ball_def() : box_def(0);
        double inertia[SPINS], sum[SPINS] = { 0 };
        def.layers = 100;
        make(&one, &def, 1);
        const struct rigid_figure figure = inertia_of(def, inertia);
        assert_int_equal(bodies_rigid.skin(one.body, one.x, NULL), one.points);
        for (int i = 0; i < one.points; i++) {
            double r2 = DIM * scales.dx * scales.dx / 12; /* that of its own cell */
            for (int d = 0; d < DIM; d++)
                r2 += pow(one.x[i][d] - def.at[d], 2);
            for (int s = 0; s < SPINS; s++)
                sum[s] += r2 * rigid_figure_mass(&figure, &def) / one.points / (DIM == 2 ? 1 : 1.5);
        }
        double all = 0, found = 0;
        for (int s = 0; s < SPINS; s++) {
            all += inertia[s];
            found += sum[s];
        }
        near(found / all, 1, 0.021, def.shape);
        near(one.points * pow(scales.dx, DIM) / figure.volume, 1, 0.02, "points fill it");
        end(&one);
    }
}

/* --- motion ------------------------------------------------------------------------ */

#if DIM == 3
#define SPIN "[1.0, 0.5, -2.0]"
#define TURNED "[10.0, 20.0, 30.0]"
#define VELOCITY "[1.0, 2.0, 0.5]"
#define WEIGHT "[0.0, 0.0, -9.81]"
#define PLACE "[0.0, 0.0, 0.0]"
#define SIZE "[0.1, 0.2, 0.3]"
static const double flown[3] = { 0.3, 0.6, 0.15 };
#else
#define SPIN "1.5"
#define TURNED "10.0"
#define VELOCITY "[1.0, 2.0]"
#define WEIGHT "[0.0, -9.81]"
#define PLACE "[0.0, 0.0]"
#define SIZE "[0.1, 0.2]"
static const double flown[2] = { 0.3, 0.6 };
#endif

static void a_thrown_body_flies_a_parabola(void **state)
{
    static const char *const methods[] = { "cks43", "adams", "erk3" };

    (void)state;
    for (int i = 0; i < 3; i++) {
        struct book_sheet first, last;
        struct tank t;
        tank_make(&t, DIM == 2 ? "dimension = 2;" : "dimension = 3;",
                  "until = 1.0; gravity = " WEIGHT "; body = { it = { at = " PLACE
                  "; size = " SIZE "; mass = 2.0; velocity = " VELOCITY "; spin = " SPIN
                  "; angle = " TURNED "; }; };", NULL);
        observe_sheet(t.moment, 0, t.y, &first);
        tank_run(&t, methods[i], 1e-6, 0.3);
        observe_sheet(t.moment, 0.3, t.y, &last);
        const double *x = t.y + tank_at(&t, "body.it.x", NULL);
        for (int d = 0; d < DIM; d++)
            near(x[d], flown[d] - (d == DIM - 1 ? 0.5 * 9.81 * 0.09 : 0), 2e-5, methods[i]);
        near(last.total, first.total, 5e-5, methods[i]);
        tank_free(&t);
    }
}

#if DIM == 3

/* Complete elliptic integral and sn, cn, dn by the arithmetic-geometric mean: Abramowitz,
 * Stegun 1965, 16.4. */
static void jacobi(double u, double k2, double *s, double *c, double *d)
{
    double a[20] = { 1 }, m[20] = { sqrt(k2) }, b = sqrt(1 - k2), phi, before;
    int n = 0;

    for (; n < 18 && m[n] > 1e-15; n++) {
        a[n + 1] = 0.5 * (a[n] + b);
        m[n + 1] = 0.5 * (a[n] - b);
        b = sqrt(a[n] * b);
    }
    phi = before = ldexp(a[n] * u, n);
    for (; n > 0; n--) {
        before = phi;
        phi = 0.5 * (phi + asin(m[n] / a[n] * sin(phi)));
    }
    *s = sin(phi);
    *c = cos(phi);
    *d = cos(phi) / cos(before - phi);
}

/* Moments 1 : 2 : 3 and a spin near the middle axis, which turns over again and again:
 * Landau, Lifshitz, Mechanics, 1976, (37.10), for L^2 > 2 E I_2. */
static void it_turns_over_as_euler_says(void **state)
{
    const double I[3] = { 1, 2, 3 }, start[3] = { 5, 0, 5 / sqrt(3) * 1.001 };
    double E2 = 0, L2 = 0, expected[3];
    struct tank t;

    (void)state;
    for (int i = 0; i < 3; i++) {
        E2 += I[i] * start[i] * start[i];
        L2 += I[i] * I[i] * start[i] * start[i];
    }
    /* 12 kg: b^2 + c^2 = 1, a^2 + c^2 = 2, a^2 + b^2 = 3; a plate is the only such box. */
    tank_make(&t, "dimension = 3; until = 30.0; gravity = [0.0, 0.0, 0.0];"
              "body = { it = { at = [0.0, 0.0, 0.0]; mass = 12.0; spin = [5.0, 0.0,"
              " 2.8896382]; size = [1.4142135623730951, 1.0, 1e-5]; }; };", NULL);
    double *spin = t.y + tank_at(&t, "body.it.spin", NULL);
    memcpy(spin, start, sizeof start);
    tank_run(&t, "cks43", 1e-8, 20);
    const double tau = 20 * sqrt((I[2] - I[1]) * (L2 - E2 * I[0]) / (I[0] * I[1] * I[2]));
    const double k2 = (I[1] - I[0]) * (E2 * I[2] - L2) / ((I[2] - I[1]) * (L2 - E2 * I[0]));
    double s, c, d;
    jacobi(tau, k2, &s, &c, &d);
    expected[0] = sqrt((E2 * I[2] - L2) / (I[0] * (I[2] - I[0]))) * c;
    expected[1] = sqrt((E2 * I[2] - L2) / (I[1] * (I[2] - I[1]))) * s;
    expected[2] = sqrt((L2 - E2 * I[0]) / (I[2] * (I[2] - I[0]))) * d;
    double R[3][3], l[3] = { 0 };
    turning_matrix(t.y + tank_at(&t, "body.it.turn", NULL), R);
    for (int i = 0; i < 3; i++) {
        printf("# spin %d: %.9f, by the closed form %.9f\n", i, spin[i], expected[i]);
        for (int j = 0; j < 3; j++)
            l[i] += R[i][j] * I[j] * spin[j];
    }
    for (int i = 0; i < 3; i++) {
        near(spin[i], expected[i], 1e-3, "spin");
        near(l[i], I[i] * start[i], 1e-5, "angular momentum in space");
    }
    tank_free(&t);
}

/* A step of positions by velocities alone turns no quaternion. */
static void methods_that_cannot_turn_it_say_so(void **state)
{
    static const char *const methods[] = { "leapfrog", "dv" };

    (void)state;
    for (int i = 0; i < 2; i++) {
        struct tank t;
        struct method_def def = method_def_default();
        const struct method *m;
        tank_make(&t, "dimension = 3; until = 1.0; body = { it = { at = [0.0, 0.0, 0.0];"
                  " radius = 0.1; shape = \"sphere\"; mass = 2.0; }; };", NULL);
        assert_int_equal(method_find(methods[i], &def, &m), STATUS_DONE);
        assert_non_null(m->serves(t.plan));
        assert_non_null(strstr(m->serves(t.plan), "do not pair up"));
        tank_free(&t);
    }
}

#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(work_on_the_skin_is_work_on_the_body),
        cmocka_unit_test(points_follow_the_body),
        cmocka_unit_test(angular_momentum_is_that_of_the_forces),
        cmocka_unit_test(inertia_is_that_of_its_points),
        cmocka_unit_test(a_thrown_body_flies_a_parabola),
#if DIM == 3
        cmocka_unit_test(it_turns_over_as_euler_says),
        cmocka_unit_test(methods_that_cannot_turn_it_say_so),
#endif
    };

    return cmocka_run_group_tests_name("rigid", tests, NULL, NULL);
}
