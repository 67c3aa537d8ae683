/* rigid-contacts.c -- rigid bodies that touch each other and walls, against closed forms; the
 * identities of power and momentum at random states; books, rest, refusals. */
#include "../unit/tank-run.h"
#include "tank.h"

#include "base/status.h"
#include "bodies/turning.h"
#include "plan/inside.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#if DIM == 2
#define HEAD "dimension = 2;"
#define VECTOR(x, y, up) "[" x ", " up "]"
#define ROUND "disc"
#define TURN(degrees) degrees
static const double round_share = 1 / 2.0; /* I/(m R^2) */
#else
#define HEAD "dimension = 3;"
#define VECTOR(x, y, up) "[" x ", " y ", " up "]"
#define ROUND "sphere"
#define TURN(degrees) "[0.0, " degrees ", 0.0]"
static const double round_share = 2 / 5.0;
#endif

#define PLACE                                                                            \
    HEAD "until = 100.0; domain = { from = " VECTOR("-5.0", "-5.0", "0.0") "; to = "     \
    VECTOR("5.0", "5.0", "5.0") "; };"
#define FREE "gravity = " VECTOR("0.0", "0.0", "0.0") ";"
#define HEAVY "gravity = " VECTOR("0.0", "0.0", "-9.81") ";"
#define BLOCK(name, x, y, up, keys)                                                      \
    name " = { at = " VECTOR(x, y, up) "; size = " VECTOR("0.15", "0.15", "0.15")        \
    "; mass = 2.7; margin = 0.005;" keys "};"
#define BALL(name, x, up, keys)                                                          \
    name " = { shape = \"" ROUND "\"; at = " VECTOR(x, "0.0", up)                        \
    "; radius = 0.1; margin = 0.005; softness = 0.1;" keys "};"

enum { UP = DIM - 1, SPINS = TURNING_SPINS };

static void near(double found, double expected, double tolerance, const char *what)
{
    printf("# %s: %.9g, expected %.9g within %.2g\n", what, found, expected, tolerance);
    check(fabs(found - expected) <= tolerance, "%s: found %.12g, expected %.12g within %g", what,
          found, expected, tolerance);
}

static double *row(const struct tank *t, const char *body, const char *what)
{
    char name[80];

    snprintf(name, sizeof name, "body.%s.%s", body, what);
    return t->y + tank_at(t, name, NULL);
}

/* --- two balls ---------------------------------------------------------------------- */

/* Masses 1 and 3, a restitution of 0.6 between sqrt(0.4 0.9). */
static void balls_bounce_off_each_other(void **state)
{
    struct tank t;

    (void)state;
    tank_make(&t, PLACE FREE "body = {"
              BALL("a", "0.0", "1.0", "mass = 1.0; restitution = 0.4; velocity = "
                   VECTOR("1.5", "0.0", "0.0") ";")
              BALL("b", "0.25", "1.0", "mass = 3.0; restitution = 0.9; velocity = "
                   VECTOR("-0.5", "0.0", "0.0") ";") "};", NULL);
    tank_run(&t, "cks43", 1e-2, 0.2);
    const double va = row(&t, "a", "v")[0], vb = row(&t, "b", "v")[0];
    near(vb - va, 2 * 0.6, 2e-2, "apart after the impact [m/s]");
    near(va + 3 * vb, 1.5 - 3 * 0.5, 1e-12, "momentum");
    tank_free(&t);
}

/* Restitution does not depend on how many corners share the push, nor on whose they are: face on face,
 * a corner (3D: an edge) on a face, a face on a wall. */
