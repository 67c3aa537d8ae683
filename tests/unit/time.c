/* time.c -- methods: order, dense output, refusals, limiters, stiffness, bits. */
#include "time-tests.h"

#include "time/control.h"
#include "time/dense.h"
#include "time/stability.h"

static const struct method *found;

const struct method *toy_found(void)
{
    return found;
}

void *toy_method(struct moment *p, const char *name, double tol, double h)
{
    struct method_def def = method_def_default();
    double y[64];
    void *self = NULL;

    status_clear();
    assert_int_equal(method_find(name, &def, &found), STATUS_DONE);
    assert_null(found->serves(moment_plan(p)));
    def.tol = tol;
    toy_exact(p, 0, y);
    if (found->create(found, &def, p, 0, y, &self) != STATUS_DONE)
        fail_msg("%s", status_message());
    if (h > 0 && found == &dv_kind.method) {
        ((struct paced *)self)->def.h_first = 1e9;
        p->wave = 0.95 * 2 / h;
    } else if (h > 0 && found->adaptive) {
        struct arkode *a = self;
        a->def.h_first = 1e9;
        p->wave = 0.95 * a->stable.wave / h;
    } else if (h > 0) {
        p->wave = 0.25 * 1.32 / h; /* SCALES_WAVE, and the default number */
    }
    return self;
}

void toy_method_free(void **self)
{
    found->free(self);
    assert_null(*self);
}

int toy_run(void *self, double t_end, int *steps)
{
    struct method_step step = { .t = 0 };

    *steps = 0;
    while (step.t < t_end) {
        TRY(found->step(self, t_end, &step));
        ++*steps;
        assert_true(step.t <= t_end && step.h > 0);
    }
    assert_true(step.t == t_end);
    return STATUS_DONE;
}

/* --- order --------------------------------------------------------------- */

static double final_error(const char *name, double stiffness, double h)
{
    struct moment p;
    void *self;
    double error;
    int steps;

    toy_make(&p, stiffness, 0.5);
    self = toy_method(&p, name, 1e6, h);
    assert_int_equal(toy_run(self, 2, &steps), STATUS_DONE);
    near(steps, 2 / h, 2.5); /* the steps were what was asked for */
    error = toy_error(&p, 2, found->state(self));
    toy_method_free(&self);
    return error;
}

static void check_order(const char *name, double stiffness, int order, double h)
{
    const double e1 = final_error(name, stiffness, h), e2 = final_error(name, stiffness, h / 2),
                 e4 = final_error(name, stiffness, h / 4);
    const double first = log2(e1 / e2), second = log2(e2 / e4);

    /* small constants may look like one order more, never like one less */
    if (!(e4 > 1e-13 && second > order - 0.25 && second < order + 0.9 && first > order - 0.7))
        fail_msg("%s: errors %.3g %.3g %.3g, orders %.2f %.2f instead of %d", name, e1, e2, e4,
                 first, second, order);
}

static void methods_have_their_order(void **state)
{
    static const struct {
        const char *name;
        int order;
        double h;
    } row[] = { { "imex2", 2, 0.02 },    { "imex3", 3, 0.05 },  { "imex4", 4, 0.1 },
                { "imex5", 5, 0.1 },     { "erk6", 6, 0.2 },
                { "ark436", 4, 0.1 },    { "cks43", 3, 0.05 }, { "opt53", 3, 0.05 },
                { "opt64", 4, 0.1 },     { "bs54", 5, 0.1 },   { "erk2", 2, 0.02 },
                { "erk3", 3, 0.05 },     { "erk4", 4, 0.1 },   { "erk5", 5, 0.1 },
                { "leapfrog", 2, 0.02 }, { "euler-cfl", 1, 0.02 },
                { "staggered", 1, 0.02 }, { "dv", 1, 0.02 },
                { "ARKODE_VERNER_8_5_6", 6, 0.2 } };

    (void)state;
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        check_order(row[i].name, 0, row[i].order, row[i].h);
        check_order(row[i].name, 4, row[i].order, row[i].h);
    }
}

