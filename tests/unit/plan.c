/* plan.c -- what a plan promises beside its physics: sizes, offsets, the split of
 * its two sides, memory. */
#include "../physics/tank.h"

#include "base/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The linker sends all calls of the libraries through these (-Wl,--wrap). */
static long taken;

void *__real_malloc(size_t size);
void *__real_calloc(size_t n, size_t size);
void *__real_realloc(void *old, size_t size);
void *__real_aligned_alloc(size_t to, size_t size);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t n, size_t size);
void *__wrap_realloc(void *old, size_t size);
void *__wrap_aligned_alloc(size_t to, size_t size);

void *__wrap_malloc(size_t size)
{
    taken++;
    return __real_malloc(size);
}

void *__wrap_calloc(size_t n, size_t size)
{
    taken++;
    return __real_calloc(n, size);
}

void *__wrap_realloc(void *old, size_t size)
{
    taken++;
    return __real_realloc(old, size);
}

void *__wrap_aligned_alloc(size_t to, size_t size)
{
    taken++;
    return __real_aligned_alloc(to, size);
}

static void check_memory(const char *effects)
{
    struct tank t;
    long before;

    before = taken;
    tank_make(&t, DIM == 2 ? tank_parted_water : tank_bare_water, tank_frame,
              DIM == 2 ? tank_beam : "", TANK_ONE_KERNEL, effects, NULL);
    check(taken > before + 10, "the counter does not count");
    tank_rates(&t, 0, t.y, t.ydot);
    before = taken;
    for (unsigned seed = 1; seed <= 20; seed++) {
        tank_shake(&t, seed, 0.003, 0.1, 0.001);
        tank_rates(&t, 0, t.y, t.ydot);
    }
    check(moment_counts(t.moment)->rebuilds == 1, "%ld rebuilds", moment_counts(t.moment)->rebuilds);
    check(taken == before, "%ld times in 20 right-hand sides", taken - before);
    for (unsigned seed = 1; seed <= 40; seed++) { /* rebuilds, and back again */
        tank_shake(&t, seed, 0.2, 0.1, 0.0);
        tank_rates(&t, 0, t.y, t.ydot);
    }
    before = taken;
    for (unsigned seed = 1; seed <= 10; seed++)
        tank_rates(&t, 0, t.y, t.ydot);
    check(taken == before, "%ld times in 10 right-hand sides after rebuilds", taken - before);
    tank_free(&t);
}

static void right_hand_side_takes_no_memory(void **state)
{
    (void)state;
    check_memory(TANK_EFFECTS);
    check_memory(TANK_SUMMED "eos = { tension = false; };");
    check_memory("walls = \"adami\";" TANK_EFFECTS "eos = { tension = false; };");
}

static void sides_add_up(void **state)
{
    struct tank t;
    double *explicit_side, *implicit_side;
    long beam_rows = 0;

    (void)state;
    tank_make(&t, DIM == 2 ? tank_parted_water : tank_water, tank_frame,
              DIM == 2 ? tank_beam : "", TANK_EFFECTS, NULL);
    tank_shake(&t, 5, 0.2, 1, 0.02);
    explicit_side = tank_copy(&t, t.y);
    implicit_side = tank_copy(&t, t.y);
    assert_int_equal(moment_eval(t.moment, ASK_EXPLICIT_SIDE, 0.1, t.y, explicit_side), 0);
    assert_int_equal(moment_eval(t.moment, ASK_IMPLICIT_SIDE, 0.1, t.y, implicit_side), 0);
    assert_int_equal(moment_eval(t.moment, ASK_ALL, 0.1, t.y, t.ydot), 0);
    for (long i = 0; i < t.n; i++) {
        const bool beam = strncmp(moment_entry(t.moment, i), "beam.", 5) == 0;
        check(t.ydot[i] == explicit_side[i] + implicit_side[i], "%s: %g + %g is not %g",
              moment_entry(t.moment, i), explicit_side[i], implicit_side[i], t.ydot[i]);
        check(beam || implicit_side[i] == 0, "%s has an implicit side", moment_entry(t.moment, i));
        beam_rows += implicit_side[i] != 0;
    }
    check((beam_rows > 0) == (DIM == 2), "%ld entries have an implicit side", beam_rows);
    check(moment_counts(t.moment)->rhs_explicit == 2 && moment_counts(t.moment)->rhs_implicit == 1,
          "%ld explicit and %ld implicit sides", moment_counts(t.moment)->rhs_explicit,
          moment_counts(t.moment)->rhs_implicit);
    test_free(explicit_side);
    test_free(implicit_side);
    tank_free(&t);
}

