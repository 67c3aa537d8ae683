/* time-dv-tank.c -- the staggered Verlet method "dv" on the program's own water. */
#include "../physics/tank.h"
#include "time-dv.h"

#include "base/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SUMMED                                                                           \
    "walls = \"ghost\"; eos = { tension = false; }; effects = { summation = { };"         \
    " pressure = { }; artificial-viscosity = { alpha = 0.1; }; };"
#define MOVES_ONLY "effects = { continuity = { }; pressure = { }; };"

enum { SEED = 7 };

static const struct method *method;

/* A run on t->y, by steps of length h if not 0. */
static void *run(struct tank *t, const char *name, double tol, double h)
{
    struct method_def def = method_def_default();
    void *self;

    assert_int_equal(method_find(name, &def, &method), STATUS_DONE);
    def.tol = tol;
    def.h_first = h;
    assert_null(method->serves(t->plan));
    if (method->create(method, &def, t->moment, 0, t->y, &self) != STATUS_DONE)
        fail_msg("%s", status_message());
    return self;
}

/* The state at t_end to y. */
static void run_to(struct tank *t, const char *name, double tol, double h, double t_end, double *y)
{
    void *self = run(t, name, tol, h);
    struct method_step step = { .t = 0 };

    while (step.t < t_end) {
        if (method->step(self, t_end, &step) != STATUS_DONE)
            fail_msg("%s", status_message());
        if (h > 0)
            ((struct paced *)self)->choice.h = h;
    }
    memcpy(y, method->state(self), (size_t)t->n * sizeof *y);
    method->free(&self);
}

static void make(struct tank *t, const char *effects)
{
    tank_make(t, tank_water, tank_frame, effects, NULL);
    tank_shake(t, SEED, 0.05, 0.3, 1e-3);
}

/* Largest difference of entries in units of their scales; not of the book's. */
static double far(const struct tank *t, const double *y, const double *z)
{
    const struct layout *l = plan_layout(t->plan);
    double most = 0;

    for (int i = 0; i < l->rows; i++) {
        const struct layout_row *r = &l->row[i];
        for (long k = r->offset; k < r->offset + (long)r->n * r->components; k++)
            most = r->scale > 0 ? fmax(most, fabs(y[k] - z[k]) / r->scale) : most;
    }
    return most;
}

static double order(const char *effects, double *error)
{
    const double end = 4e-3, h = 1e-4;
    struct tank t;

    make(&t, effects);
    double *exact = tank_copy(&t, t.y), *y = tank_copy(&t, t.y), e[2];
    run_to(&t, "bs54", 1e-7, 0, end, exact);
    for (int k = 0; k < 2; k++) {
        run_to(&t, "dv", 1e6, k ? h / 4 : h, end, y);
        e[k] = far(&t, y, exact);
    }
    *error = e[1];
    test_free(exact);
    test_free(y);
    tank_free(&t);
    return log2(e[0] / e[1]) / 2;
}

static void water_moves_with_order_two(void **state)
{
    double error, dissipating;
    const double two = order(MOVES_ONLY, &error), one = order(TANK_EFFECTS, &dissipating);

    (void)state;
    check(error > 1e-7 && two > 1.85 && two < 2.15, "order %g, error %g", two, error);
    check(one > 0.85 && one < 1.9, "with dissipation: order %g, error %g", one, dissipating);
}

/* There and back again. */
static double way_back(const char *effects)
{
    struct tank t;
    double off;

    make(&t, effects);
    struct dv *x = run(&t, "dv", 1, 0);
    void *self = x;
    assert_int_equal(dv_begin(&x->frame), STATUS_DONE);
    dv_steps(x, 40, 2e-4);
    assert_true(far(&t, x->frame.y, t.y) > 0.1);
    assert_int_equal(moment_eval(t.moment, ASK_HALF(ASK_DENSITIES, 0), x->frame.t, x->frame.y, x->d.f[1]),
                     STATUS_DONE);
    dv_steps(x, 40, -2e-4);
    off = far(&t, x->frame.y, t.y);
    method->free(&self);
    tank_free(&t);
    return off;
}

static void water_finds_its_way_back(void **state)
{
    const double off = way_back(MOVES_ONLY);

    (void)state;
    check(off < 1e-9, "%g off", off);
    assert_true(way_back(TANK_EFFECTS) > 1e-3);
}

