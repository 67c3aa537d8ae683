/* time-staggered.c -- the partitioned coupling of Toth (2012), (46)-(49). */
#include "time-tests.h"

static const struct method *method;

/* As toy_method(), with a largest step of bodies. */
static void *staggered(struct moment *p, const char *name, double substep)
{
    struct method_def def = method_def_default();
    double y[64];
    void *self = NULL;

    status_clear();
    assert_int_equal(method_find(name, &def, &method), STATUS_DONE);
    assert_null(method->serves(moment_plan(p)));
    def.substep = substep;
    toy_exact(p, 0, y);
    assert_int_equal(method->create(method, &def, p, 0, y, &self), STATUS_DONE);
    return self;
}

static double entry(const struct moment *p, const double *y, int row)
{
    return y[layout_at(&p->layout, row)];
}

/* (34), (35) with the beam of t_n, also where the density looks; (46), (47) with
 * the forces of t_n, three times. */
void staggered_steps_water_and_bodies_in_turn(void **state)
{
    struct moment p;
    struct method_step step;
    double y[64], f[64], q, v;

    (void)state;
    toy_make(&p, 400, 2);
    p.wave = 0.25 * 1.32 / 0.05;
    void *self = staggered(&p, "staggered", 0.02);
    const long u = layout_at(&p.layout, p.row_u), other = p.layout.from[LAYOUT_OTHER];
    toy_exact(&p, 0, y);
    q = entry(&p, y, p.row_q);
    v = entry(&p, y, p.row_v);
    assert_int_equal(moment_eval(&p, ASK_EXPLICIT_SIDE, 0, y, f), STATUS_DONE);
    const double push = entry(&p, f, p.row_v);
    assert_int_equal(method->step(self, 10, &step), STATUS_DONE);
    near(step.h, 0.05, 1e-12);
    for (int i = 0; i < TOY_PARTICLES; i++)
        y[u + i] += step.h * f[u + i];
    assert_int_equal(moment_eval(&p, ASK_EXPLICIT_SIDE, 0, y, f), STATUS_DONE);
    for (int i = 0; i < TOY_PARTICLES; i++) {
        near(method->state(self)[u + i], y[u + i], 1e-14);
        near(method->state(self)[layout_at(&p.layout, p.row_x) + i],
             y[layout_at(&p.layout, p.row_x) + i] + step.h * y[u + i], 1e-14);
    }
    for (long i = other; i < moment_size(&p); i++)
        near(method->state(self)[i], y[i] + step.h * f[i], 1e-14);
    for (int k = 0; k < 3; k++) { /* v of v = v_k + b (push - 400 (q_k + b v) - 2 v) */
        const double b = step.h / 3;
        v = (v + b * (push - 400 * q)) / (1 + 2 * b + 400 * b * b);
        q += b * v;
    }
    near(entry(&p, method->state(self), p.row_q), q, 1e-14);
    near(entry(&p, method->state(self), p.row_v), v, 1e-14);
    method->free(&self);
}

/* (48): always below the limit, and without one a single step. */
void staggered_counts_its_substeps(void **state)
{
    static const struct {
        double substep;
        int steps;
    } row[] = { { 0, 1 }, { 0.6, 1 }, { 0.05 * (1 + 1e-9), 1 }, { 0.05 * (1 - 1e-9), 2 },
                { 0.02, 3 }, { 0.05 / 7.5, 8 } };

    (void)state;
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct moment p;
        struct method_step step;
        toy_make(&p, 4, 0.5);
        p.wave = 0.25 * 1.32 / 0.05;
        void *self = staggered(&p, "staggered", row[i].substep);
        for (int k = 1; k <= 10; k++) {
            assert_int_equal(method->step(self, 10, &step), STATUS_DONE);
            near(step.h, 0.05, 1e-12);
            assert_int_equal(p.counts.solves, k * row[i].steps);
        }
        method->free(&self);
    }
}

static void run_free(const char *name, double y[4][64], double *t)
{
    struct moment p;
    struct method_step step = { .t = 0 };

    toy_make(&p, 0, 0);
    p.wave = 0.25 * 1.32 / 0.03;
    void *self = staggered(&p, name, 1e-3);
    for (int k = 0; k < 4; k++) {
        memset(y[k], 0, sizeof y[k]);
        while (step.t < k + 1)
            assert_int_equal(method->step(self, 10, &step), STATUS_DONE);
        t[k] = step.t;
        if (k % 2)
            assert_int_equal(method->at(self, step.t - 0.4 * step.h, y[k]), STATUS_DONE);
        else
            memcpy(y[k], method->state(self), sizeof y[k][0] * (size_t)moment_size(&p));
    }
    assert_true(p.counts.solves == 0);
    method->free(&self);
}

