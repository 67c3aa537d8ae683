/* rigid-seats.c -- contacts of many bodies: the grid misses no pair, seats are given before bodies
 * touch and change no force, and how many there are cannot be seen. */
#include "../unit/tank-run.h"
#include "tank.h"

#include "base/status.h"
#include "bodies/contacts-seats.h"
#include "eval/inside.h"
#include "plan/inside.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if DIM == 2
#define HEAD "dimension = 2;"
enum { MANY = 170, ACROSS = 13 };
#else
#define HEAD "dimension = 3;"
enum { MANY = 60, ACROSS = 4 };
#endif

static const double apart = 0.06;

static void vector(char *to, const double *x)
{
    to += sprintf(to, "[%.17g", x[0]);
    for (int d = 1; d < DIM; d++)
        to += sprintf(to, ", %.17g", x[d]);
    sprintf(to, "]");
}

/* Body i of a lattice, somewhat off. */
static void lattice(int i, double *x)
{
    unsigned seed = (unsigned)i + 1;

    for (int d = 0, rest = i; d < DIM; d++, rest /= ACROSS)
        x[d] = apart * (d == DIM - 1 ? rest : rest % ACROSS) + 0.05 + 0.004 * tank_random(&seed);
}

/* n boxes of 4 cm, in a box so high that all fit, which repeats along x or has sides. */
static char *scene(int n, bool repeats)
{
    const double zero[DIM] = { 0 }, to[] = { 1, DIM == 2 ? 2 : 1, 2 };
    char *text = malloc(400 * (size_t)n + 4000), *end = text, a[100], b[100], speed[100];

    vector(a, zero);
    vector(b, to);
    end += sprintf(end, HEAD "until = 9.0; domain = { from = %s; to = %s; %s };", a, b,
                   repeats ? "periodic = [\"x\"];" : "");
    end += sprintf(end, "gravity = %s; body = {", a);
    for (int i = 0; i < n; i++) {
        double x[DIM], size[] = { 0.04, 0.04, 0.04 }, v[] = { 2, 0, 0 };
        lattice(i, x);
        vector(a, x);
        vector(b, size);
        vector(speed, v);
        end += sprintf(end, "b%d = { at = %s; size = %s; mass = 0.1; velocity = %s; %s };\n", i, a, b, speed,
                       repeats ? "" : "stops = [\"bottom\", \"left\", \"right\"];");
    }
    sprintf(end, "};");
    return text;
}

static void make(struct tank *t, int n, bool repeats)
{
    char *text = scene(n, repeats);

    tank_make(t, text, NULL);
    free(text);
}

static double *row(const struct tank *t, int body, const char *what)
{
    char name[80];

    snprintf(name, sizeof name, "body.b%d.%s", body, what);
    return t->y + tank_at(t, name, NULL);
}

/* --- the grid ----------------------------------------------------------------------- */

static bool found(const struct contacts_work *w, int pair)
{
    for (int k = 0; k < w->near; k++)
        if (w->pair[k] == pair)
            return true;
    return false;
}

static void check_all_found(struct tank *t, double gap)
{
    const struct contacts *c = t->plan->contacts.self;
    const struct contacts_moment m = touching_now(t->moment, 0, t->y);

    contacts_near_place(c, &m);
    contacts_near_find(c, &m, gap);
    for (int i = 0; i < c->pairs; i++) {
        const struct contacts_pair *p = &c->pair[i];
        struct solid_place room[2];
        const struct contacts_stand s = contacts_list_stand(
            c, contacts_near_of(c, &m, p->first, &room[0]), contacts_near_of(c, &m, p->second, &room[1]));
        if (!contacts_pair_far(p, &s, gap))
            check(found(m.work, i), "%s and %s are near and were not found", p->a->path, p->b->path);
    }
    for (int k = 1; k < m.work->near; k++)
        check(m.work->pair[k - 1] < m.work->pair[k], "pairs are out of order or twice");
}