/* Makes a plan that the method serves; those for beams alone: time-beam.c. */
static bool has_a_plan(const struct method *m, struct moment *p)
{
    toy_make(p, 100, 1);
    if (m->serves(moment_plan(p))) /* not with a beam */
        toy_make(p, 0, 0);
    return !m->serves(moment_plan(p));
}

/* Every method of the table runs, and its error follows tol (dv, of order 2: its own
 * test). */
static void all_methods_follow_the_tolerance(void **state)
{
    (void)state;
    for (int i = 0; method_table[i]; i++) {
        double error[2];
        int steps[2];
        struct moment p;
        const bool asked = method_table[i]->adaptive && method_table[i] != &dv_kind.method
                        && has_a_plan(method_table[i], &p);
        for (int k = 0; k < 2 && asked; k++) {
            void *self;
            has_a_plan(method_table[i], &p);
            self = toy_method(&p, method_table[i]->name, k ? 1e-7 : 1e-4, 0);
            assert_int_equal(toy_run(self, 2, &steps[k]), STATUS_DONE);
            error[k] = toy_error(&p, 2, found->state(self));
            assert_true(strlen(found->table(self)) >= 5);
            toy_method_free(&self);
        }
        /* of order 2 with a beam, bdf gains the fewest digits */
        const double fine = strcmp(method_table[i]->name, "bdf") == 0 ? 2e-5 : 1e-5;
        if (asked
            && !(error[0] < 5e-3 && error[1] < fine && error[1] < error[0] / 5))
            fail_msg("%s: errors %g %g, steps %d %d", method_table[i]->name, error[0], error[1],
                     steps[0], steps[1]);
    }
}

/* Rates known already are not asked for again. */
static void right_hand_sides_are_not_wasted(void **state)
{
    static const struct {
        const char *name;
        int a_step;
    } row[] = { { "imex3", 4 }, { "ark436", 6 }, { "cks43", 4 }, { "bs54", 7 }, { "erk3", 3 },
                { "leapfrog", 1 }, { "euler-cfl", 2 }, { "staggered", 2 }, { "dv", 1 },
                { "mri@0.25", 3 }, { "imex2", 3 } };

    (void)state;
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct moment p;
        void *self;
        double y[64];
        struct method_step step;
        int steps;
        toy_make(&p, 4, 0.5);
        self = toy_method(&p, row[i].name, 1e6, 0.05);
        for (steps = 0; steps < 20; steps++) {
            assert_int_equal(found->step(self, 10, &step), STATUS_DONE);
            assert_int_equal(found->at(self, step.t - 0.3 * step.h, y), STATUS_DONE);
        }
        near((double)p.counts.rhs_explicit, 20 * row[i].a_step, 2);
        toy_method_free(&self);
    }
}

/* --- dense output -------------------------------------------------------- */

static double dense_error(const char *name, double h)
{
    struct moment p;
    void *self;
    struct method_step step = { .t = 0 };
    double most = 0;

    toy_make(&p, 4, 0.5);
    self = toy_method(&p, name, 1e6, h);
    for (int k = 0; step.t < 2; k++) {
        double y[64];
        assert_int_equal(found->step(self, 2, &step), STATUS_DONE);
        for (int j = 1; j < 4 && k > 4; j++) {
            const double t = step.t - step.h * j / 4;
            assert_int_equal(found->at(self, t, y), STATUS_DONE);
            most = fmax(most, toy_error(&p, t, y));
        }
    }
    toy_method_free(&self);
    return most;
}

static void dense_output_has_about_the_order(void **state)
{
    static const struct {
        const char *name;
        double order, h;
    } row[] = { { "imex3", 3, 0.05 }, { "imex4", 4, 0.1 },  { "ark436", 4, 0.1 },
                { "bs54", 5, 0.1 },   { "leapfrog", 2, 0.02 }, { "euler-cfl", 1, 0.02 },
                { "staggered", 1, 0.02 }, { "dv", 1, 0.02 }, { "mri@0.25", 3, 0.05 },
                { "imex2", 2, 0.02 } };

    (void)state;
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        const double e2 = dense_error(row[i].name, row[i].h / 2),
                     e4 = dense_error(row[i].name, row[i].h / 4);
        if (!(log2(e2 / e4) > row[i].order - 0.35))
            fail_msg("%s: %g %g, order %.2f", row[i].name, e2, e4, log2(e2 / e4));
    }
}