static void faces_bounce_as_balls(void **state)
{
    static const char *const angle[] = { TURN("0.0"), TURN("45.0") };
    struct tank t;

    (void)state;
    for (int i = 0; i < 2; i++) {
        char bodies[800];
        snprintf(bodies, sizeof bodies, "body = {"
                 BLOCK("a", "0.0", "0.0", "1.0", "softness = 0.01; friction = 0.0;")
                 BLOCK("b", "0.19", "0.0", "1.0", "softness = 0.01; friction = 0.0; velocity = "
                       VECTOR("-1.0", "0.0", "0.0") "; angle = %s;") "};", angle[i]);
        tank_make(&t, PLACE FREE, bodies, NULL);
        tank_run(&t, "erk4", 1e-5, 0.1);
        near(row(&t, "b", "v")[0] - row(&t, "a", "v")[0], 0.6, 1e-4, "of two boxes");
        tank_free(&t);
    }
    tank_make(&t, PLACE FREE "body = {"
              BLOCK("a", "0.0", "0.0", "0.09", "stops = [\"bottom\"]; softness = 0.01; velocity = "
                    VECTOR("0.0", "0.0", "-1.0") ";") "};", NULL);
    tank_run(&t, "erk4", 1e-5, 0.1);
    near(row(&t, "a", "v")[UP], 0.6, 1e-4, "of a box on a floor");
    tank_free(&t);
}

/* A spinning ball drops on one at rest on ... nothing: the spin that friction takes from
 * one goes into both, at equal and opposite impulses. */
static void friction_turns_both(void **state)
{
    struct tank t;

    (void)state;
    tank_make(&t, PLACE FREE "body = {"
              BALL("a", "0.0", "1.0", "mass = 2.0; velocity = " VECTOR("1.0", "0.0", "0.0") "; spin = "
                   TURN("40.0") ";")
              BALL("b", "0.21", "1.0", "mass = 2.0;") "};", NULL);
    tank_run(&t, "cks43", 1e-4, 0.2);
    const int about = DIM == 2 ? 0 : 1;
    const double up = row(&t, "b", "v")[UP], along = row(&t, "b", "v")[0];
    const double inertia = round_share * 2 * 0.1 * 0.1;
    near(fabs(up), 0.35 * along, 2e-2 * fabs(up), "sliding friction");
    near(row(&t, "a", "v")[UP], -up, 1e-12, "momentum across");
    near(inertia * (40 - row(&t, "a", "spin")[about]), 2 * 0.1 * fabs(up), 2e-4, "spin lost");
    near(inertia * row(&t, "b", "spin")[about], -2 * 0.1 * fabs(up), 2e-4, "spin won");
    tank_free(&t);
}

/* --- identities at a random state --------------------------------------------------- */

struct sums {
    double power, force[DIM], moment[3];
};

static void add_body(const struct tank *t, const char *name, struct sums *to)
{
    const double *x = row(t, name, "x"), *v = row(t, name, "v"), *spin = row(t, name, "spin");
    const double *vdot = t->ydot + (v - t->y), *spindot = t->ydot + (spin - t->y);
    const double inertia = 2.7 / 6 * 0.15 * 0.15;
    double R[DIM][DIM];

    turning_matrix(row(t, name, "turn"), R);
    for (int d = 0; d < DIM; d++) {
        const int j = (d + 1) % DIM, k = (d + 2) % DIM;
        to->force[d] += 2.7 * vdot[d];
        to->power += 2.7 * v[d] * vdot[d];
        if (DIM == 3)
            to->moment[d] += 2.7 * (x[j] * vdot[k] - x[k] * vdot[j]);
    }
    if (DIM == 2)
        to->moment[0] += 2.7 * (x[0] * vdot[1] - x[1] * vdot[0]);
    for (int i = 0; i < SPINS; i++) {
        to->power += inertia * spin[i] * spindot[i];
        for (int d = 0; d < SPINS; d++)
            to->moment[d] += inertia * (SPINS == 1 ? 1 : R[d % DIM][i]) * spindot[i];
    }
}

static double contact_power(const struct tank *t)
{
    const double *book = t->ydot + layout_at(&t->plan->layout, t->plan->book.row);

    return book[t->plan->book.contacts] + book[t->plan->book.contacts + 1];
}

/* Two blocks that stand a few millimetres in each other, turned, spinning, bent. */
static void shake(struct tank *t, unsigned seed)
{
    long xi = tank_at(t, "contacts.slip", NULL);

    for (int i = 0; i < DIM; i++) {
        row(t, "a", "v")[i] = tank_random(&seed);
        row(t, "b", "v")[i] = tank_random(&seed);
    }
    for (int i = 0; i < SPINS; i++) {
        row(t, "a", "spin")[i] = 5 * tank_random(&seed);
        row(t, "b", "spin")[i] = 5 * tank_random(&seed);
    }
    for (long i = xi; i < xi + DIM * t->plan->layout.row[t->plan->layout.rows - 2].n; i++)
        t->y[i] = 1e-4 * tank_random(&seed);
}