/* What the book got between two sheets. */
static double given(const struct book_sheet *s, const struct book_sheet *from)
{
    double sum = s->pressure_defect - from->pressure_defect;

    for (int i = 0; i < s->works; i++)
        sum += s->work[i] - from->work[i];
    return sum;
}

/* A kick v += h A, the fluid moving with the mean of both velocities. */
static void the_work_of_a_kick_is_exact(void **state)
{
    const double h = 3e-4;
    struct book_sheet before, after;
    struct tank t;

    (void)state;
    make(&t, TANK_EFFECTS);
    const long u = plan_layout(t.plan)->from[LAYOUT_VELOCITY];
    observe_sheet(t.moment, 0, t.y, &before);
    assert_int_equal(moment_eval(t.moment, ASK_HALF(ASK_VELOCITIES, h / 2), 0, t.y, t.ydot),
                     STATUS_DONE);
    for (long i = 0; i < u; i++)
        t.y[i] += h * (t.y[u + i] + h / 2 * t.ydot[u + i]);
    for (long i = u; i < t.n; i++)
        t.y[i] += h * t.ydot[i];
    observe_sheet(t.moment, 0, t.y, &after);
    const double moved = after.energy.kinetic - before.energy.kinetic + after.energy.potential
                       - before.energy.potential, work = given(&after, &before);
    check(fabs(moved) > 1e-3 && fabs(moved - work) < 1e-10 * fabs(moved), "%.15g J, not %.15g J",
          work, moved);
    tank_free(&t);
}

/* Energy stored from h/2 before a density to h/2 after it, less what the book gets. */
static double swelling(double h)
{
    struct book_sheet before, after;
    struct tank t;
    double off;

    make(&t, TANK_EFFECTS);
    observe_sheet(t.moment, 0, t.y, &before);
    assert_int_equal(moment_eval(t.moment, ASK_HALF(ASK_DENSITIES, h / 2), 0, t.y, t.ydot),
                     STATUS_DONE);
    for (long i = 0; i < t.n; i++)
        t.y[i] += h * t.ydot[i];
    observe_sheet(t.moment, 0, t.y, &after);
    off = after.energy.internal - before.energy.internal - given(&after, &before);
    tank_free(&t);
    return off;
}

static void the_work_of_pressure_is_that_of_the_middle(void **state)
{
    const double coarse = swelling(4e-4), fine = swelling(2e-4);
    const double got = log2(fabs(coarse / fine));

    (void)state;
    check(fabs(fine) > 1e-12 && got > 2.8 && got < 4.2, "%g J and %g J, order %g", coarse, fine,
          got);
}

/* After 0.1 s of sloshing, relative to the energy of motion at the start; that part
 * of it that pressure seems to have made goes to *pressure. */
static double defect(const char *effects, double tol, double *pressure)
{
    struct book_sheet first, last;
    struct tank t;

    make(&t, effects);
    observe_sheet(t.moment, 0, t.y, &first);
    run_to(&t, "dv", tol, 0, 0.1, t.y);
    observe_sheet(t.moment, 0.1, t.y, &last);
    const double off = last.total - first.total - given(&last, &first);
    *pressure = fabs(last.pressure_defect / first.energy.kinetic);
    tank_free(&t);
    return fabs(off / first.energy.kinetic);
}

static void the_book_closes(void **state)
{
    static const char *const effects[] = { TANK_EFFECTS, SUMMED };
    double pressure[2];

    (void)state;
    for (int i = 0; i < 2; i++) {
        const double loose = defect(effects[i], 1e-2, &pressure[0]),
                     tight = defect(effects[i], 1e-5, &pressure[1]);
        check(loose < 0.015 && tight < loose / 20 && pressure[0] < 0.05
              && pressure[1] < pressure[0] / 20, "%s: defects of %g and %g, by pressure %g and %g",
              effects[i], loose, tight, pressure[0], pressure[1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(water_moves_with_order_two),
        cmocka_unit_test(water_finds_its_way_back),
        cmocka_unit_test(the_work_of_a_kick_is_exact),
        cmocka_unit_test(the_work_of_pressure_is_that_of_the_middle),
        cmocka_unit_test(the_book_closes),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
