/* body-explicit.c -- tests of the contract of bodies with a kind that has no implicit side:
 * by its members, in a plan, and in a run. */
#include "float.h"
#include "tank-run.h"

#include "../physics/tank.h"
#include "base/status.h"
#include "time/method.h"

#include <math.h>
#include <string.h>

#define FLOAT                                                                            \
    "beam = { it = { at = [0.0625, 0.01]; length = 0.01; mass = 4.0; stiffness = 5e3;"    \
    " lift = 1e-3; }; };"

static void check_close(double found, double expected, double tolerance, const char *what)
{
    if (!(fabs(found - expected) <= tolerance))
        fail_msg("%s: found %.17g, expected %.17g within %g", what, found, expected, tolerance);
}

static const struct float_def def = { .at = { 0.2, 0.3 }, .length = 0.03, .mass = 2,
                                      .stiffness = 50, .lift = 0.01 };
static const struct scales scales = { .dimension = DIM, .dx = 0.01, .g = { 0, -10 },
                                      .low = { 0, 0.1 }, .fluid = true };

struct block {
    struct body *body;
    struct body_work *work;
    struct layout layout;
    double y[4], ydot[4];
};

static void make(struct block *b)
{
    *b = (struct block){ 0 };
    assert_int_equal(float_kind.make.create(&def, &scales, "it", "beam.it", &b->body), 0);
    assert_int_equal(float_kind.make.work(b->body, &b->work), STATUS_DONE);
    layout_add(&b->layout, LAYOUT_POSITION, "others", "m", 1, 1, 1);
    assert_int_equal(float_kind.rows(b->body, &b->layout), STATUS_DONE);
    layout_add(&b->layout, LAYOUT_OTHER, "others too", "J", 1, 1, 1);
    layout_done(&b->layout);
    assert_int_equal(layout_size(&b->layout), 4);
    float_kind.start(b->body, &b->layout, b->y);
}

static void end(struct block *b)
{
    float_kind.make.work_free(&b->work);
    float_kind.make.free(&b->body);
}

static double energy_at(const struct block *b, double s, double v)
{
    const double y[4] = { 0, s, v, 0 };
    struct energies e = { 0 };

    float_kind.energy(b->body, b->work, &b->layout, y, &e);
    return e.kinetic + e.elastic + e.potential;
}

/* q' = v is its own; work on the skin and the named powers are what its energy grows by. */
static void members_agree(void **state)
{
    double x[9][DIM], u[9][DIM], force[9][DIM], power = 0, p[DIM] = { 0 };
    const double h = 1e-4;
    struct body_load load;
    struct block b;

    (void)state;
    make(&b);
    assert_int_equal(float_kind.skin(b.body, x, NULL), 9);
    b.y[2] = 0.3;
    float_kind.move(b.body, b.work, &b.layout, 0, b.y, x, u);
    for (int i = 0; i < 9; i++) {
        force[i][0] = 1 + i;
        force[i][1] = 2 - 0.7 * i;
        power += force[i][0] * u[i][0] + force[i][1] * u[i][1];
    }
    b.ydot[0] = b.ydot[3] = 7;
    float_kind.load(b.body, b.work, &b.layout, 0, b.y, (const double (*)[DIM])force, b.ydot,
                    &load);
    check_close(b.ydot[1], 0.3, 0, "s' = v");
    assert_true(b.ydot[0] == 7 && b.ydot[3] == 7);
    const double up = energy_at(&b, b.y[1] + h * b.ydot[1], b.y[2] + h * b.ydot[2]);
    const double down = energy_at(&b, b.y[1] - h * b.ydot[1], b.y[2] - h * b.ydot[2]);
    check_close((up - down) / (2 * h), power + load.damping + load.driven, 1e-9, "dE/dt");
    float_kind.momentum(b.body, b.work, &b.layout, b.ydot, p);
    check_close(p[1], load.support[1] + (9 * 2 - 0.7 * 36) + float_kind.weight(b.body) * -10,
                1e-12, "dP/dt up");
    check_close(load.support[0], -45, 0, "support along");
    end(&b);
}

static void a_plan_of_it_is_not_stiff(void **state)
{
    struct limit limit[2];
    struct tank t;
    long range[4][2];

    (void)state;
    tank_make(&t, tank_parted_water, TANK_EFFECTS, tank_frame, FLOAT, NULL);
    assert_int_equal(plan_bodies(t.plan), 1);
    assert_false(plan_stiff(t.plan));
    assert_int_equal(moment_stiff_ranges(t.moment, 4, range), 0);
    tank_free(&t);
    tank_make(&t, "dimension = 2; until = 1.0;", FLOAT, NULL);
    for (int stiff = 0; stiff < 2; stiff++) {
        moment_limit(t.moment, 0, t.y, stiff, limit);
        assert_string_equal(limit[0].part, "beam.it");
        check_close(limit[0].rate, sqrt(5e3 / 4.0), 1e-12, "its limit counts always");
    }
    tank_free(&t);
}