static void power_and_momentum_balance(void **state)
{
    struct tank t;

    (void)state;
    tank_make(&t, PLACE FREE "body = {"
              BLOCK("a", "0.02", "0.01", "1.155",
                    "angle = " TURN("3.0") ";") BLOCK("b", "0.0", "0.0", "1.0", "") "};", NULL);
    row(&t, "a", "x")[UP] -= 0.0085;
    for (unsigned seed = 1; seed < 6; seed++) {
        struct sums all = { 0 }, one = { 0 };
        shake(&t, seed);
        tank_rates(&t, 0, t.y, t.ydot);
        add_body(&t, "a", &all);
        one = all;
        add_body(&t, "b", &all);
        check(fabs(one.force[UP]) > 10, "nothing pushes: %g N", one.force[UP]);
        near(all.power, contact_power(&t), 1e-12 * fabs(one.power), "power");
        for (int d = 0; d < DIM; d++)
            near(all.force[d], 0, 1e-11 * fabs(one.force[UP]), "momentum");
        for (int i = 0; i < SPINS; i++)
            near(all.moment[i], 0, 1e-11 * fabs(one.force[UP]), "angular momentum");
    }
    tank_free(&t);
}

/* --- blocks -------------------------------------------------------------------------- */

#if DIM == 3
/* A cube with an edge up meets one with an edge down, `off` beside its middle; elastic, so the
 * impulse is twice that of a plastic one. */
static void edges_meet(const char *at, double off)
{
    struct book_sheet first, last;
    struct tank t;
    char body[600];
    const double inertia = 2.7 / 6 * 0.15 * 0.15, arm = off;
    const double impulse = 2 * 1.0 / (2 / 2.7 + arm * arm / inertia);

    snprintf(body, sizeof body, "body = {"
             BLOCK("a", "%s", "0.0", "1.23", "angle = [0.0, 45.0, 0.0]; restitution = 1.0; "
                   "softness = 0.05; friction = 0.0; velocity = [0.0, 0.0, -1.0];")
             BLOCK("b", "0.0", "0.0", "1.0", "angle = [45.0, 0.0, 0.0]; restitution = 1.0; "
                   "softness = 0.05; friction = 0.0;") "};", at);
    tank_make(&t, PLACE FREE, body, NULL);
    observe_sheet(t.moment, 0, t.y, &first);
    tank_run(&t, "cks43", 1e-4, 0.05);
    observe_sheet(t.moment, 0.05, t.y, &last);
    near(row(&t, "b", "v")[2], -impulse / 2.7, 0.01 * impulse / 2.7, "velocity of the one hit");
    const double *spin = row(&t, "b", "spin");
    near(sqrt(spin[0] * spin[0] + spin[1] * spin[1] + spin[2] * spin[2]),
         impulse * arm / inertia, 0.01 * impulse * arm / inertia + 1e-6, "its spin");
    near(book_defect(&first, &last), 0, 1e-3, "energy");
    tank_free(&t);
}

static void edge_on_edge(void **state)
{
    (void)state;
    edges_meet("0.0", 0);
    edges_meet("0.004", 0.004);
    edges_meet("0.03", 0.03);
}
#endif

/* Range of height and largest speed of the top one from 2 s to 4 s. */
static void rests(const char *bodies, const char *what)
{
    double least = HUGE_VAL, most = -HUGE_VAL, fastest = 0;
    struct tank t;

    tank_make(&t, PLACE HEAVY "body = {", bodies, "};", NULL);
    tank_run(&t, "cks43", 1e-2, 1.5);
    for (int look = 0; look < 5; look++) {
        tank_run(&t, "cks43", 1e-2, 0.5);
        least = fmin(least, row(&t, "top", "x")[UP]);
        most = fmax(most, row(&t, "top", "x")[UP]);
        for (int d = 0; d < DIM; d++)
            fastest = fmax(fastest, fabs(row(&t, "top", "v")[d]));
    }
    tank_free(&t);
    near(most - least, 0, 1e-8, what);
    near(fastest, 0, 1e-6, "its speed [m/s]");
}

