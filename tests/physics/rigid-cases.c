/* rigid-cases.c -- the cases that the law of contact was chosen by, each with its mark: slopes near
 * the angle of friction, a slide and a spin that end, walls of six, a push, heaps in a bin.
 * rigid-stops.c and rigid-contacts.c have the others; doc/blocks.md lists all. */
#include "../unit/tank-run.h"
#include "tank.h"

#include "bodies/turning.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if DIM == 2
#define HEAD "dimension = 2;"
#else
#define HEAD "dimension = 3;"
#endif

enum { UP = DIM - 1, MOST = 8 };

static const double side = 0.15;

/* In space contacts are many: one case of a kind, with STIFFWATER_LONG all. */
static bool all(void)
{
    return DIM == 2 || getenv("STIFFWATER_LONG");
}

static void near(double found, double expected, double tolerance, const char *what)
{
    printf("# %s: %.9g, expected %.9g within %.2g\n", what, found, expected, tolerance);
    check(fabs(found - expected) <= tolerance, "%s: found %.12g, expected %.12g within %g", what,
          found, expected, tolerance);
}

/* --- scenes of cubes ---------------------------------------------------------------- */

struct cube { /* all [m], [m/s], [degrees]; in the plane without y  */
    double x, y, up, angle, velocity[3], spin;
};

static char *vector(char *to, double x, double y, double up)
{
    if (DIM == 2)
        sprintf(to, "[%.15e, %.15e]", x, up);
    else
        sprintf(to, "[%.15e, %.15e, %.15e]", x, y, up);
    return to;
}

/* As stiff as with a softness p = 0.1 at 2 m/s, for which the marks were set: k goes as U^2/p^2.5, and
 * without water U is that of a fall, 1.0 m/s (3D: 1.1 m/s).
 *
 * n cubes "b0", ... on the bottom, between sides at x = -far and far (3D: y, too), on a slope;
 * `push` [m/s^2] acts besides. */
static void make(struct tank *t, const struct cube *c, int n, double slope, double push, double far)
{
    char text[6000], *end = text, a[100], b[100];
    const double g = 9.81, turn = slope * M_PI / 180;

    end += sprintf(end, HEAD "until = 100.0; gravity = %s; domain = { from = %s; ",
                   vector(a, g * sin(turn) + push, 0, -g * cos(turn)), vector(b, -far, -far, 0));
    end += sprintf(end, "to = %s; }; body = {", vector(a, far, far, 10));
    for (int i = 0; i < n; i++) {
        end += sprintf(end, "b%d = { at = %s; size = %s; ", i, vector(a, c[i].x, c[i].y, c[i].up),
                       vector(b, side, side, side));
        end += sprintf(end, "velocity = %s; mass = 2.7; margin = 0.005; softness = 0.06; stops = "
                       "[\"bottom\", \"left\", \"right\"%s]; ",
                       vector(a, c[i].velocity[0], c[i].velocity[1], c[i].velocity[2]),
                       DIM == 2 ? "" : ", \"front\", \"back\"");
        end += DIM == 2 ? sprintf(end, "angle = %.15e; spin = %.15e; };", c[i].angle, c[i].spin)
                        : sprintf(end, "angle = [0.0, 0.0, %.15e]; spin = [0.0, 0.0, %.15e]; };",
                                  c[i].angle, c[i].spin);
    }
    sprintf(end, "};");
    tank_make(t, text, NULL);
}

static double *row(const struct tank *t, int body, const char *what)
{
    char name[80];

    snprintf(name, sizeof name, "body.b%d.%s", body, what);
    return t->y + tank_at(t, name, NULL);
}

static double speed(const struct tank *t, int body)
{
    double square = 0;

    for (int d = 0; d < DIM; d++)
        square += row(t, body, "v")[d] * row(t, body, "v")[d];
    return sqrt(square);
}

/* --- one cube ----------------------------------------------------------------------- */

static const struct cube one = { .up = 0.075 };

/* A cube that lies on the level; that is tilted then. */
static void tilt(struct tank *t, double slope)
{
    struct tank level;

    make(&level, &one, 1, 0, 0, 50);
    tank_run(&level, "cks43", 1e-2, 0.5);
    make(t, &one, 1, slope, 0, 50);
    memcpy(t->y, level.y, (size_t)t->n * sizeof *t->y);
    tank_free(&level);
    tank_run(t, "cks43", 1e-2, 4);
}

/* The angle of friction is 19.29 degrees. */
static void it_holds_just_below_its_angle(void **state)
{
    struct tank t;

    (void)state;
    tilt(&t, 19);
    near(row(&t, 0, "x")[0], 0, 500e-6, "slip until it sticks at 19 degrees");
    near(row(&t, 0, "v")[0], 0, 1e-9, "creep");
    tank_free(&t);
}

