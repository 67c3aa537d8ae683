/* effects.c -- every law between particles, from the table: what one side of a
 * pair gets the other gives, and both get what the formula says. */
#include "effects-pair.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

const struct scales effects_scales = {
    .dimension = DIM, .dx = 0.1, .support = 0.3, .hs = 0.15, .rho0 = 1000, .c0 = 20,
    .gamma = 7, .speed = 2, .g = { 1.1, -9.81, 0.7 }, .fluid = true,
    .wave = 1, .laplace_density = 1, .laplace_viscosity = 1, .laplacian = 300, .centre = 25,
    .nearby = 11, .mass = 7,
};

enum { TRIES = 2000, WIDTHS = 3 };

struct width {
    const char *name;
    pair_ask *ask;
    const struct part *const *table;
};

/* The lane widths that this build and this machine have. */
static int widths(struct width *to)
{
    int n = 0;

    to[n++] = (struct width){ "2 lanes", effects_ask_lanes2, effects_table_lanes2 };
#ifdef STIFFWATER_V3
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        to[n++] = (struct width){ "4 lanes", effects_ask_lanes4, effects_table_lanes4 };
#endif
#ifdef STIFFWATER_V4
    if (__builtin_cpu_supports("x86-64-v4"))
        to[n++] = (struct width){ "8 lanes", effects_ask_lanes8, effects_table_lanes8 };
#endif
    return n;
}

static unsigned seed;

static double random_from(double low, double high)
{
    seed = seed * 1664525u + 1013904223u;
    return low + (high - low) * (seed >> 8) / 16777216.0;
}

static struct pair_particle random_particle(void)
{
    struct pair_particle p;

    for (int d = 0; d < DIM; d++) {
        p.x[d] = random_from(-0.1, 0.1);
        p.v[d] = random_from(-3, 3);
    }
    p.rho = random_from(900, 1150);
    p.p2 = random_from(-0.5, 2);
    p.m = random_from(2, 20);
    return p;
}

/* Sets a number, whole or not, or a flag of a law, if it has one of that name. */
static void set(const struct pair_law *law, const char *key, double value)
{
    for (const struct param *r = law->part->params; r && r->key; r++) {
        char *to = (char *)law->self + r->offset;
        if (strcmp(r->key, key) != 0)
            continue;
        if (r->type == PARAM_FLAG)
            *(bool *)(void *)to = value != 0;
        else if (r->type == PARAM_INTEGER)
            *(int *)(void *)to = (int)value;
        else
            *(double *)(void *)to = value;
    }
}

/* With keys of the effects of tests/parts/, too. */
static struct pair_law law_make(const struct part *part, const struct scales *scales,
                                bool only_approaching)
{
    struct pair_law law = { part, test_calloc(1, part->size + 1) };

    set(&law, "alpha", EFFECTS_ALPHA);
    set(&law, "mu", EFFECTS_MU);
    set(&law, "delta", EFFECTS_DELTA);
    set(&law, "strength", EFFECTS_STRENGTH);
    set(&law, "n", EFFECTS_POWER);
    set(&law, "k", 2.3);
    set(&law, "only_approaching", only_approaching);
    if (part->prepare)
        assert_int_equal(part->prepare(law.self, scales), 0);
    return law;
}

/* One formula that Toth (2012) prints for the plane only. */
static bool is_law(const struct part *part)
{
    return part->as.law && (DIM == 2 || strcmp(part->name, "viscosity-printed") != 0);
}

/* Calls `check` with every law between particles of every lane width, once with
 * gravity and once without, as published (with its switch) and not. */
static void for_all(void (*check)(const struct width *w, const struct pair_law *law))
{
    struct scales still = effects_scales;
    struct width w[WIDTHS];
    const int n = widths(w);

    memset(still.g, 0, sizeof still.g);
    for (int i = 0; i < n; i++)
        for (int k = 0; w[i].table[k]; k++)
            for (int way = 0; way < 4 && is_law(w[i].table[k]); way++) {
                struct pair_law law = law_make(w[i].table[k],
                                               way % 2 ? &still : &effects_scales, way / 2);
                seed = 17;
                check(&w[i], &law);
                test_free(law.self);
            }
}

static bool same_bits(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (a == 0 && b == 0);
}

static double dot(const double *a, const double *b)
{
    double sum = 0;

    for (int d = 0; d < DIM; d++)
        sum += a[d] * b[d];
    return sum;
}