static void stacks_rest(void **state)
{
    (void)state;
    rests(BLOCK("one", "0.0", "0.0", "0.075", "stops = [\"bottom\"];")
          BLOCK("two", "0.0", "0.0", "0.226", "") BLOCK("top", "0.0", "0.0", "0.377", ""),
          "three on each other, range [m]");
    rests(BLOCK("one", "0.0", "0.0", "0.075", "stops = [\"bottom\"];")
          BLOCK("two", "0.155", "0.0", "0.075", "stops = [\"bottom\"];")
          BLOCK("top", "0.0775", "0.0", "0.226", ""), "one on two, range [m]");
}

/* --- walls --------------------------------------------------------------------------- */

#define SLOPE(angle) "spacing = 0.1;  wall = { slope = { type = \"box\"; from = "        \
    VECTOR("-2.0", "-0.5", "1.0") "; to = " VECTOR("2.0", "0.5", "1.2") "; " angle " }; };"

/* As it lies on a side of the domain; walls in space turn about the vertical only, so there it
 * is gravity that is turned. */
static void slide(const char *rules, double mu)
{
    const double a = 9.81 * (sin(M_PI / 6) - mu * cos(M_PI / 6));
    char gravity[100];
    struct tank t;

    if (DIM == 2)
        snprintf(gravity, sizeof gravity, "gravity = [%.15e, %.15e];", 9.81 / 2,
                 -9.81 * cos(M_PI / 6));
    else
        snprintf(gravity, sizeof gravity, "gravity = [%.15e, 0.0, %.15e];", 9.81 / 2,
                 -9.81 * cos(M_PI / 6));
    tank_make(&t, PLACE, gravity, SLOPE(""), rules,
              "body = {" BLOCK("it", "0.0", "0.0", "1.275", "softness = 0.1;") "};", NULL);
    tank_run(&t, "cks43", 1e-2, 0.5);
    near(row(&t, "it", "v")[0], 0.5 * a, 4e-3 * a, "v after 0.5 s at 30 degrees");
    tank_free(&t);
}

static void a_block_slides_on_a_wall(void **state)
{
    (void)state;
    slide("", 0.35);
}

/* The last that fits counts, whichever way round it names the two. */
static void a_pair_has_a_friction_of_its_own(void **state)
{
    (void)state;
    slide("contact = { ice = { of = \"wall.slope\"; with = \"body\"; friction = 0.1; }; };", 0.1);
    slide("contact = { all = { of = \"body\"; with = \"wall\"; friction = 0.5; };"
          " ice = { of = \"body.it\"; with = \"wall.slope\"; friction = 0.2; };"
          " else = { of = \"body\"; with = \"body\"; friction = 0.0; }; };", 0.2);
}

/* A wall that turns with a block on it: it sticks, and the wall's work is in the book. */
static void a_turning_wall_carries_a_block(void **state)
{
    struct book_sheet first, last;
    struct tank t;
    double R[DIM][DIM];
    const double angle = 10 * M_PI / 180;

    (void)state;
    tank_make(&t, PLACE HEAVY, SLOPE("spin = 10.0; pivot = " VECTOR("0.0", "0.0", "1.2") ";"),
              "body = {" BLOCK("it", "0.5", "0.0", "1.275", "softness = 0.1;") "};", NULL);
    observe_sheet(t.moment, 0, t.y, &first);
    tank_run(&t, "cks43", 1e-3, 1);
    observe_sheet(t.moment, 1, t.y, &last);
    turning_matrix(row(&t, "it", "turn"), R);
    near(row(&t, "it", "x")[0], 0.5 * cos(angle) - 0.075 * sin(angle), 5e-4, "x");
    near(row(&t, "it", "x")[UP], 1.2 + 0.5 * sin(angle) + 0.075 * cos(angle), 5e-4, "height");
    near(R[UP][0], sin(angle), 2e-4, "sine of its angle");
    near(book_defect(&first, &last), 0, 5e-3, "energy");
    near(book_momentum_defect(&first, &last), 0, 1e-8, "momentum");
    tank_free(&t);
}