#if DIM == 2
/* z - gamma f_I(z) = r, and nothing else is touched. */
static void solve_inverts_the_implicit_side(void **state)
{
    const double gamma[] = { 1e-7, 1e-4, 1 };
    long range[16][2];
    struct tank t;

    (void)state;
    tank_make(&t, tank_parted_water, tank_frame, tank_beam, TANK_EFFECTS, NULL);
    assert_true(plan_stiff(t.plan));
    assert_int_equal(moment_stiff_ranges(t.moment, 16, range), 4);
    for (int g = 0; g < 3; g++) {
        double *r, *z;
        tank_shake(&t, 5 + g, 0.2, 1, 0.0);
        r = tank_copy(&t, t.y);
        z = tank_copy(&t, t.y);
        assert_int_equal(moment_solve(t.moment, 0, gamma[g], r, z), 0);
        assert_int_equal(moment_eval(t.moment, ASK_IMPLICIT_SIDE, 0, z, t.ydot), 0);
        for (long i = 0; i < t.n; i++) {
            const double left = z[i] - gamma[g] * t.ydot[i];
            const double size = fabs(z[i]) + gamma[g] * fabs(t.ydot[i]) + 1;
            check(fabs(left - r[i]) < 1e-8 * size, "%s: %g is not %g at gamma = %g",
                  moment_entry(t.moment, i), left, r[i], gamma[g]);
            check(strncmp(moment_entry(t.moment, i), "beam.", 5) == 0 || z[i] == r[i],
                  "%s is touched", moment_entry(t.moment, i));
        }
        test_free(r);
        test_free(z);
    }
    tank_free(&t);
}
#endif

/* Positions, velocities, the rest; nothing twice, nothing left out. */
static void rows_fill_the_state(void **state)
{
    const struct layout_row *r;
    const struct layout *l;
    const struct particles *p;
    struct tank t;
    long next = 0;
    int n;

    (void)state;
    tank_make(&t, tank_water, tank_frame, TANK_EFFECTS, NULL);
    l = plan_layout(t.plan);
    p = plan_particles(t.plan);
    n = particles_count(p, KIND_FLUID);
    assert_int_equal(n, DIM == 2 ? 20 * 12 : 5 * 5 * 6);
    for (int c = 0; c < LAYOUT_CLASSES; c++)
        for (int i = 0; i < l->rows; i++)
            if ((int)l->row[i].what == c) {
                assert_int_equal(l->row[i].offset, next);
                next += (long)l->row[i].n * l->row[i].components;
            }
    assert_int_equal(next, t.n);
    assert_int_equal(tank_at(&t, "position of fluid", &r), 0);
    assert_int_equal(tank_at(&t, "velocity of fluid", NULL), n * DIM);
    assert_int_equal(tank_at(&t, "density of walls", NULL), 2 * n * DIM);
    assert_int_equal(tank_at(&t, "density of fluid", NULL), 2 * n * DIM + p->n - n);
    tank_at(&t, "book", &r); /* four laws, walls, impulses of water and tank */
    assert_int_equal(r->n, 5 + 1 + 2 * DIM);
    assert_int_equal(t.n, 2 * n * DIM + p->n + r->n);
    tank_free(&t);
}

static int row_of(const struct tank *t, const char *name)
{
    const struct layout *l = plan_layout(t->plan);

    for (int i = 0; i < l->rows; i++)
        if (strcmp(l->row[i].name, name) == 0)
            return i;
    return -1;
}

/* A scene pays for the effects that it names: one column of the book each. */
static void effect_left_out_costs_nothing(void **state)
{
    const char *const less = "effects = { continuity = { }; pressure = { };"
                             " density-diffusion = { delta = 0.1; }; };";
    char name[BOOK_WORKS][80];
    struct tank all, few;
    const struct layout *a, *b;

    (void)state;
    tank_make(&all, tank_water, tank_frame, TANK_EFFECTS, NULL);
    tank_make(&few, tank_water, tank_frame, less, NULL);
    a = plan_layout(all.plan);
    b = plan_layout(few.plan);
    assert_int_equal(all.n - few.n, 2); /* two viscosities, a number each */
    assert_int_equal(a->rows, b->rows);
    for (int i = 0; i < b->rows; i++) {
        assert_int_equal(row_of(&all, b->row[i].name), i);
        assert_int_equal(a->row[i].offset, b->row[i].offset);
    }
    assert_int_equal(plan_parts(all.plan) - plan_parts(few.plan), 2);
    assert_int_equal(book_work_names(few.plan, name), 2);
    assert_string_equal(name[0], "density-diffusion");
    assert_string_equal(name[1], "walls");
    tank_free(&all);
    tank_free(&few);
}