static void dense_output_meets_the_ends(void **state)
{
    struct moment p;
    double y[64], old[64];
    struct method_step step;
    void *self;

    (void)state;
    toy_make(&p, 4, 0.5);
    self = toy_method(&p, "imex4", 1e-3, 0);
    memcpy(old, found->state(self), sizeof *old * (size_t)moment_size(&p));
    assert_int_equal(found->step(self, 10, &step), STATUS_DONE);
    assert_int_equal(found->at(self, step.t - step.h, y), STATUS_DONE);
    assert_memory_equal(y, old, sizeof *y * (size_t)moment_size(&p));
    assert_int_equal(found->at(self, step.t, y), STATUS_DONE);
    assert_memory_equal(y, found->state(self), sizeof *y * (size_t)moment_size(&p));
    assert_int_equal(found->at(self, step.t + step.h, y), STATUS_FAILED);
    toy_method_free(&self);
}

/* Weights of polynomials that they must reproduce. */
static void interpolants_reproduce_polynomials(void **state)
{
    const double t[3] = { 1.0, 0.7, 0.2 };
    double of_y[3], of_f[3], sum;

    (void)state;
    for (int degree = 0; degree <= 5; degree++) {
        sum = 0;
        dense_hermite(3, t, 0.9, of_y, of_f);
        for (int k = 0; k < 3; k++)
            sum += of_y[k] * pow(t[k], degree)
                 + of_f[k] * (degree > 0 ? degree * pow(t[k], degree - 1) : 0);
        near(sum, pow(0.9, degree), 1e-13);
    }
    assert_int_equal(dense_nodes(3, t), 3);
    assert_int_equal(dense_nodes(3, (const double[]){ 1, 0.5, 0.4 }), 2);
}

/* The same bits, however often one looks. */
static void looking_does_not_change_the_run(void **state)
{
    static const char *const names[] = { "imex3", "ark436", "bs54", "leapfrog", "euler-cfl",
                                         "staggered", "dv", "mri@0.25" };

    (void)state;
    for (int i = 0; i < 8; i++) {
        double final[3][64];
        long rebuilds[3];
        for (int looks = 0; looks < 3; looks++) {
            struct moment p;
            struct method_step step = { .t = 0 };
            double y[64];
            toy_make(&p, 1000, 1);
            p.wave = 20;
            void *self = toy_method(&p, names[i], 1e-5, 0);
            while (step.t < 2) {
                assert_int_equal(found->step(self, 2, &step), STATUS_DONE);
                for (int k = 1; k <= looks * 2 && step.t < 2; k++)
                    assert_int_equal(found->at(self, step.t - step.h / (k + 1), y), 0);
            }
            memset(final[looks], 0, sizeof y);
            memcpy(final[looks], found->state(self), sizeof *y * (size_t)moment_size(&p));
            rebuilds[looks] = p.counts.rebuilds;
            assert_true(rebuilds[looks] > 5);
            toy_method_free(&self);
        }
        assert_memory_equal(final[0], final[1], sizeof final[0]);
        assert_memory_equal(final[0], final[2], sizeof final[0]);
        assert_true(rebuilds[0] == rebuilds[1] && rebuilds[0] == rebuilds[2]);
    }
}

/* --- refusals ------------------------------------------------------------ */

static void a_refusal_shortens_the_step(void **state)
{
    static const char *const names[] = { "imex3", "ark436", "opt53", "bs54", "leapfrog@1" };

    (void)state;
    for (int i = 0; i < 5; i++) {
        struct moment p;
        int steps;
        toy_make(&p, 4, 0.5);
        p.off = i == 4 ? 0.02 : 2e-4;
        p.wave = i == 4 ? 1 : 0;
        void *self = toy_method(&p, names[i], 0.3, 0);
        if (toy_run(self, i == 4 ? 0.66 : 2, &steps) != STATUS_DONE)
            fail_msg("%s: %s", names[i], status_message());
        if (p.counts.refused == 0 || steps < 2 || steps > 2000)
            fail_msg("%s: %ld refusals, %d steps", names[i], p.counts.refused, steps);
        assert_string_equal(status_message(), "");
        toy_method_free(&self);
    }
}

