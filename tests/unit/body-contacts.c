/* body-contacts.c -- tests of the contract of contacts with one kind: a spring between two
 * blocks, one above the other, in a plan and in runs. */
#include "float.h"
#include "tank-run.h"

#include "../physics/tank.h"
#include "base/status.h"
#include "bodies/contacts.h"
#include "time/method.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Water far from both, no weight: nothing but springs pushes the blocks. */
#define SCENE(C0)                                                                          \
    "dimension = 2; until = 1.0; spacing = 0.005; gravity = [0.0, 0.0];"                       \
    "domain = { from = [0.0, 0.0]; to = [0.2, 0.2]; };"                                       \
    "fluid = { water = { type = \"box\"; from = [0.01, 0.01]; to = [0.03, 0.03]; }; };"       \
    "eos = { rho0 = 1000.0; c0 = " C0 "; }; walls = \"own-density\";"           \
    "effects = { continuity = { }; pressure = { }; };"
#define BLOCKS                                                                           \
    "beam = { lower = { at = [0.1, 0.1]; length = 0.02; mass = 2.0; stiffness = 5e3;"          \
    " lift = 1e-3; }; upper = { at = [0.1, 0.118]; length = 0.03; mass = 1.0;"                 \
    " stiffness = 2e3; lift = -3e-3; }; };"

/* --- a spring between the first two bodies ------------------------------------------ */

static const double stiffness = 4e4, reach = 0.017; /* [2D: N/m^2], lowest points apart [m] */

struct contacts {
    int row;
};

/* Where there are two bodies. */
static int create(const struct contacts_scene *scene, struct contacts **out)
{
    *out = NULL;
    if (scene->bodies < 2)
        return STATUS_DONE;
    assert_int_equal(scene->bodies, 2);
    *out = status_alloc(1, sizeof **out);
    return *out ? STATUS_DONE : STATUS_FAILED;
}

static void free_contacts(struct contacts **c)
{
    free(*c);
    *c = NULL;
}

/* The work that it gave, and 3 at the start. */
static int rows(struct contacts *c, struct layout *l)
{
    c->row = layout_add(l, LAYOUT_OTHER, "contacts.work", "J", 1, 1, 1);
    return c->row < 0 ? STATUS_FAILED : STATUS_DONE;
}

static void start(const struct contacts *c, const struct layout *l, double *y)
{
    y[layout_at(l, c->row)] = 3;
}

static bool parts(const struct contacts *c, int i, int j)
{
    (void)c;
    return i < 2 && j < 2;
}

static int meet(const struct contacts *c, const struct contacts_moment *m, char *text, size_t room)
{
    const struct contacts_body *body = m->body;
    const double gap = body[1].x[0][1] - body[0].x[0][1] - reach;
    const double force = gap < 0 ? -stiffness * gap : 0;

    (void)text;
    (void)room;
    *m->power = 0;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < body[i].points; j++) {
            const double f = (i == 0 ? -force : force) / body[i].points;
            body[i].force[j][1] += f;
            *m->power += f * body[i].u[j][1];
        }
    m->ydot[layout_at(m->layout, c->row)] = *m->power;
    return STATUS_DONE;
}

static void limit(const struct contacts *c, const struct contacts_moment *m, struct limit *out)
{
    (void)c;
    (void)m;
    out->rate = sqrt(stiffness * (1 / 2.0 + 1 / 1.0));
    strcpy(out->part, "spring");
}

static const char *const column[] = { "contact" };

static int columns(const struct contacts *c)
{
    (void)c;
    return 1;
}

static const struct body_contacts spring = {
    .about = "a spring between two bodies", .column = column, .columns = columns, .create = create,
    .free = free_contacts, .rows = rows, .start = start, .parts = parts,
    .meet = meet, .limit = limit,
};
const struct body_contacts *const bodies_contacts = &spring;

/* --- tests ------------------------------------------------------------------------- */

static void check_close(double found, double expected, double tolerance, const char *what)
{
    if (!(fabs(found - expected) <= tolerance))
        fail_msg("%s: found %.17g, expected %.17g within %g", what, found, expected, tolerance);
}

struct places {
    long s[2], v[2];
};

static struct places places_of(struct tank *t)
{
    return (struct places){ { tank_at(t, "beam.lower.s", NULL), tank_at(t, "beam.upper.s", NULL) },
                            { tank_at(t, "beam.lower.s_rate", NULL),
                              tank_at(t, "beam.upper.s_rate", NULL) } };
}