static void no_pair_is_missed(void **state)
{
    (void)state;
    for (int repeats = 0; repeats < 2; repeats++) {
        unsigned seed = 7;
        struct tank t;
        make(&t, MANY, repeats);
        for (int round = 0; round < 20; round++) {
            for (int i = 0; i < MANY; i++)
                for (int d = 0; d < DIM; d++)
                    row(&t, i, "x")[d] = (round < 10 ? 0.2 : 2) * tank_random(&seed);
            check_all_found(&t, round % 3 * 0.02);
        }
        row(&t, 0, "x")[0] = repeats ? 1e7 : 1e300;
        check_all_found(&t, 0);
        tank_free(&t);
    }
}

/* Of bodies as dense, without sides. */
static double looks(int n)
{
    struct tank t;
    double each;

    make(&t, n, true);
    const struct contacts_moment m = touching_now(t.moment, 0, t.y);
    contacts_near_place(t.plan->contacts.self, &m);
    contacts_near_find(t.plan->contacts.self, &m, 0);
    each = (double)m.work->near / n;
    tank_free(&t);
    return each;
}

static void looks_grow_as_bodies_do(void **state)
{
    const double few = looks(64), many = looks(250);

    (void)state;
    printf("# pairs looked at, a body: %g of 64, %g of 250\n", few, many);
    check(many < 1.6 * few, "%g pairs a body of 64 bodies, and %g of 250", few, many);
    check(many < 30, "%g pairs a body", many);
}

/* --- seats -------------------------------------------------------------------------- */

/* Puts body 1 beside body 0, their faces that far apart, and all others far away. */
static void put(struct tank *t, int n, double gap)
{
    for (int i = 0; i < n; i++)
        for (int d = 0; d < DIM; d++)
            row(t, i, "x")[d] = i < 2 ? 0.5 : d == DIM - 1 ? 1 + 0.1 * i : 0.5;
    row(t, 1, "x")[0] += 0.04 + gap;
    row(t, 1, "x")[1] += 0.003;
    row(t, 1, "v")[1] = 0.1;
    row(t, 0, "spin")[0] = 0.7;
}

static void check_rates(const struct tank *few, const struct tank *many)
{
    static const char *const rates[] = { "v", "spin" };

    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++) {
            const double *a = few->ydot + (row(few, i, rates[k]) - few->y);
            const double *b = many->ydot + (row(many, i, rates[k]) - many->y);
            const int n = k == 0 ? DIM : TURNING_SPINS;
            check(memcmp(a, b, (size_t)n * sizeof *a) == 0, "body %d gets another %s: %g, not %g", i,
                  rates[k], b[0], a[0]);
        }
    check(fabs(few->ydot[row(few, 0, "v") - few->y]) > 1, "two bodies do not touch: %g", few->ydot[row(few, 0, "v") - few->y]);
}

/* How many hold a seat; all are of the first two bodies. */
static int held(const struct tank *t)
{
    const struct contacts *c = t->plan->contacts.self;
    const double *seat = t->y + layout_at(&t->plan->layout, c->seats.row);
    int n = 0;

    for (int k = 0; k < c->seats.n; k++)
        n += seat[k] != 0;
    return n;
}

static void a_seat_changes_no_force(void **state)
{
    struct tank few, many;

    (void)state;
    make(&few, 2, false);
    make(&many, MANY, false);
    check(((struct contacts *)few.plan->contacts.self)->seats.n == 0, "two bodies have seats");
    check(((struct contacts *)many.plan->contacts.self)->seats.n > 0, "many have none");
    put(&many, MANY, 1e-3);
    check(moment_lacks(many.moment, 0, many.y), "a pair that nearly touches lacks no seat");
    assert_int_equal(moment_settle(many.moment, 0, many.y), STATUS_DONE);
    check(!moment_lacks(many.moment, 0, many.y), "it lacks one that it was given");
    assert_int_equal(held(&many), 1);
    put(&few, 2, -1e-4);
    put(&many, MANY, -1e-4);
    double *a = few.y + tank_at(&few, "contacts.slip", NULL);
    const struct contacts *c = many.plan->contacts.self;
    double *b = many.y + layout_at(&many.plan->layout, c->row) + c->seats.from * DIM;
    for (int i = 0; i < c->seats.block * DIM; i++)
        a[i] = b[i] = 1e-6 * (i % 7 - 3);
    tank_rates(&few, 0, few.y, few.ydot);
    tank_rates(&many, 0, many.y, many.ydot);
    check_rates(&few, &many);
    tank_free(&few);
    tank_free(&many);
}