static void check_sides(const struct width *w, const struct pair_law *law)
{
    const double sign = part_conserves(law->part) ? 1 : -1;

    for (int i = 0; i < TRIES; i++) {
        const struct pair_particle a = random_particle(), b = random_particle();
        struct pair_answer ab, ba;
        w->ask(law, &a, 1, &b, 0, &ab);
        w->ask(law, &b, 1, &a, 0, &ba);
        for (int d = 0; d < DIM; d++)
            if (!same_bits(ab.f[d], -ba.f[d]))
                fail_msg("%s, %s, pair %d: forces %.17g and %.17g are not opposite", w->name,
                         law->part->name, i, ab.f[d], ba.f[d]);
        if (!same_bits(ab.drho, sign * ba.drho))
            fail_msg("%s, %s, pair %d: m rho' is %.17g here, %.17g there", w->name,
                     law->part->name, i, ab.drho, ba.drho);
    }
}

/* Newton's third law; a conservative law compresses both sides alike; diffusion
 * gives one side what it takes from the other. */
static void both_sides_agree(void **state)
{
    (void)state;
    for_all(check_sides);
}

static void check_columns(const struct width *w, const struct pair_law *law)
{
    const unsigned columns = law->part->as.law->columns;
    bool force = false, drho = false;

    for (int i = 0; i < 200; i++) {
        const struct pair_particle a = random_particle(), b = random_particle();
        struct pair_answer to;
        w->ask(law, &a, 1, &b, 0, &to);
        if (!isfinite(dot(to.f, to.f)) || !isfinite(to.drho))
            fail_msg("%s, %s reads a row that it did not ask for", w->name, law->part->name);
        force |= dot(to.f, to.f) != 0;
        drho |= to.drho != 0;
    }
    if (force != ((columns & COLUMN_FORCE) != 0) || drho != ((columns & COLUMN_DRHO) != 0))
        fail_msg("%s, %s adds to other columns than it declares", w->name, law->part->name);
}

static void rows_and_columns_are_declared(void **state)
{
    (void)state;
    for_all(check_columns);
}

static void check_dissipation(const struct width *w, const struct pair_law *law)
{
    double v[DIM];

    for (int i = 0; i < TRIES && strstr(law->part->name, "viscosity"); i++) {
        const struct pair_particle a = random_particle(), b = random_particle();
        struct pair_answer to;
        w->ask(law, &a, 1, &b, 0, &to);
        for (int d = 0; d < DIM; d++)
            v[d] = a.v[d] - b.v[d];
        if (dot(to.f, v) > 1e-15 * sqrt(dot(to.f, to.f) * dot(v, v)))
            fail_msg("%s, %s, pair %d: power %g W is given to a pair", w->name, law->part->name, i,
                     dot(to.f, v));
    }
}

static void viscosity_only_takes_energy(void **state)
{
    (void)state;
    for_all(check_dissipation);
}

static void check_switch(const struct width *w, const struct pair_law *smooth,
                         const struct pair_law *published)
{
    int receding = 0;

    for (int i = 0; i < TRIES; i++) {
        const struct pair_particle a = random_particle(), b = random_particle();
        struct pair_answer one, other;
        double x[DIM], v[DIM];
        for (int d = 0; d < DIM; d++) {
            x[d] = a.x[d] - b.x[d];
            v[d] = a.v[d] - b.v[d];
        }
        w->ask(smooth, &a, 1, &b, 0, &one);
        w->ask(published, &a, 1, &b, 0, &other);
        receding += dot(x, v) > 0;
        for (int d = 0; d < DIM; d++)
            if (!same_bits(other.f[d], dot(x, v) > 0 ? 0 : one.f[d]))
                fail_msg("%s, %s, pair %d with x.v = %g: %g with the switch, %g without", w->name,
                         smooth->part->name, i, dot(x, v), other.f[d], one.f[d]);
    }
    assert_in_range(receding, TRIES / 3, 2 * TRIES / 3);
}

/* The switch leaves approaching pairs alone to the bit and frees receding ones. */
static void switch_frees_receding_pairs(void **state)
{
    struct width w[WIDTHS];
    const int n = widths(w);
    int found = 0;

    (void)state;
    for (int i = 0; i < n; i++)
        for (int k = 0; w[i].table[k]; k++)
            if (w[i].table[k]->as.law && w[i].table[k]->as.law->choose) {
                struct pair_law smooth = law_make(w[i].table[k], &effects_scales, false);
                struct pair_law published = law_make(w[i].table[k], &effects_scales, true);
                check_switch(&w[i], &smooth, &published);
                test_free(smooth.self);
                test_free(published.self);
                found++;
            }
    assert_int_equal(found, n);
}