/* It has no part in a solve for fluid and bodies together. */
static void an_implicit_viscosity_refuses_it(void **state)
{
    char text[4096] = "";
    struct tank t;

    (void)state;
    strcat(strcat(strcat(text, tank_parted_water), tank_frame), FLOAT);
    strcat(text, "effects = { continuity = { }; pressure = { }; laminar-viscosity = { mu = 0.7;"
                 " side = \"implicit\"; }; };");
    assert_int_equal(tank_try(&t, text), STATUS_BAD_SCENE);
    assert_non_null(strstr(status_message(), "beam.it: a body of kind \"float\" cannot"));
    tank_free(&t);
}

static void all_its_rates_are_explicit(void **state)
{
    struct tank t;

    (void)state;
    tank_make(&t, tank_parted_water, TANK_EFFECTS, tank_frame, FLOAT, NULL);
    tank_shake(&t, 5, 0.1, 0.2, 0.01);
    const long s = tank_at(&t, "beam.it.s", NULL), v = tank_at(&t, "beam.it.s_rate", NULL);
    double *all = test_calloc((size_t)t.n, sizeof *all);
    t.y[v] = 0.25;
    assert_int_equal(moment_eval(t.moment, ASK_ALL, 0, t.y, all), STATUS_DONE);
    check_close(all[s], 0.25, 0, "s' = v");
    assert_int_equal(moment_eval(t.moment, ASK_EXPLICIT_SIDE, 0, t.y, t.ydot), STATUS_DONE);
    assert_memory_equal(all, t.ydot, (size_t)t.n * sizeof *all);
    assert_int_equal(moment_eval(t.moment, ASK_IMPLICIT_SIDE, 0, t.y, t.ydot), STATUS_DONE);
    for (long i = 0; i < t.n; i++)
        check_close(t.ydot[i], 0, 0, "implicit side");
    assert_int_equal(moment_eval(t.moment, ASK_HALF(ASK_VELOCITIES, 0), 0, t.y, t.ydot),
                     STATUS_DONE);
    check_close(t.ydot[s], 0, 0, "halves move nothing");
    check_close(t.ydot[v] / all[v], 1, 1e-12, "rate of velocity in a half");
    assert_int_equal(moment_eval(t.moment, ASK_HALF(ASK_DENSITIES, 0), 0, t.y, t.ydot),
                     STATUS_DONE);
    check_close(t.ydot[s], 0, 0, "halves move nothing");
    check_close(t.ydot[v], 0, 0, "densities push nothing");
    test_free(all);
    tank_free(&t);
}

static const char *const methods[] = { "erk3", "imex3", "dv", "adams", "leapfrog", "ab3" };
enum { METHODS = sizeof methods / sizeof methods[0] };

/* Without water: s = lift cos(omega t), omega^2 = k/m. */
static void it_swings_by_every_method(void **state)
{
    const double omega = sqrt(5e3 / 4.0), until = 4.2 / omega;

    (void)state;
    for (int i = 0; i < METHODS; i++) {
        struct tank t;
        tank_make(&t, "dimension = 2; until = 1.0;", FLOAT, NULL);
        tank_run(&t, methods[i], 1e-5, until);
        check_close(t.y[tank_at(&t, "beam.it.s", NULL)], 1e-3 * cos(4.2), 3e-5, methods[i]);
        tank_free(&t);
    }
}

/* Momentum of water and block is what walls, spring, hold and weight gave. */
static void books_close_in_water(void **state)
{
    (void)state;
    for (int i = 0; i < METHODS; i++) {
        struct book_sheet at_start, s;
        struct tank t;
        tank_make(&t, tank_parted_water, TANK_EFFECTS, tank_frame, FLOAT, NULL);
        observe_sheet(t.moment, 0, t.y, &at_start);
        tank_run(&t, methods[i], 1e-3, 0.02);
        observe_sheet(t.moment, 0.02, t.y, &s);
        assert_true(fabs(t.y[tank_at(&t, "beam.it.s", NULL)] - 1e-3) > 1e-4);
        for (int d = 0; d < DIM; d++)
            check_close(s.momentum[d], s.momentum_given[d], 1e-10, methods[i]);
        double work = s.pressure_defect;
        for (int k = 0; k < s.works; k++)
            work += s.work[k];
        check_close(s.total - at_start.total, work, 2e-4, methods[i]);
        tank_free(&t);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(members_agree),
        cmocka_unit_test(a_plan_of_it_is_not_stiff),
        cmocka_unit_test(an_implicit_viscosity_refuses_it),
        cmocka_unit_test(all_its_rates_are_explicit),
        cmocka_unit_test(it_swings_by_every_method),
        cmocka_unit_test(books_close_in_water),
    };

    return cmocka_run_group_tests_name("body-explicit", tests, NULL, NULL);
}