/* Without gravity there is no such effect; without walls no density of theirs. */
/* What a pressure that is solved for must know first: all rates but by pressure are those of
 * the scene without that effect, bit by bit; with it they are others. */
static void all_but_pressure_can_be_asked_for(void **state)
{
    static const char *const effects[] = {
        TANK_EFFECTS,
        "effects = { continuity = { }; artificial-viscosity = { alpha = 0.1; };"
        " laminar-viscosity = { mu = 0.7; }; density-diffusion = { delta = 0.1; }; };",
    };
    struct tank t[2];
    double *whole;
    struct ask ask = ASK_ALL;

    (void)state;
    for (int i = 0; i < 2; i++) {
        tank_make(&t[i], tank_bare_water, tank_frame, TANK_ONE_KERNEL,
                  "walls = \"own-density\"; " /* not one with a pressure of its own */, effects[i],
                  NULL);
        tank_shake(&t[i], 5, 0.2, 1, 0.01);
    }
    const long n = tank_at(&t[0], "book", NULL), u = tank_at(&t[0], "velocity of fluid", NULL);
    tank_rates(&t[0], 0, t[0].y, t[0].ydot);
    whole = tank_copy(&t[0], t[0].ydot);
    tank_rates(&t[1], 0, t[0].y, t[1].ydot);
    ask.without_pressure = true;
    assert_int_equal(moment_eval(t[0].moment, ask, 0, t[0].y, t[0].ydot), STATUS_DONE);
    assert_memory_equal(t[0].ydot, t[1].ydot, (size_t)n * sizeof *whole);
    assert_true(fabs(whole[u] - t[0].ydot[u]) > 1e-3 * fabs(whole[u]));
    test_free(whole);
    for (int i = 0; i < 2; i++)
        tank_free(&t[i]);
}

/* Two moments of one plan at two states, asked in turns: each answers as if alone. */
static void moments_of_a_plan_keep_apart(void **state)
{
    struct tank t, other;
    struct moment *second;
    double *alone[2], *y[2];

    (void)state;
    tank_make(&t, DIM == 2 ? tank_parted_water : tank_bare_water, tank_frame,
              DIM == 2 ? tank_beam : "", TANK_ONE_KERNEL, TANK_EFFECTS, NULL);
    other = t;
    assert_int_equal(moment_create(t.plan, &second), STATUS_DONE);
    for (int i = 0; i < 2; i++) {
        tank_shake(&t, 3 + (unsigned)i, 0.3, 1, 0.01);
        y[i] = tank_copy(&t, t.y);
        alone[i] = tank_copy(&t, t.y);
        other.moment = i ? second : t.moment;
        tank_rates(&other, 0.01 * i, y[i], alone[i]);
    }
    for (int turn = 0; turn < 4; turn++) {
        other.moment = turn % 2 ? second : t.moment;
        tank_rates(&other, 0.01 * (turn % 2), y[turn % 2], t.ydot);
        assert_memory_equal(t.ydot, alone[turn % 2], (size_t)t.n * sizeof *t.ydot);
    }
    assert_int_equal(moment_counts(second)->passes, 3);
    assert_int_equal(moment_counts(second)->rebuilds, 1);
    for (int i = 0; i < 2; i++) {
        test_free(y[i]);
        test_free(alone[i]);
    }
    moment_free(&second);
    tank_free(&t);
}

static void what_is_not_there_has_no_row(void **state)
{
    const char *const space = DIM == 2
        ? "dimension = 2; until = 1.0; spacing = 0.01; eos = { c0 = 10.0; };"
          "domain = { from = [0.0, 0.0]; to = [0.1, 0.1]; };"
          "fluid = { a = { type = \"box\"; from = [0.0, 0.0]; to = [0.05, 0.05]; }; };"
        : "dimension = 3; until = 1.0; spacing = 0.02; eos = { c0 = 10.0; };"
          "domain = { from = [0.0, 0.0, 0.0]; to = [0.1, 0.1, 0.1]; };"
          "fluid = { a = { type = \"box\"; from = [0.0, 0.0, 0.0]; to = [0.04, 0.04, 0.04]; }; };";
    struct tank t;
    const char *path;

    (void)state;
    tank_make(&t, space, TANK_EFFECTS, NULL);
    for (int i = 0; i < plan_parts(t.plan); i++)
        assert_string_not_equal(plan_part(t.plan, i, &path)->name, "gravity");
    assert_int_equal(row_of(&t, "density of walls"), -1);
    assert_false(plan_stiff(t.plan));
    tank_free(&t);
}