static void a_lasting_refusal_ends_the_run_with_a_message(void **state)
{
    static const char *const names[] = { "imex3", "ark436", "bs54", "leapfrog", "euler-cfl",
                                         "staggered", "dv", "mri@0.25" };

    (void)state;
    for (int i = 0; i < 8; i++) {
        struct moment p;
        int steps;
        toy_make(&p, 4, 0.5);
        p.refuse_after = 1;
        p.wave = 10;
        void *self = toy_method(&p, names[i], 1e-4, 0);
        assert_int_equal(toy_run(self, 2, &steps), STATUS_FAILED);
        if (!strstr(status_message(), "density of particle 0") || !strstr(status_message(), "t = ")
            || !strstr(status_message(), "try") || !status_has_remedy()
            || strlen(status_message()) > 600)
            fail_msg("%s", status_message());
        assert_true(p.counts.rhs_explicit < 3000);
        assert_true(toy_error(&p, 1, found->state(self)) < 0.2); /* the last good state */
        toy_method_free(&self);
    }
}

/* Also where no weight looks: the book is a quadrature. */
static void infinities_in_a_quadrature_are_seen(void **state)
{
    static const char *const names[] = { "imex3", "ark436", "leapfrog", "dv", "mri@0.25" };

    (void)state;
    for (int i = 0; i < 5; i++) {
        struct moment p;
        int steps;
        toy_make(&p, 4, 0.5);
        p.poison_after = 1;
        p.wave = 10;
        void *self = toy_method(&p, names[i], 1e-4, 0);
        assert_int_equal(toy_run(self, 2, &steps), STATUS_FAILED);
        for (long k = 0; k < moment_size(&p); k++)
            assert_true(isfinite(found->state(self)[k]));
        toy_method_free(&self);
    }
}

/* --- limits -------------------------------------------------------------- */

static void steps_say_what_limited_them(void **state)
{
    struct moment p;
    struct method_step step;
    void *self;

    (void)state;
    toy_make(&p, 4, 0.5);
    p.wave = 1000;
    self = toy_method(&p, "ark436", 1e-3, 0);
    for (int k = 0; k < 20; k++)
        assert_int_equal(found->step(self, 10, &step), STATUS_DONE);
    assert_int_equal(step.limiter, METHOD_STABILITY);
    assert_string_equal(step.where, "pressure, particle 1");
    assert_int_equal(step.rejected, 0);
    /* of a beam taken explicitly there is no damping: the imaginary axis counts */
    near(step.h, 0.95 * 4.00 / 1000, 1e-5);
    assert_int_equal(found->step(self, step.t + 1e-5, &step), STATUS_DONE);
    assert_int_equal(step.limiter, METHOD_OUTPUT);
    near(step.h, 1e-5, 1e-12);
    assert_int_equal(found->step(self, 10, &step), STATUS_DONE);
    near(step.h, 0.95 * 4.00 / 1000, 1e-5); /* the short one leaves no trace */
    toy_method_free(&self);

    toy_make(&p, 0, 0);
    p.wave = 1;
    p.decay = 5000;
    self = toy_method(&p, "cks43", 1e-3, 0);
    for (int k = 0; k < 20; k++)
        assert_int_equal(found->step(self, 10, &step), STATUS_DONE);
    assert_string_equal(step.where, "viscosity");
    near(step.h, 0.95 * 2.785 / 5000, 1e-6);
    toy_method_free(&self);

    toy_make(&p, 0, 0);
    p.wave = 0; /* no limit is known */
    self = toy_method(&p, "cks43", 1e-6, 0);
    for (int k = 0; k < 60; k++)
        assert_int_equal(found->step(self, 1e3, &step), STATUS_DONE);
    assert_int_equal(step.limiter, METHOD_ERROR);
    if (!strstr(step.where, "of fluid, number"))
        fail_msg("%s", step.where);
    toy_method_free(&self);
}

