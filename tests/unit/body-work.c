/* body-work.c -- tests of the contract of bodies: two works of one body, in use in turns, do
 * not know of each other, and what they keep changes nothing. */
#include "bench.h"

enum { KINDS_HERE = 2, STEPS = 12 };

static const struct body_kind *const kinds[KINDS_HERE] = { &bodies_beam, &bodies_elastica };
static const char *const theory[KINDS_HERE] = { "linear", "elastica" };

static void make(struct bench *b, int kind)
{
    unsigned seed = 3;

    bench_of(b, kinds[kind]);
    b->def.theory = theory[kind];
    b->def.alpha = 2;
    b->def.load = 5;
    bench_make(b);
    for (int i = 3; i < b->size - 3; i++)
        b->y[i] += 1e-4 * noise(&seed);
    bench_push(b, &seed);
}

/* All that a body says of a moment, into numbers; their number. */
static int say(const struct bench *b, struct body_work *w, const double *y, double *to)
{
    static double x[BENCH_SKIN][DIM], u[BENCH_SKIN][DIM];
    struct body_view view;
    struct body_load load;
    struct energies e = { 0 };
    double ydot[BENCH_Y] = { 0 }, p[DIM] = { 0 }, *at = to;
    const double (*force)[DIM] = (const double (*)[DIM])b->force;

    b->kind->move(b->body, w, &b->layout, 0, y, x, u);
    b->kind->load(b->body, w, &b->layout, 0, y, force, ydot, &load);
    b->kind->implicit->stiff(b->body, w, &b->layout, 0, y, ydot);
    b->kind->energy(b->body, w, &b->layout, y, &e);
    b->kind->momentum(b->body, w, &b->layout, y, p);
    b->kind->show(b->body, w, &b->layout, 0, y, force, &view);
    memcpy(at, ydot, sizeof ydot);
    memcpy(at += BENCH_Y, x, (size_t)b->skin * sizeof x[0]);
    memcpy(at += b->skin * DIM, u, (size_t)b->skin * sizeof u[0]);
    memcpy(at += b->skin * DIM, &load, sizeof load);
    memcpy(at += sizeof load / sizeof *at, &e, sizeof e);
    memcpy(at += sizeof e / sizeof *at, p, sizeof p);
    memcpy(at += DIM, &view, sizeof view);
    return (int)(at - to) + (int)(sizeof view / sizeof *at);
}

enum { SAID = BENCH_Y + 2 * BENCH_SKIN * DIM + 64 };

/* More lengths than a work keeps factors of, some of them again. */
static double length(int step)
{
    return 1e-5 * (1 + step * 5 % 7);
}

/* Implicit steps by w from b->y; whenever another work is given it is used in between, at
 * another state and other lengths.  z [STEPS][BENCH_Y] are their ends. */
static void walk(const struct bench *b, struct body_work *w, struct body_work *other,
                 double (*z)[BENCH_Y])
{
    static double told[SAID];
    double r[BENCH_Y], away[BENCH_Y];

    memcpy(r, b->y, sizeof r);
    for (int k = 0; k < STEPS; k++) {
        memcpy(z[k], r, sizeof r);
        assert_int_equal(b->kind->implicit->solve(b->body, w, &b->layout, 0, length(k), r, z[k]),
                         STATUS_DONE);
        memcpy(r, z[k], sizeof r);
        if (!other)
            continue;
        for (int i = 0; i < BENCH_Y; i++)
            away[i] = -0.5 * b->y[i];
        say(b, other, away, told);
        assert_int_equal(b->kind->implicit->solve(b->body, other, &b->layout, 0, length(k + 3),
                                                  b->y, away), STATUS_DONE);
    }
}

static void steps_do_not_feel_another_work(void **state)
{
    static double alone[STEPS][BENCH_Y], together[STEPS][BENCH_Y];

    (void)state;
    for (int kind = 0; kind < KINDS_HERE; kind++) {
        struct body_work *first = NULL, *second = NULL;
        struct bench b;
        make(&b, kind);
        walk(&b, b.work, NULL, alone);
        assert_int_equal(b.kind->make.work(b.body, &first), STATUS_DONE);
        assert_int_equal(b.kind->make.work(b.body, &second), STATUS_DONE);
        walk(&b, first, second, together);
        assert_memory_equal(alone, together, sizeof alone);
        walk(&b, second, NULL, together); /* with what it keeps by now */
        assert_memory_equal(alone, together, sizeof alone);
        b.kind->make.work_free(&first);
        b.kind->make.work_free(&second);
        bench_free(&b);
    }
}

static void a_used_work_says_what_a_new_one_says(void **state)
{
    static double used[SAID], new[SAID], ends[STEPS][BENCH_Y];

    (void)state;
    for (int kind = 0; kind < KINDS_HERE; kind++) {
        struct body_work *w = NULL;
        struct bench b;
        make(&b, kind);
        walk(&b, b.work, NULL, ends);
        const int n = say(&b, b.work, b.y, used);
        assert_true(n <= SAID);
        assert_int_equal(b.kind->make.work(b.body, &w), STATUS_DONE);
        assert_int_equal(say(&b, w, b.y, new), n);
        assert_memory_equal(used, new, (size_t)n * sizeof *new);
        b.kind->make.work_free(&w);
        bench_free(&b);
    }
}

/* Of a solve of the whole: a work joins for itself. */
static void works_join_for_themselves(void **state)
{
    const struct body_coupled *c = bodies_beam.role.coupled;
    double firm[BENCH_SKIN], weak[BENCH_SKIN], v[BENCH_DOFS], alone[BENCH_DOFS];
    struct body_work *other = NULL;
    struct bench b;

    (void)state;
    make(&b, 0);
    for (int i = 0; i < b.skin; i++) {
        firm[i] = 40 + i;
        weak[i] = 2;
    }
    for (int i = 0; i < c->unknowns(b.body); i++)
        v[i] = alone[i] = sin(3.0 * i);
    assert_int_equal(c->join(b.body, b.work, 1e-3, firm), STATUS_DONE);
    c->joined(b.body, b.work, alone);
    assert_int_equal(b.kind->make.work(b.body, &other), STATUS_DONE);
    assert_int_equal(c->join(b.body, b.work, 1e-3, firm), STATUS_DONE);
    assert_int_equal(c->join(b.body, other, 2e-3, weak), STATUS_DONE);
    c->joined(b.body, b.work, v);
    assert_memory_equal(v, alone, (size_t)c->unknowns(b.body) * sizeof *v);
    b.kind->make.work_free(&other);
    bench_free(&b);
}

static void kinds_without_a_part_in_a_solve_of_the_whole_say_so(void **state)
{
    (void)state;
    assert_non_null(bodies_beam.role.coupled);
    assert_null(bodies_elastica.role.coupled);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_do_not_feel_another_work),
        cmocka_unit_test(a_used_work_says_what_a_new_one_says),
        cmocka_unit_test(works_join_for_themselves),
        cmocka_unit_test(kinds_without_a_part_in_a_solve_of_the_whole_say_so),
    };

    return cmocka_run_group_tests_name("body-work", tests, NULL, NULL);
}