static void it_slides_just_above_it(void **state)
{
    static const double slope[] = { 19.4, 20 }, mark[] = { 0.05, 0.01 };

    (void)state;
    for (int i = 0; i < 2; i++) {
        const double turn = slope[i] * M_PI / 180, v = 4 * 9.81 * (sin(turn) - 0.35 * cos(turn));
        struct tank t;
        tilt(&t, slope[i]);
        near(row(&t, 0, "v")[0], v, mark[i] * v, i == 0 ? "v(4 s) at 19.4 degrees" : "at 20 degrees");
        tank_free(&t);
    }
}

static void it_goes_as_far_as_coulomb_says(void **state)
{
    const double x = 0.5 * 9.81 * (sin(M_PI / 6) - 0.35 * cos(M_PI / 6));
    struct cube thrown = one;
    struct tank t;

    (void)state;
    make(&t, &one, 1, 30, 0, 50);
    tank_run(&t, "cks43", 1e-2, 1);
    near(row(&t, 0, "x")[0], x, 2e-3 * x, "x(1 s) at 30 degrees");
    tank_free(&t);
    thrown.velocity[0] = 1;
    make(&t, &thrown, 1, 0, 0, 50);
    tank_run(&t, "cks43", 1e-2, 1);
    near(row(&t, 0, "x")[0], 1 / (2 * 0.35 * 9.81), 1e-4 / (2 * 0.35 * 9.81), "where 1 m/s stops");
    near(speed(&t, 0), 0, 1e-3, "its speed");
    tank_free(&t);
}

#if DIM == 3
/* Friction acts on its four corners, 0.07 m sqrt(2) from the axis. */
static void its_spin_ends(void **state)
{
    const double expected = side * side / 6 * 10 / (0.35 * 9.81 * 0.07 * sqrt(2)), step = 2.5e-4;
    struct cube spinning = one;
    struct tank t;
    double time = 0;

    (void)state;
    spinning.spin = 10;
    make(&t, &spinning, 1, 0, 0, 50);
    for (; row(&t, 0, "spin")[2] > 0 && time < 1; time += step)
        tank_run(&t, "cks43", 1e-2, step);
    near(time, expected, 0.03 * expected, "when a spin of 10 rad/s ends");
    tank_free(&t);
}
#endif

/* --- walls of six ------------------------------------------------------------------- */

/* Three below, two, one; odd ones are turned by `angle`.  Those of a row are `gap` apart, and rows
 * `up`. */
static void pile(struct cube *c, double gap, double up, double angle)
{
    int n = 0;

    for (int level = 0; level < 3; level++)
        for (int i = 0; i < 3 - level; i++, n++)
            c[n] = (struct cube){ .x = (side + gap) * (i - 0.5 * (2 - level)),
                                  .up = up + 0.5 * side + level * (side + up),
                                  .angle = n % 2 ? angle : 0 };
}

/* How far the one that began at c->up is from its level: none has gone through another. */
static double sunk(const struct tank *t, int i, const struct cube *c)
{
    return fabs(row(t, i, "x")[UP] - (round(c->up / side - 0.5) + 0.5) * side);
}

/* From `from` s on, for a second: range of height of all, and their largest speed.  Each is at its
 * level then. */
static void rest(const struct cube *c, int n, double from, double range, const char *what)
{
    double least[MOST], most[MOST], widest = 0, fastest = 0, deepest = 0;
    struct tank t;

    make(&t, c, n, 0, 0, 50);
    tank_run(&t, "cks43", 1e-2, from);
    for (int i = 0; i < n; i++) {
        least[i] = most[i] = row(&t, i, "x")[UP];
        deepest = fmax(deepest, sunk(&t, i, &c[i]));
    }
    for (int look = 0; look < 4; look++) {
        tank_run(&t, "cks43", 1e-2, 0.25);
        for (int i = 0; i < n; i++) {
            least[i] = fmin(least[i], row(&t, i, "x")[UP]);
            most[i] = fmax(most[i], row(&t, i, "x")[UP]);
            widest = fmax(widest, most[i] - least[i]);
            fastest = fmax(fastest, speed(&t, i));
        }
    }
    near(widest, 0, range, what);
    near(fastest, 0, 1e-6, "their speed [m/s]");
    near(deepest, 0, 1e-3, "how far one is from its level [m]");
    tank_free(&t);
}