static void cfl_numbers_count_in_the_units_of_pressure(void **state)
{
    struct moment p;
    struct method_step step;
    void *self;

    (void)state;
    toy_make(&p, 0, 0);
    p.wave = 1.32 * 400; /* (c0 + v)/hs = 400 */
    self = toy_method(&p, "leapfrog@0.5", 1e-3, 0);
    assert_int_equal(found->step(self, 10, &step), STATUS_DONE);
    near(step.h, 0.5 / 400, 1e-12);
    assert_string_equal(found->table(self), "leapfrog@0.5");
    assert_string_equal(step.where, "pressure, particle 1");
    toy_method_free(&self);
    p.wave = 1.32e-3; /* no sound to speak of: (38), H = 1, accelerations near 1 */
    self = toy_method(&p, "euler-cfl", 1e-3, 0);
    assert_int_equal(found->step(self, 10, &step), STATUS_DONE);
    assert_true(step.h > 0.1 && step.h < 0.41);
    assert_non_null(strstr(step.where, "(38)"));
    toy_method_free(&self);
}

/* (34), (35), and the density from the new velocity. */
static void euler_takes_the_new_velocity(void **state)
{
    struct moment p;
    struct method_step step;
    double y[64], f[64];

    (void)state;
    toy_make(&p, 0, 0);
    void *self = toy_method(&p, "euler-cfl", 1e-3, 0.05);
    const long u = p.layout.from[LAYOUT_VELOCITY], rho = p.layout.from[LAYOUT_OTHER];
    toy_exact(&p, 0, y);
    assert_int_equal(moment_eval(&p, ASK_ALL, 0, y, f), STATUS_DONE);
    assert_int_equal(found->step(self, 10, &step), STATUS_DONE);
    for (long i = u; i < rho; i++)
        y[i] += step.h * f[i];
    assert_int_equal(moment_eval(&p, ASK_ALL, 0, y, f), STATUS_DONE);
    for (long i = 0; i < moment_size(&p); i++) {
        if (i < u || i >= rho)
            y[i] += step.h * (i < u ? y[u + i] : f[i]);
        near(found->state(self)[i], y[i], 1e-12);
    }
    toy_method_free(&self);
}

/* --- the stiff side ------------------------------------------------------ */

static int stiff_steps(const char *name, double stiffness)
{
    struct moment p;
    int steps;

    toy_make(&p, stiffness, 1);
    p.wave = 0;
    void *self = toy_method(&p, name, 1e-4, 0);
    assert_int_equal(toy_run(self, 5, &steps), STATUS_DONE);
    if (!(toy_error(&p, 5, found->state(self)) < 2e-3))
        fail_msg("%s, stiffness %g: error %g", name, stiffness,
                 toy_error(&p, 5, found->state(self)));
    assert_true(p.counts.solves >= 3 * steps);
    toy_method_free(&self);
    return steps;
}

/* The vibration of stiffness 100 is resolved; the stiffer ones are passed over,
 * at the same cost however stiff.  An explicit method would need 1e5 steps. */
static void implicit_steps_do_not_depend_on_stiffness(void **state)
{
    static const char *const names[] = { "imex3", "imex4", "imex5" };

    (void)state;
    for (int i = 0; i < 3; i++) {
        const int soft = stiff_steps(names[i], 1e2), stiff = stiff_steps(names[i], 1e6);
        for (double s = 1e7; s < 2e9; s *= 10)
            if (!(abs(stiff_steps(names[i], s) - stiff) <= stiff / 6))
                fail_msg("%s, stiffness %g", names[i], s);
        assert_true(stiff < 3.2 * soft);
    }
}

/* Between the ends of steps they do not leave the range of these ends by much. */
static void dense_output_of_stiff_entries_is_smooth(void **state)
{
    struct moment p;
    struct method_step step = { .t = 0 };
    double y[64], ends = 0, between = 0;

    (void)state;
    toy_make(&p, 1e8, 1);
    p.wave = 0;
    void *self = toy_method(&p, "imex3", 1e-4, 0);
    while (step.t < 5) {
        const long v = layout_at(&p.layout, p.row_v);
        assert_int_equal(found->step(self, 5, &step), STATUS_DONE);
        ends = fmax(ends, fabs(found->state(self)[v]));
        assert_int_equal(found->at(self, step.t - step.h / 2, y), STATUS_DONE);
        between = fmax(between, fabs(y[v]));
    }
    assert_true(between < 1.5 * ends && ends < 0.01); /* f is 1e8 times the error of q */
    toy_method_free(&self);
}