static double gap_of(const struct places *at, const double *y)
{
    return 0.018 + y[at->s[1]] - y[at->s[0]] - reach;
}

/* m v' = -k s -+ F, the same by the half of velocities; of the other half nothing. */
static void they_push_each_other(void **state)
{
    struct tank t;

    (void)state;
    tank_make(&t, SCENE("10.0"), BLOCKS, NULL);
    const struct places at = places_of(&t);
    const double force = -stiffness * gap_of(&at, t.y);
    const double up[2] = { (-5e3 * 1e-3 - force) / 2.0, (2e3 * 3e-3 + force) / 1.0 };
    const struct ask asks[] = { ASK_ALL, ASK_EXPLICIT_SIDE, ASK_HALF(ASK_VELOCITIES, 0) };
    assert_true(force > 10);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(moment_eval(t.moment, asks[i], 0, t.y, t.ydot), STATUS_DONE);
        for (int k = 0; k < 2; k++)
            check_close(t.ydot[at.v[k]], up[k], 1e-9, "rate of velocity");
    }
    assert_int_equal(moment_eval(t.moment, ASK_HALF(ASK_DENSITIES, 0), 0, t.y, t.ydot),
                     STATUS_DONE);
    check_close(t.ydot[at.v[1]], 0, 0, "densities push nothing");
    tank_free(&t);
}

static void their_limit_counts(void **state)
{
    struct limit limits[2];
    struct tank t;

    (void)state;
    tank_make(&t, SCENE("1.0"), BLOCKS, NULL);
    moment_limit(t.moment, 0, t.y, false, limits);
    assert_string_equal(limits[0].part, "spring");
    check_close(limits[0].rate, sqrt(1.5 * stiffness), 1e-9, "rate");
    tank_free(&t);
}

static void one_body_meets_none(void **state)
{
    struct tank t;

    (void)state;
    tank_make(&t, SCENE("10.0"), "beam = { it = { at = [0.1, 0.1]; length = 0.02; mass = 2.0; }; };",
              NULL);
    assert_null(t.plan->contacts.kind);
    assert_int_equal(t.plan->book.n, t.plan->book.contacts);
    tank_free(&t);
}

static double work_of(const struct book_sheet *s, const struct plan *p, const char *name)
{
    char names[BOOK_WORKS][BOOK_NAME];
    const int n = book_work_names(p, names);

    assert_int_equal(n, s->works);
    for (int i = 0; i < n; i++)
        if (strcmp(names[i], name) == 0)
            return s->work[i];
    fail_msg("no column %s", name);
    return 0;
}

/* Momentum is what the springs to the ground gave; energy what the contact gave, in its own
 * column of the book and in its own row of y: what was stored in it and is not any more. */
static void books_close(void **state)
{
    static const struct {
        const char *name;
        double near; /* [J/m]; steps of dv are long, and it books to the first order of them */
    } method[] = { { "erk3", 2e-6 },  { "imex3", 2e-6 },    { "dv", 6e-3 },
                   { "adams", 2e-5 }, { "leapfrog", 2e-4 }, { "ab3", 2e-5 } };

    (void)state;
    for (int i = 0; i < (int)(sizeof method / sizeof method[0]); i++) {
        struct book_sheet first, s;
        struct tank t;
        tank_make(&t, SCENE("10.0"), BLOCKS, NULL);
        const struct places at = places_of(&t);
        const double begun = gap_of(&at, t.y);
        observe_sheet(t.moment, 0, t.y, &first);
        tank_run(&t, method[i].name, 1e-5, 0.006);
        observe_sheet(t.moment, 0.006, t.y, &s);
        const double ended = fmin(gap_of(&at, t.y), 0);
        const double given = 0.5 * stiffness * (begun * begun - ended * ended);
        assert_true(fabs(given) > 0.05);
        check_close(work_of(&s, t.plan, "contact"), given, method[i].near, method[i].name);
        check_close(t.y[tank_at(&t, "contacts.work", NULL)], 3 + given, method[i].near,
                    method[i].name);
        check_close(book_defect(&first, &s), 0, method[i].near, method[i].name);
        check_close(book_momentum_defect(&first, &s), 0, 1e-10, method[i].name);
        assert_true(fabs(s.momentum[1]) > 1e-3);
        tank_free(&t);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(they_push_each_other),
        cmocka_unit_test(their_limit_counts),
        cmocka_unit_test(one_body_meets_none),
        cmocka_unit_test(books_close),
    };

    return cmocka_run_group_tests_name("body-contacts", tests, NULL, NULL);
}