/* On a belt it reaches the speed of that in v/(mu g). */
static void a_belt_drags_a_block(void **state)
{
    struct tank t;

    (void)state;
    tank_make(&t, PLACE HEAVY, SLOPE("surface = " VECTOR("1.0", "0.0", "0.0") ";"),
              "body = {" BLOCK("it", "0.0", "0.0", "1.275", "softness = 0.1;") "};", NULL);
    tank_run(&t, "cks43", 1e-3, 0.15);
    near(row(&t, "it", "v")[0], 0.15 * 0.35 * 9.81, 1e-2, "while it slides");
    tank_run(&t, "cks43", 1e-3, 1);
    near(row(&t, "it", "v")[0], 1, 1e-3, "as fast as the belt");
    tank_free(&t);
}

/* --- refusals ------------------------------------------------------------------------ */

static void refused(const char *scene, const char *words)
{
    struct tank t;

    assert_int_equal(tank_try(&t, scene), STATUS_BAD_SCENE);
    check(strstr(status_message(), words) != NULL, "not \"%s\" but: %s", words, status_message());
    tank_free(&t);
}

/* Both are told with their lines in the file that the tank writes. */
static void overlap(const char *scene, const char *first, const char *between, const char *second,
                    const char *words)
{
    const char *path = P_tmpdir "/tank-XXXXXX";
    char expected[200];
    struct tank t;

    assert_int_equal(tank_try(&t, scene), STATUS_BAD_SCENE);
    snprintf(expected, sizeof expected, "%s (%.*s", first, (int)strlen(path) - 6, path);
    check(strstr(status_message(), expected) != NULL, "not \"%s\" but: %s", expected, status_message());
    check(strstr(status_message(), between) != NULL, "not \"%s\" but: %s", between, status_message());
    snprintf(expected, sizeof expected, "%s) overlap at t = 0: %s", second, words);
    check(strstr(status_message(), expected) != NULL, "not \"%s\" but: %s", expected, status_message());
    tank_free(&t);
}

static void overlap_at_the_start_is_refused(void **state)
{
    (void)state;
    overlap(PLACE HEAVY "body = {\n" BLOCK("a", "0.0", "0.0", "1.0", "")
            "\n" BLOCK("b", "0.0", "0.0", "1.148", "") "};",
            "body.a", ":2) and body.b (", ":3", "they are 0.002 m inside each other");
    overlap(PLACE HEAVY "body = {\n" BLOCK("a", "0.0", "0.0", "1.0", "")
            "\n" BLOCK("b", "0.0", "0.0", "1.05", "angle = " TURN("45.0") ";") "};",
            "body.a", ":2) and body.b (", ":3", "they are far inside each other");
    overlap(PLACE HEAVY SLOPE("") "\n body = {\n" BLOCK("a", "0.0", "0.0", "1.25", "") "};",
            "body.a", ":3) and wall.slope (", ":1", "they are");
}

static void rules_that_say_nothing_are_refused(void **state)
{
    (void)state;
    refused(PLACE HEAVY "body = {" BLOCK("a", "0.0", "0.0", "1.0", "") "};"
            "contact = { ice = { of = \"body.a\"; with = \"wall.slope\"; friction = 0.1; }; };",
            "contact.ice: there is no `wall.slope`");
    refused(PLACE HEAVY "body = {" BLOCK("a", "0.0", "0.0", "1.0", "") "};"
            "contact = { ice = { of = \"body.a\"; with = \"side\"; }; };",
            "contact.ice gives neither friction nor restitution");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(balls_bounce_off_each_other),
        cmocka_unit_test(faces_bounce_as_balls),
        cmocka_unit_test(friction_turns_both),
        cmocka_unit_test(power_and_momentum_balance),
#if DIM == 3
        cmocka_unit_test(edge_on_edge),
#endif
        cmocka_unit_test(stacks_rest),
        cmocka_unit_test(a_block_slides_on_a_wall),
        cmocka_unit_test(a_pair_has_a_friction_of_its_own),
        cmocka_unit_test(rules_that_say_nothing_are_refused),
        cmocka_unit_test(a_turning_wall_carries_a_block),
        cmocka_unit_test(a_belt_drags_a_block),
        cmocka_unit_test(overlap_at_the_start_is_refused),
    };

    return cmocka_run_group_tests_name("rigid-contacts", tests, NULL, NULL);
}