/* --- restarts and names -------------------------------------------------- */

static void a_restart_forgets_the_past(void **state)
{
    static const char *const names[] = { "imex4", "bs54", "leapfrog", "dv", "mri@0.25" };

    (void)state;
    for (int i = 0; i < 5; i++) {
        struct moment p;
        double y[64], first[64];
        int steps;
        toy_make(&p, 4, 0.5);
        void *self = toy_method(&p, names[i], 1e-5, 0);
        assert_int_equal(toy_run(self, 1, &steps), STATUS_DONE);
        memcpy(first, found->state(self), sizeof *y * (size_t)moment_size(&p));
        toy_exact(&p, 0, y);
        assert_int_equal(found->restart(self, 0, y, NULL), STATUS_DONE);
        assert_memory_equal(found->state(self), y, sizeof *y * (size_t)moment_size(&p));
        p.listed = 0;
        struct method_step step;
        assert_int_equal(found->step(self, 1, &step), STATUS_DONE);
        assert_int_equal(found->at(self, step.h / 2, y), STATUS_DONE);
        assert_true(toy_error(&p, step.h / 2, y) < 0.2 * step.h * step.h);
        assert_int_equal(toy_run(self, 1, &steps), STATUS_DONE);
        assert_memory_equal(first, found->state(self), sizeof *y * (size_t)moment_size(&p));
        toy_method_free(&self);
    }
}

static void names_are_checked(void **state)
{
    struct method_def def = method_def_default();
    const struct method *m;

    (void)state;
    assert_int_equal(method_find("leapfrog@0.125", &def, &m), STATUS_DONE);
    near(def.step, 0.125, 0);
    assert_string_equal(m->name, "leapfrog");
    status_clear();
    assert_int_equal(method_find("imxe3", &def, &m), STATUS_BAD_SCENE);
    assert_non_null(strstr(status_message(), "\"imex3\"?"));
    status_clear();
    assert_int_equal(method_find("imex3@0.5", &def, &m), STATUS_BAD_SCENE);
    assert_non_null(strstr(status_message(), "tol"));
    status_clear();
    assert_int_equal(method_find("leapfrog@fast", &def, &m), STATUS_BAD_SCENE);
    status_clear();
    assert_int_equal(method_find("leapfrog@-1", &def, &m), STATUS_BAD_SCENE);
    status_clear();
    assert_int_equal(method_find("erk4@1e-4s", &def, &m), STATUS_DONE);
    near(def.seconds, 1e-4, 0);
    assert_int_equal(method_find("leapfrog@2e-4s", &def, &m), STATUS_DONE);
    near(def.seconds, 2e-4, 0);
    static const char *const wrong[] = { "erk4@0s", "erk4@-1s", "erk4@s", "erk4@1e-4ss",
                                         "erk4@infs", "dv@1e999s" };
    for (int i = 0; i < 6; i++) {
        assert_int_equal(method_find(wrong[i], &def, &m), STATUS_BAD_SCENE);
        assert_non_null(strstr(status_message(), "number of seconds"));
        status_clear();
    }
    assert_int_equal(method_find("bdf@1e-4s", &def, &m), STATUS_BAD_SCENE);
    assert_non_null(strstr(status_message(), "CVODE chooses"));
    status_clear();
    for (int stiff = 0; stiff < 2; stiff++) {
        struct moment p;
        toy_make(&p, 100 * stiff, 0);
        const char *name = method_default(moment_plan(&p));
        assert_string_equal(name, stiff ? "imex3" : "cks43");
        assert_int_equal(method_find(name, &def, &m), STATUS_DONE);
    }
    for (int i = 0; method_table[i]; i++) {
        assert_int_equal(method_find(method_table[i]->name, &def, &m), STATUS_DONE);
        assert_ptr_equal(m, method_table[i]); /* no name twice */
    }
}