/* The same bits. */
void staggered_without_bodies_is_euler(void **state)
{
    double y[2][4][64], t[2][4];

    (void)state;
    run_free("euler-cfl", y[0], t[0]);
    run_free("staggered", y[1], t[1]);
    assert_memory_equal(y[0], y[1], sizeof y[0]);
    assert_memory_equal(t[0], t[1], sizeof t[0]);
}

/* Nothing but bodies: `substep` is the step, taken whole; without it that of an
 * explicit method. */
void staggered_bodies_alone_set_their_step(void **state)
{
    struct moment p;
    struct method_step step;

    (void)state;
    toy_make(&p, 1e4, 0);
    strcpy(p.layout.row[p.row_u].name, "nothing"); /* (38) looks at "velocity of ..." */
    p.wave = 0;
    void *self = staggered(&p, "staggered", 1e-3);
    for (int k = 1; k <= 20; k++)
        assert_int_equal(method->step(self, 10, &step), STATUS_DONE);
    assert_int_equal(p.counts.solves, 20);
    near(step.h, 1e-3, 1e-15);
    assert_string_equal(step.where, "substep");
    method->free(&self);
    self = staggered(&p, "staggered@0.5", 0);
    assert_int_equal(method->step(self, 10, &step), STATUS_DONE);
    near(step.h, 0.5 * 1.32 / 100, 1e-12);
    assert_string_equal(step.where, "beam.b, particle 0");
    method->free(&self);
}

/* The stiffer beam costs nothing, where euler-cfl needs a step as short as it. */
void staggered_steps_do_not_depend_on_stiffness(void **state)
{
    (void)state;
    for (double stiffness = 1e2; stiffness < 2e9; stiffness *= 10) {
        struct moment p;
        struct method_step step = { .t = 0 };
        int steps = 0;
        toy_make(&p, stiffness, 1);
        p.wave = 0.25 * 1.32 / 0.01;
        void *self = staggered(&p, "staggered", 0);
        for (; step.t < 2; steps++) {
            assert_int_equal(method->step(self, 2, &step), STATUS_DONE);
            if (step.t < 2)
                assert_string_equal(step.where, "pressure, particle 1");
        }
        assert_in_range(steps, 200, 201);
        assert_true(toy_error(&p, 2, method->state(self)) < 0.05);
        method->free(&self);
    }
}

/* Their rates are not known as a whole. */
void staggered_bodies_go_straight_between_the_ends(void **state)
{
    struct moment p;
    struct method_step step;
    double old[64], y[64];

    (void)state;
    toy_make(&p, 1e4, 1);
    p.wave = 0.25 * 1.32 / 0.05;
    void *self = staggered(&p, "staggered", 0.02);
    for (int k = 0; k < 20; k++) {
        memcpy(old, method->state(self), sizeof *old * (size_t)moment_size(&p));
        assert_int_equal(method->step(self, 10, &step), STATUS_DONE);
        assert_int_equal(method->at(self, step.t - 0.75 * step.h, y), STATUS_DONE);
        for (int i = 0; i < 2; i++) {
            const int row = i ? p.row_v : p.row_q;
            near(entry(&p, y, row), 0.75 * entry(&p, old, row)
                 + 0.25 * entry(&p, method->state(self), row), 1e-15);
        }
    }
    method->free(&self);
}

void staggered_halves_the_step_while_refused(void **state)
{
    struct moment p;
    struct method_step step;

    (void)state;
    toy_make(&p, 4, 0.5);
    p.wave = 0.25 * 1.32 / 0.05;
    p.solvable = 0.02;
    void *self = staggered(&p, "staggered", 0);
    assert_int_equal(method->step(self, 10, &step), STATUS_DONE);
    near(step.h, 0.0125, 1e-12);
    assert_int_equal(step.rejected, 2);
    assert_string_equal(status_message(), "");
    p.solvable = 1e-9;
    assert_int_equal(method->step(self, 10, &step), STATUS_FAILED);
    assert_string_equal(status_message(), "gamma is 0.00078125");
    assert_true(method->state(self)[0] != 0); /* the last good state */
    method->free(&self);
    p.solvable = 0.02; /* shorter ones of bodies need no halving */
    self = staggered(&p, "staggered", 0.02);
    assert_int_equal(method->step(self, 10, &step), STATUS_DONE);
    near(step.h, 0.05, 1e-12);
    assert_int_equal(step.rejected, 0);
    method->free(&self);
}