static void who_touches_without_a_seat_is_refused(void **state)
{
    struct tank t;

    (void)state;
    make(&t, MANY, false);
    put(&t, MANY, 0.03);
    assert_int_equal(moment_settle(t.moment, 0, t.y), STATUS_DONE);
    assert_int_equal(held(&t), 0);
    put(&t, MANY, -1e-4);
    assert_int_equal(moment_eval(t.moment, ASK_ALL, 0, t.y, t.ydot), STATUS_FAILED);
    check(strstr(moment_refusal(t.moment), "body.b0 touches body.b1") != NULL, "it says: %s",
          moment_refusal(t.moment));
    tank_free(&t);
}

/* A seat is kept while it is bent, and given back by a pair that is far. */
static void seats_are_given_back(void **state)
{
    struct tank t;

    (void)state;
    make(&t, MANY, false);
    const struct contacts *c = t.plan->contacts.self;
    put(&t, MANY, 1e-3);
    assert_int_equal(moment_settle(t.moment, 0, t.y), STATUS_DONE);
    double *bend = t.y + layout_at(&t.plan->layout, c->row) + c->seats.from * DIM + 1;
    *bend = 1e-3 * c->seats.scale;
    put(&t, MANY, 0.03);
    assert_int_equal(moment_settle(t.moment, 0, t.y), STATUS_DONE);
    assert_int_equal(held(&t), 1);
    *bend = 1e-9 * c->seats.scale;
    assert_int_equal(moment_settle(t.moment, 0, t.y), STATUS_DONE);
    assert_int_equal(held(&t), 0);
    check(*bend == 0, "a seat is given back with what it remembered");
    tank_free(&t);
}

/* --- what a hash sees --------------------------------------------------------------- */

/* Pairs 3 and 8 are bent, 5 sits in vain, of so many seats. */
static long tidied(int seats, const int *who, double *y)
{
    struct contacts c = { .pairs = 20, .places = 2 + 3 * seats,
                          .seats = { .n = seats, .block = 3, .from = 2, .scale = 1 } };
    struct layout l = { 0 };

    c.row = layout_add(&l, LAYOUT_OTHER, "contacts.slip", "m", (int)c.places, DIM, 1);
    c.seats.row = layout_add(&l, LAYOUT_OTHER, "contacts.seat", "1", seats, 1, 0);
    const int last = layout_add(&l, LAYOUT_OTHER, "book", "1", 2, 1, 0);
    layout_done(&l);
    memset(y, 0, (size_t)layout_size(&l) * sizeof *y);
    y[0] = 0.5;
    for (int k = 0; k < seats; k++) {
        y[layout_at(&l, c.seats.row) + k] = who[k];
        for (int i = 0; i < 3 * DIM && who[k] != 5; i++)
            y[(2 + 3 * k) * DIM + i] = who[k] + 0.01 * i * who[k];
    }
    y[layout_at(&l, last)] = 77;
    y[layout_at(&l, last) + 1] = 78;
    return contacts_seats_tidy(&c, &l, y);
}

static void spare_seats_are_not_seen(void **state)
{
    const int some[] = { 8, 5, 3 }, more[] = { 0, 3, 0, 0, 8, 0 }, other[] = { 0, 3, 9 };
    double a[200], b[200];
    const long n = tidied(3, some, a);

    (void)state;
    assert_int_equal(n, (2 + 6) * DIM + 2 + 2);
    assert_int_equal(tidied(6, more, b), n);
    assert_memory_equal(a, b, (size_t)n * sizeof *a);
    assert_int_equal(tidied(3, other, b), n);
    check(memcmp(a, b, (size_t)n * sizeof *a) != 0, "another pair is not seen");
    check(a[n - 1] == 78 && a[n - 2] == 77, "what comes after seats is lost");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_pair_is_missed),
        cmocka_unit_test(looks_grow_as_bodies_do),
        cmocka_unit_test(a_seat_changes_no_force),
        cmocka_unit_test(who_touches_without_a_seat_is_refused),
        cmocka_unit_test(seats_are_given_back),
        cmocka_unit_test(spare_seats_are_not_seen),
    };

    return cmocka_run_group_tests_name("rigid-seats", tests, NULL, NULL);
}