static void six_stand(void **state)
{
    struct cube c[6];

    (void)state;
    pile(c, 0.006, 0.005, 2);
    rest(c, 6, 2, 1e-8, "six, odd ones turned, dropped by 5 mm, range [m]");
    if (!all())
        return;
    pile(c, 0, 0, 0);
    rest(c, 6, 2, 1e-8, "six, touching, range [m]");
#if DIM == 2
    pile(c, 0.005, 0, 0);
    rest(c, 6, 2, 1e-8, "six, 5 mm apart, range [m]");
#else
    pile(c, 0.006, 0.001, 2);
    rest(c, 6, 2, 1e-8, "six, odd ones turned, dropped by 1 mm, range [m]");
#endif
}

#if DIM == 3
static void turned_stacks_stand(void **state)
{
    static const double angle[] = { 30, 5, 45 };

    (void)state;
    for (int i = 0; i < (all() ? 3 : 1); i++) {
        struct cube c[3];
        for (int k = 0; k < 3; k++)
            c[k] = (struct cube){ .up = (k + 0.5) * side, .angle = k * angle[i] };
        rest(c, 3, 2, 1e-8, "a stack turned, range [m]");
    }
}
#endif

/* --- books -------------------------------------------------------------------------- */

static double deepest(const struct tank *t)
{
    return moment_counts(t->moment)->deepest;
}

/* 20 N on each of six for 0.4 s, against a side; after it without. */
static void a_push_is_booked(void **state)
{
    struct book_sheet first, last;
    struct cube c[6];
    struct tank t[2];
    double defect, had = 0;

    (void)state;
    pile(c, 0.005, 0, 0);
    for (int i = 0; i < 2; i++)
        make(&t[i], c, 6, 0, i == 0 ? 20 / 2.7 : 0, 0.6);
    observe_sheet(t[0].moment, 0, t[0].y, &first);
    tank_run(&t[0], "cks43", 1e-2, 0.4);
    observe_sheet(t[0].moment, 0.4, t[0].y, &last);
    defect = fabs(book_defect(&first, &last));
    for (int i = 0; i < 6; i++)
        had += 2.7 * (9.81 * row(&t[0], i, "x")[UP] + 0.5 * speed(&t[0], i) * speed(&t[0], i));
    memcpy(t[1].y, t[0].y, (size_t)t[0].n * sizeof *t[0].y);
    observe_sheet(t[1].moment, 0.4, t[1].y, &first);
    tank_run(&t[1], "cks43", 1e-2, 1.1);
    observe_sheet(t[1].moment, 1.5, t[1].y, &last);
    defect += fabs(book_defect(&first, &last));
    near(defect, 0, 0.01 * had, "energy of six pushed against a side [J]");
    near(fmax(deepest(&t[0]), deepest(&t[1])), 0, 2 * 0.06 * 0.01, "deepest [m]");
    tank_free(&t[0]);
    tank_free(&t[1]);
}

/* Eight that are thrown into a bin, turned and spinning. */
static void throw(struct cube *c, unsigned seed)
{
    for (int i = 0; i < MOST; i++) {
        c[i] = (struct cube){ .x = (i % 2 - 0.5) * 0.24, .y = DIM == 2 ? 0 : (i / 2 % 2 - 0.5) * 0.24,
                              .up = 0.15 + 0.25 * (i / (DIM == 2 ? 2 : 4)), .angle = 20 * tank_random(&seed),
                              .spin = 3 * tank_random(&seed) };
        for (int k = 0; k < 3; k++)
            c[i].velocity[k] = tank_random(&seed) - (k == 2);
    }
}

static void heaps_are_booked(void **state)
{
    (void)state;
    for (unsigned seed = 1; seed <= (DIM == 2 ? 4 : all() ? 2 : 1); seed++) {
        struct book_sheet first, last;
        struct cube c[MOST];
        struct tank t;
        throw(c, seed);
        make(&t, c, MOST, 0, 0, 0.28);
        observe_sheet(t.moment, 0, t.y, &first);
        tank_run(&t, "cks43", 1e-2, 2);
        observe_sheet(t.moment, 2, t.y, &last);
        near(book_defect(&first, &last), 0, 0.02 * first.total, "energy of eight in a bin [J]");
        near(deepest(&t), 0, 0.005, "deepest [m]");
        check(moment_counts(t.moment)->refused == 0, "a core was entered");
#if DIM == 3
        for (int i = 0; i < MOST; i++) {
            const double *q = row(&t, i, "turn");
            near(sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]), 1, 1e-6, "|q|");
        }
#endif
        tank_free(&t);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_holds_just_below_its_angle),
        cmocka_unit_test(it_slides_just_above_it),
        cmocka_unit_test(it_goes_as_far_as_coulomb_says),
#if DIM == 3
        cmocka_unit_test(its_spin_ends),
        cmocka_unit_test(turned_stacks_stand),
#endif
        cmocka_unit_test(six_stand),
        cmocka_unit_test(a_push_is_booked),
        cmocka_unit_test(heaps_are_booked),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