static void the_controller_settles_at_its_aim(void **state)
{
    static const struct control_row row = { { 0.28, -0.23, 0 }, 1, 4, 1.3 };
    struct control c;
    double h = 1e-3;

    (void)state;
    control_start(&c, &row, 3, 2, NULL);
    for (int i = 0; i < 500; i++)
        h = control_next(&c, h, pow(h / 0.05, 3)); /* its error is 1 at 0.05 */
    near(h, 0.05, 1e-4);
    assert_true(control_next(&c, h, 1e30) <= 0.2 * h);
    assert_true(control_next(&c, h, NAN) <= 0.2 * h);
    assert_true(control_next(&c, h, 0) <= 1.3 * h);
    assert_true(control_next(&c, h, 5) < 0.9 * h);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tables_keep_their_order_conditions),
        cmocka_unit_test(stability_factors_are_those_published),
        cmocka_unit_test(stability_factors_of_sundials_tables),
        cmocka_unit_test(halves_of_a_pair_go_together),
        cmocka_unit_test(implicit_tables_are_l_stable),
        cmocka_unit_test(steps_that_follow_a_vibration),
        cmocka_unit_test(interpolants_reproduce_polynomials),
        cmocka_unit_test(the_controller_settles_at_its_aim),
        cmocka_unit_test(names_are_checked),
        cmocka_unit_test(methods_have_their_order),
        cmocka_unit_test(all_methods_follow_the_tolerance),
        cmocka_unit_test(right_hand_sides_are_not_wasted),
        cmocka_unit_test(dense_output_has_about_the_order),
        cmocka_unit_test(dense_output_meets_the_ends),
        cmocka_unit_test(looking_does_not_change_the_run),
        cmocka_unit_test(a_refusal_shortens_the_step),
        cmocka_unit_test(a_lasting_refusal_ends_the_run_with_a_message),
        cmocka_unit_test(infinities_in_a_quadrature_are_seen),
        cmocka_unit_test(steps_say_what_limited_them),
        cmocka_unit_test(cfl_numbers_count_in_the_units_of_pressure),
        cmocka_unit_test(euler_takes_the_new_velocity),
        cmocka_unit_test(staggered_steps_water_and_bodies_in_turn),
        cmocka_unit_test(staggered_counts_its_substeps),
        cmocka_unit_test(staggered_without_bodies_is_euler),
        cmocka_unit_test(staggered_bodies_alone_set_their_step),
        cmocka_unit_test(staggered_steps_do_not_depend_on_stiffness),
        cmocka_unit_test(staggered_bodies_go_straight_between_the_ends),
        cmocka_unit_test(staggered_halves_the_step_while_refused),
        cmocka_unit_test(dv_is_of_order_two_without_dissipation),
        cmocka_unit_test(dv_books_the_work_of_a_kick),
        cmocka_unit_test(dv_is_symmetric_in_time),
        cmocka_unit_test(dv_estimates_its_error),
        cmocka_unit_test(dv_starts_carefully),
        cmocka_unit_test(dv_keeps_waves_and_decay_stable),
        cmocka_unit_test(dv_is_not_disturbed_by_a_short_step),
        cmocka_unit_test(dv_shortens_steps_without_an_answer),
        cmocka_unit_test(dv_steps_do_not_depend_on_stiffness),
        cmocka_unit_test(dv_resolves_vibrations_of_bodies),
        cmocka_unit_test(dv_shows_bodies_under_the_last_load),
        cmocka_unit_test(dv_estimates_the_error_of_bodies),
        cmocka_unit_test(dv_needs_halves),
        cmocka_unit_test(mri_is_of_order_three),
        cmocka_unit_test(mri_keeps_to_substep),
        cmocka_unit_test(mri_resolves_vibrations_of_bodies),
        cmocka_unit_test(mri_passes_over_stiff_bodies),
        cmocka_unit_test(mri_shortens_steps_without_an_answer),
        cmocka_unit_test(mri_says_what_it_cannot_serve),
        cmocka_unit_test(implicit_steps_do_not_depend_on_stiffness),
        cmocka_unit_test(dense_output_of_stiff_entries_is_smooth),
        cmocka_unit_test(a_restart_forgets_the_past),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