static void check_formula(const struct width *w, const struct part *part)
{
    struct pair_law law = law_make(part, &effects_scales, false);
    pair_formula *formula = effects_formula(part->name);

    if (!formula)
        fail_msg("%s has no formula in effects-formulas.c", part->name);
    seed = 5;
    for (int i = 0; i < 50; i++) {
        const struct pair_particle a = random_particle(), b = random_particle();
        struct pair_answer found, expected = { { 0 }, 0 };
        double off = 0;
        w->ask(&law, &a, 1, &b, 0, &found);
        formula(&a, &b, &expected);
        for (int d = 0; d < DIM; d++)
            off += pow(found.f[d] - expected.f[d], 2);
        /* differences of densities and velocities lose up to two digits */
        if (sqrt(off) > 1e-13 * sqrt(dot(expected.f, expected.f))
            || fabs(found.drho - expected.drho) > 1e-12 * fabs(expected.drho))
            fail_msg("%s, %s, pair %d: force off by %g of %g, m rho' %.17g instead of %.17g",
                     w->name, part->name, i, sqrt(off), sqrt(dot(expected.f, expected.f)),
                     found.drho, expected.drho);
    }
    test_free(law.self);
}

static void laws_follow_their_formulas(void **state)
{
    struct width w[WIDTHS];
    const int n = widths(w);

    (void)state;
    for (int i = 0; i < n; i++)
        for (int k = 0; w[i].table[k]; k++)
            if (is_law(w[i].table[k]))
                check_formula(&w[i], w[i].table[k]);
}

static void check_padding(const struct width *w, const struct pair_law *law)
{
    const struct pair_particle a = random_particle();
    struct pair_particle b[PAIR_MOST];
    struct pair_answer without, with;

    for (int i = 0; i < PAIR_MOST; i++)
        b[i] = random_particle();
    w->ask(law, &a, PAIR_MOST, b, 0, &without);
    w->ask(law, &a, PAIR_MOST, b, 6, &with);
    if (memcmp(&without, &with, sizeof with) != 0)
        fail_msg("%s, %s: rows of padding change the sum", w->name, law->part->name);
    w->ask(law, &a, 0, b, 5, &with);
    if (dot(with.f, with.f) != 0 || with.drho != 0)
        fail_msg("%s, %s: padding alone gives %g, %g", w->name, law->part->name, with.f[0],
                 with.drho);
}

static void padding_adds_nothing(void **state)
{
    (void)state;
    for_all(check_padding);
}

static void compare_laws(const struct part_law *a, const struct part_law *b)
{
    assert_int_equal(!a, !b);
    if (!a)
        return;
    assert_int_equal(a->rows, b->rows);
    assert_int_equal(a->columns, b->columns);
    assert_int_equal(a->kernel, b->kernel);
}

static void compare_sums(const struct part_summed *a, const struct part_summed *b)
{
    assert_int_equal(!a, !b);
    if (a)
        assert_int_equal(a->rows, b->rows);
}

static void compare_tables(const struct part *const *a, const struct part *const *b)
{
    for (; *a && *b; a++, b++) {
        assert_string_equal((*a)->name, (*b)->name);
        compare_laws((*a)->as.law, (*b)->as.law);
        compare_sums((*a)->as.summed, (*b)->as.summed);
    }
    assert_true(!*a && !*b);
}

/* All widths hold the same parts in the same order: rows of the book agree. */
static void widths_hold_the_same_table(void **state)
{
    struct width w[WIDTHS];
    const int n = widths(w);

    (void)state;
    assert_non_null(w[0].table[0]);
    for (int i = 1; i < n; i++)
        compare_tables(w[0].table, w[i].table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_sides_agree),
        cmocka_unit_test(rows_and_columns_are_declared),
        cmocka_unit_test(viscosity_only_takes_energy),
        cmocka_unit_test(switch_frees_receding_pairs),
        cmocka_unit_test(laws_follow_their_formulas),
        cmocka_unit_test(padding_adds_nothing),
        cmocka_unit_test(widths_hold_the_same_table),
    };

    return cmocka_run_group_tests_name("effects", tests, NULL, NULL);
}