/* Quadratures are seen by no error test; everything else is, by its scale. */
static void weights_are_those_of_the_scales(void **state)
{
    struct tank t;
    double *weight;

    (void)state;
    tank_make(&t, tank_water, tank_frame, TANK_EFFECTS, NULL);
    weight = tank_copy(&t, t.y);
    moment_weights(t.moment, 1e-3, weight);
    for (int i = 0; i < plan_layout(t.plan)->rows; i++) {
        const struct layout_row *r = &plan_layout(t.plan)->row[i];
        const double expected = strcmp(r->name, "book") == 0 ? 1e-12 : 1 / (1e-3 * r->scale);
        for (long k = r->offset; k < r->offset + (long)r->n * r->components; k++)
            check(fabs(weight[k] / expected - 1) < 1e-14, "%s: %g instead of %g", r->name,
                  weight[k], expected);
    }
    test_free(weight);
    tank_free(&t);
}

/* Sound speed of a linear equation of state, from k or c0 or both if they agree. */
static void stiffness_is_the_square_of_the_sound_speed(void **state)
{
    static const struct {
        const char *eos;
        double c0; /* 0: refused */
    } cases[] = {
        { "eos = { type = \"linear\"; k = 1e4; };", 100 },
        { "eos = { type = \"linear\"; k = 2.0; };", 1.4142135623730951 },
        { "eos = { type = \"linear\"; c0 = 30.0; };", 30 },
        { "eos = { type = \"linear\"; c0 = 30.0; k = 900.0; };", 30 },
        { "eos = { type = \"linear\"; c0 = 30.0; k = 901.0; };", 0 },
        { "eos = { type = \"linear\"; };", -1 }, /* by the height of the water */
    };

    (void)state;
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[2048];
        struct tank t;
        snprintf(text, sizeof text, "%s%s%s%s", tank_water, tank_frame, TANK_EFFECTS, cases[i].eos);
        if (cases[i].c0 == 0) {
            assert_int_equal(tank_try(&t, text), STATUS_BAD_SCENE);
            assert_non_null(strstr(status_message(), "k = 901"));
            status_clear();
        } else {
            const double expected = cases[i].c0 > 0
                ? cases[i].c0 : 10 * sqrt(2 * 9.81 * (DIM == 2 ? 0.06 : 0.12));
            tank_make(&t, text, NULL);
            check(fabs(plan_scales(t.plan)->c0 / expected - 1) < 1e-15 &&
                  plan_scales(t.plan)->gamma == 1, "c0 = %.17g", plan_scales(t.plan)->c0);
        }
        tank_free(&t);
    }
}

static void fastest_wave_and_decay_have_names(void **state)
{
    struct limit limit[2];
    struct tank t;

    (void)state;
    tank_make(&t, tank_water, tank_frame, TANK_EFFECTS, NULL);
    t.y[tank_at(&t, "velocity of fluid", NULL) + 11 * DIM] = 3;
    moment_limit(t.moment, 0, t.y, false, limit);
    assert_string_equal(limit[0].part, "tait");
    assert_int_equal(limit[0].where, 11);
    assert_false(limit[0].decay);
    assert_true(limit[1].decay && limit[1].rate > 0);
    const struct scales *s = plan_scales(t.plan);
    const double pressed = t.y[tank_at(&t, "density of fluid", NULL) + 11] / s->rho0;
    const double wave = SCALES_WAVE * (s->c0 * pow(pressed, 3) + 3) / s->hs;
    check(pressed > 1 && fabs(limit[0].rate - wave) < 1e-9 * wave, "wave %g 1/s", limit[0].rate);
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(right_hand_side_takes_no_memory),
        cmocka_unit_test(sides_add_up),
#if DIM == 2
        cmocka_unit_test(solve_inverts_the_implicit_side),
#endif
        cmocka_unit_test(rows_fill_the_state),
        cmocka_unit_test(effect_left_out_costs_nothing),
        cmocka_unit_test(all_but_pressure_can_be_asked_for),
        cmocka_unit_test(moments_of_a_plan_keep_apart),
        cmocka_unit_test(what_is_not_there_has_no_row),
        cmocka_unit_test(weights_are_those_of_the_scales),
        cmocka_unit_test(stiffness_is_the_square_of_the_sound_speed),
        cmocka_unit_test(fastest_wave_and_decay_have_names),
    };

    return cmocka_run_group_tests_name("plan", tests, NULL, NULL);
}
