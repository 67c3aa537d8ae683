/* clumps.c -- rigid bodies that are clumps: mass and inertia by volume, what the interlocking of two
 * of them does, rest; and the law of Hertz and Mindlin against A13 and A14b of the catalogue. */
#include "../unit/tank-run.h"
#include "tank.h"

#include "base/status.h"
#include "bodies/rigid-figure.h"
#include "bodies/touch-materials.h"
#include "plan/inside.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { UP = DIM - 1 };

#if DIM == 2
#define HEAD "dimension = 2;"
#define VECTOR(x, y, up) "[" x ", " up "]"
#else
#define HEAD "dimension = 3;"
#define VECTOR(x, y, up) "[" x ", " y ", " up "]"
#endif
#define PLACE                                                                            \
    HEAD "until = 100.0; domain = { from = " VECTOR("-5.0", "-5.0", "0.0") "; to = "     \
    VECTOR("5.0", "5.0", "5.0") "; };"
#define HEAVY "gravity = " VECTOR("0.0", "0.0", "-9.81") ";"

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

/* --- mass and inertia by volume ----------------------------------------------------- */

static void measure(struct rigid_def *d, struct rigid_figure *to)
{
    d->density = 1000;
    if (rigid_figure_make(d, "body.it", to) != STATUS_DONE)
        fail_msg("%s", status_message());
}

/* As the box has them, whatever the balls are. */
static void a_clump_weighs_what_its_box_does(void **state)
{
    struct rigid_def box = { .shape = "box", .size = { 0.3, 0.2, 0.1 } };
    struct rigid_def clump = { .shape = "clump", .of = "box", .size = { 0.3, 0.2, 0.1 }, .radius = 0.04,
                               .pitch = 0.03 };
    struct rigid_figure a, b;

    (void)state;
    measure(&box, &a);
    measure(&clump, &b);
    near(b.volume, a.volume, 0, "volume");
    for (int i = 0; i < TURNING_SPINS; i++)
        near(b.gyration[i], a.gyration[i], 0, "gyration");
    for (int k = 0; k < DIM; k++)
        near(b.span[k], box.size[k], 1e-15, "its balls touch the faces");
    check(b.kernels > 20, "%d balls", b.kernels);
    rigid_figure_free(&a);
    rigid_figure_free(&b);
}

/* Two balls of radius 1 with centres 2 a apart along x: each is cut at the plane between them.
 * Integrals of 1 and x^2 over what is left of the right one, and of y^2, in closed form. */
static double ball_until(double a, int power, bool aside)
{
    const int n = 400000;
    double sum = 0;

    for (int i = 0; i < n; i++) { /* the rule of midpoints across, closed form along a disc */
        const double x = -a + (i + 0.5) / n * (1 + a), r2 = 1 - x * x;
        const double all = DIM == 2 ? 2 * sqrt(r2) : M_PI * r2;
        const double second = DIM == 2 ? 2 * r2 * sqrt(r2) / 3 : M_PI * r2 * r2 / 4;
        sum += aside ? second : all * pow(x + a, power);
    }
    return 2 * sum * (1 + a) / n;
}

/* What both have counts once; the centre and the axes of a pair that lies aslant. */
static void what_overlaps_counts_once(void **state)
{
    const double a = 0.4, c = 0.8, s = 0.6;
    double x[2][3] = { { 1 - a * c, 2 - a * s, 0 }, { 1 + a * c, 2 + a * s, 0 } };
    struct rigid_def d = { .shape = "clump", .of = "box", .points = { 2, x }, .radius = 1 };
    const double volume = ball_until(a, 0, false), along = ball_until(a, 2, false) / volume;
    const double aside = ball_until(a, 0, true) / volume;
    struct rigid_figure f;

    (void)state;
    near(DIM == 2 ? 2 * (M_PI - acos(a) + a * sqrt(1 - a * a))
                  : 8 * M_PI / 3 - M_PI * (4 + 2 * a) * (2 - 2 * a) * (2 - 2 * a) / 12, volume,
         1e-6, "volume in closed form");
    measure(&d, &f);
    near(f.volume, volume, 1e-4 * volume, "volume");
    near(f.surface, DIM == 2 ? 4 * (M_PI - acos(a)) : 4 * M_PI * (1 + a), 5e-3 * f.surface, "surface");
    near(f.centre[0], 1, 1e-4, "centre");
    near(f.centre[1], 2, 1e-4, "centre");
    near(f.gyration[DIM == 2 ? 0 : 2], along + aside, 1e-4, "inertia across the line");
    if (DIM == 3)
        near(f.gyration[0], 2 * aside, 1e-4, "inertia about the line");
    rigid_figure_free(&f);
}

/* --- made from other shapes --------------------------------------------------------- */

#if DIM == 2
static double house[][3] = { { 0, 0 }, { 0.3, 0 }, { 0.3, 0.2 }, { 0.1, 0.3 } };
static double boot[][3] = { { 0, 0 }, { 0, 0.3 }, { 0.1, 0.3 }, { 0.1, 0.1 }, { 0.3, 0.15 }, { 0.25, 0 } };
static const struct rigid_def outer[] = {
    { .shape = "disc", .radius = 0.1 },
    { .shape = "polygon", .points = { 4, house } },
    { .shape = "polygon", .points = { 6, boot } },
};
#else
static double house[][3] = { { 0, 0, 0 }, { 0.3, 0, 0 }, { 0, 0.2, 0 }, { 0, 0, 0.2 }, { 0.3, 0.2, 0 } };
static const struct rigid_def outer[] = {
    { .shape = "sphere", .radius = 0.1 },
    { .shape = "cylinder", .radius = 0.1, .height = 0.25 },
    { .shape = "hull", .points = { 5, house } },
};
#endif

/* How far the nearest other ball is. */
static double neighbour(const struct rigid_figure *f, int i)
{
    double least = HUGE_VAL;

    for (int k = 0; k < f->kernels; k++) {
        double square = 0;
        for (int d = 0; d < DIM; d++)
            square += pow(f->kernel[i].x[0][d] - f->kernel[k].x[0][d], 2);
        least = k != i ? fmin(least, sqrt(square)) : least;
    }
    return least;
}

/* Balls touch the surface from inside, a pitch apart or nearly so (a third more in the middle of a round end); all else is that of the shape. */
static void balls_line(const struct rigid_def *shape)
{
    struct rigid_def def = *shape, made = *shape;
    struct rigid_figure a, b;

    made.of = shape->shape;
    made.shape = "clump";
    made.body_radius = shape->radius;
    made.radius = 0.02;
    made.pitch = 0.015;
    measure(&def, &a);
    measure(&made, &b);
    printf("# %s: %d balls\n", shape->shape, b.kernels);
    near(b.volume, a.volume, 0, "volume");
    for (int i = 0; i < TURNING_SPINS; i++)
        near(b.gyration[i], a.gyration[i], 0, "gyration");
    for (int d = 0; d < DIM; d++) {
        near(made.at[d], def.at[d], 0, "place of the centre");
        near(b.span[d], a.span[d], shape->points.n ? 0.1 : 1e-3, "span");
    }
    check(b.kernels > (DIM == 2 ? 30 : 150), "%d balls only", b.kernels);
    for (int i = 0; i < b.kernels; i++) {
        near(a.form->depth(&a, b.kernel[i].x[0]), 0.02, a.parts > 1 ? 4e-4 : 1e-9, "depth of a ball");
        const double gap = neighbour(&b, i);
        check(gap > 0.004 && gap < 0.0201 + 1e-9, "the nearest ball is %g m away, and a pitch is 0.015 m", gap);
    }
    rigid_figure_free(&a);
    rigid_figure_free(&b);
}

static void balls_line_all_shapes(void **state)
{
    (void)state;
    for (int i = 0; i < (int)(sizeof outer / sizeof *outer); i++)
        balls_line(&outer[i]);
}

/* --- interlocking ------------------------------------------------------------------- */

/* A block of discs or balls of `radius` in units of a pitch of 15 mm, on a larger one that is
 * held, ball upon ball, without friction; how far it has gone after 0.25 s on that slope. */
static double slide(double radius, double degrees)
{
    const double s = 0.015, r = radius * s, across = 9.81 * sin(degrees * M_PI / 180);
    const int rows = DIM == 2 ? 9 : 2;
    const double side = rows * s + 2 * r, base = (rows + 4) * s + 2 * r;
    const double up = 9.81 * cos(degrees * M_PI / 180);
    char text[1500];
    struct tank t;

#if DIM == 2
#define THREE(x, z) "[" x ", " z "]"
#define SIDES "[%.15f, %.15f]"
#define EACH(l) l, l
#else
#define THREE(x, z) "[" x ", 0.0, " z "]"
#define SIDES "[%.15f, %.15f, %.15f]"
#define EACH(l) l, l, l
#endif
    snprintf(text, sizeof text, HEAD "until = 1.0; domain = { from = " VECTOR("-5.0", "-5.0", "-5.0")
             "; to = " VECTOR("5.0", "5.0", "5.0") "; }; gravity = " THREE("%.15f", "%.15f") ";"
             "body = { base = { shape = \"clump\"; at = " THREE("0.0", "%.15f") "; size = " SIDES
             "; radius = %.15f; pitch = 0.015; mass = 9.0; held = [\"x\", \"y\", %s \"turn\"]; friction = 0.0; };"
             "it = { shape = \"clump\"; at = " THREE("0.0", "%.15f") "; size = " SIDES
             "; radius = %.15f; pitch = 0.015; mass = 2.7; friction = 0.0; }; };", across, -up, -base / 2,
             EACH(base), r, DIM == 2 ? "" : "\"z\",", side / 2 + 1e-6, EACH(side), r);
    tank_make(&t, text, NULL);
    tank_run(&t, "cks43", 1e-2, 0.25);
    const double gone = row(&t, "it", "x")[0];
    tank_free(&t);
    return gone;
}

/* Told in doc/seed-003.md: faces of small balls catch after half a pitch, those of large ones let go. */
static void faces_of_balls_interlock(void **state)
{
    (void)state;
    for (int degrees = DIM == 2 ? 5 : 10; degrees <= 10; degrees += 5) {
        const double smooth = 0.5 * 9.81 * sin(degrees * M_PI / 180) * 0.25 * 0.25;
        near(slide(0.32, degrees), 0.0075, 3e-4, "radius 0.32 of a pitch: stuck after half a pitch");
        near(slide(0.5, degrees), 0.0075, 3e-4, "half a pitch: stuck after half a pitch");
        near(slide(1.1, degrees), smooth, 0.15 * smooth, "1.1 pitches: it slides, nearly as on a plane");
    }
}

/* --- rest, impact, books ------------------------------------------------------------ */

#define CLUMP(keys) "body = { it = { shape = \"clump\"; size = " VECTOR("0.15", "0.15", "0.15") \
    "; radius = 0.03; pitch = 0.045; mass = 2.7; stops = [\"bottom\"];" keys "}; };"

static double book_of(const struct tank *t)
{
    const double *book = t->y + layout_at(&t->plan->layout, t->plan->book.row);

    return book[t->plan->book.contacts] + book[t->plan->book.contacts + 1];
}

/* Put on a slope of 15 degrees, with friction that holds it. */
static void a_clump_rests_on_a_slope(void **state)
{
    struct tank t;

    (void)state;
    tank_make(&t, PLACE "gravity = " VECTOR("2.5390", "0.0", "-9.4757") ";"
              CLUMP("at = " VECTOR("0.0", "0.0", "0.075") "; friction = 0.35; margin = 0.005; softness = 0.1;"), NULL);
    tank_run(&t, "cks43", 1e-2, 1.5);
    const double at = row(&t, "it", "x")[0];
    near(at, 0, 1e-4, "slipped until it stuck [m]");
    near(row(&t, "it", "x")[UP], 0.075, 5e-5, "height");
    near(row(&t, "it", "v")[0], 0, 1e-9, "creep [m/s]");
    tank_free(&t);
}

/* One that hits the floor turned, elastically, with friction: what it has is what contacts took. */
static void the_book_of_a_clump_closes(void **state)
{
    double *v, *spin, energy;
    struct tank t;

    (void)state;
    tank_make(&t, PLACE HEAVY CLUMP("at = " VECTOR("0.0", "0.0", "0.2") "; angle = "
#if DIM == 2
              "24.0"
#else
              "[20.0, 10.0, 5.0]"
#endif
              "; velocity = " VECTOR("1.0", "0.0", "-1.0") ";"), NULL);
    energy = 2.7 * (9.81 * 0.2 + 1);
    tank_run(&t, "erk4", 1e-4, 0.3);
    v = row(&t, "it", "v");
    spin = row(&t, "it", "spin");
    const double gave = book_of(&t);
    double now = 2.7 * 9.81 * row(&t, "it", "x")[UP];
    for (int d = 0; d < DIM; d++)
        now += 0.5 * 2.7 * v[d] * v[d];
    for (int i = 0; i < TURNING_SPINS; i++)
        now += 0.5 * 2.7 / 6 * 0.15 * 0.15 * spin[i] * spin[i];
    check(gave < -0.5, "contacts took %g J only", -gave);
    near(now - energy, gave, 1e-4 * energy, "energy lost is that of the book [J]");
    tank_free(&t);
}

/* --- refusals ----------------------------------------------------------------------- */

static void refused(const char *rest, const char *words)
{
    char scene[1500];
    struct tank t;

    snprintf(scene, sizeof scene, "%s %s", PLACE HEAVY, rest);
    assert_int_equal(tank_try(&t, scene), STATUS_BAD_SCENE);
    check(strstr(status_message(), words), "\"%s\" does not say \"%s\"", status_message(), words);
    status_clear();
    tank_free(&t);
}

#define AT "at = " VECTOR("0.0", "0.0", "1.0") "; mass = 1.0; shape = \"clump\";"
#define SIZE "size = " VECTOR("0.3", "0.3", "0.3") ";"
#define BALL_AT(x) VECTOR(x, "0.0", "1.0")

#if DIM == 2
#define LIKE "disc"
#else
#define LIKE "sphere"
#endif
#define LIKED "of = \"" LIKE "\"; body_radius = 0.1;"

static void refusals_teach(void **state)
{
    (void)state;
    refused("body = { it = {" AT SIZE "pitch = 0.1; }; };", "without radius it is no clump");
    refused("body = { it = {" AT "radius = 0.1; }; };", "either points");
    refused("body = { it = {" AT SIZE "radius = 0.1; }; };", "pitch");
    refused("body = { it = {" AT SIZE "radius = 0.2; pitch = 0.1; }; };", "do not fit");
    refused("body = { it = {" AT SIZE "radius = 0.0001; pitch = 0.0001; }; };", "at most 2000");
#if DIM == 2
#define ROUND "of = \"disc\";"
#define EDGED "of = \"polygon\";"
    refused("body = { it = {" AT EDGED "radius = 0.06; pitch = 0.02; points = ([0.0, 0.0], [1.0, 0.0], [1.0, 0.1], "
            "[0.4, 0.1], [0.5, 1.0], [0.0, 1.0]); }; };", "no ball of radius 0.06 m touches the side of 0.1 m");
#else
#define ROUND "of = \"cylinder\";"
#define EDGED "of = \"hull\";"
    refused("body = { it = {" AT ROUND "body_radius = 0.1; radius = 0.02; pitch = 0.02; }; };",
            "body.it (of = \"cylinder\"): without height it is no cylinder");
#endif
    refused("body = { it = {" AT ROUND "radius = 0.02; pitch = 0.02; height = 0.1; }; };", "there it is needed");
    refused("body = { it = {" AT ROUND "body_radius = 0.1; radius = 0.02; height = 0.1; }; };", "pitch");
    refused("body = { it = {" AT SIZE "body_radius = 0.1; radius = 0.02; pitch = 0.02; }; };", "body_radius");
    refused("body = { it = {" AT EDGED "radius = 0.02; pitch = 0.02; }; };", "without points it is no");
    refused("body = { it = {" AT EDGED SIZE "radius = 0.02; pitch = 0.02; points = (" BALL_AT("0.0") ", "
            BALL_AT("0.1") "); }; };", "has no size");
    refused("body = { it = { of = \"" LIKE "\"; at = " BALL_AT("0.0") "; mass = 1.0;" SIZE "}; };", "a box has no of");
    refused("body = { it = {" AT LIKED "radius = 0.11; pitch = 0.02; }; };", "do not fit");
    refused("body = { it = {" AT LIKED "radius = 0.001; pitch = 0.0001; }; };", "at most 2000");
    refused("body = { it = { at = " BALL_AT("0.0") "; mass = 1.0; size = " VECTOR("0.3", "0.3", "0.3")
            "; pitch = 0.1; }; };", "has no pitch");
#if DIM == 3
#define MANY(name, up) name " = { at = [0.0, 0.0, " up "]; mass = 1.0; shape = \"clump\";" SIZE     \
    "radius = 0.01; pitch = 0.016; };"
    refused("body = {" MANY("a", "1.0") MANY("b", "2.0") "};", "a larger pitch");
#define TWO "body = { a = { shape = \"sphere\"; at = [0.0, 0.0, 1.0]; radius = 0.1; mass = 1.0; }; "  \
    "b = { shape = \"sphere\"; at = [0.3, 0.0, 1.0]; radius = 0.1; mass = 1.0; }; };"
    refused(TWO "contact = { all = { of = \"body\"; with = \"body\"; law = \"hertz-mindlin\"; }; };",
            "needs young");
    refused(TWO "contact = { all = { of = \"body\"; with = \"body\"; young = 1e9; friction = 0.1; }; };",
            "young belongs to");
    refused(TWO "contact = { all = { of = \"body\"; with = \"body\"; law = \"hertz-mindlin\"; "
            "young = 100.0; }; };", "a larger young");
#else
    refused("body = { it = {" AT SIZE "radius = 0.1; pitch = 0.1; stops = [\"bottom\"]; }; };"
            "contact = { all = { of = \"body\"; with = \"side\"; law = \"hertz-mindlin\"; "
            "young = 1e9; }; };", "dimension = 3");
#endif
}

/* --- Hertz and Mindlin -------------------------------------------------------------- */

#if DIM == 3

static FILE *reference(const char *name)
{
    const char *top = getenv("top_srcdir");
    char path[500];
    FILE *file;

    snprintf(path, sizeof path, "%s/data/reference/%s", top ? top : ".", name);
    file = fopen(path, "r");
    check(file != NULL, "%s cannot be read", path);
    return file;
}

/* One impact of A13, without loss: a ball on the floor, or another that comes from above. */
static void impact(const char *name, const double *n)
{
    const double radius = n[0], v = n[1], elastic = n[2], mass = n[4] == 0 ? 0 : n[4], deep = n[5];
    const bool wall = n[3] == radius;
    const double young = 2 * elastic * (1 - 0.3 * 0.3), step = n[7] / 400;
    struct touch_material m[2] = { { young, 0.3 }, { young, 0.3 } };
    struct touch_law law;
    double x = 0, speed = v, most = 0, depth, force[3], rub[3], xi[3] = { 0 }, rate[3], t = 0;

    near(touch_materials_elastic(&m[0], &m[1]) / elastic, 1, 1e-12, "E*");
    law = touch_materials_law(m, wall ? radius : radius / 2, mass, v, 1, 0, &depth);
    near(depth / deep, 1, 1e-6, name);
    for (; x >= 0; t += step) { /* leapfrog */
        struct touch_place at = { .depth = x, .rate = speed, .normal = { 0, 0, 1 }, .mass = mass };
        at.depth = x += 0.5 * step * speed;
        touch(&law, &at, xi, force, rub, rate);
        speed -= step * force[2] / mass;
        x += 0.5 * step * speed;
        most = fmax(most, x);
    }
    near(most / deep, 1, 5e-3, "deepest");
    near(t / n[7], 1, 5e-3, "time of contact");
    near(law.k * pow(deep, 1.5) / n[6], 1, 1e-5, "largest force");
}

/* All impacts of A13. */
static void impacts_are_those_of_hertz(void **state)
{
    FILE *file = reference("A13_hertz_impact.csv");
    char line[400], name[100];
    double n[8];
    int rows = 0;

    (void)state;
    while (fgets(line, sizeof line, file))
        if (sscanf(line, "%99[^,],%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", name, &n[0], &n[1], &n[2], &n[3],
                   &n[4], &n[5], &n[6], &n[7]) == 9) {
            impact(name, n);
            rows++;
        }
    fclose(file);
    assert_int_equal(rows, 6);
}

/* A scene's: the softest of A13, by the program's own steps, and the restitution that is asked for. */
static void a_ball_bounces_as_hertz_says(void **state)
{
    const double asked[] = { 1, 0.6 };
    char text[600];
    struct tank t;

    (void)state;
    for (int i = 0; i < 2; i++) {
        snprintf(text, sizeof text, PLACE "gravity = [0.0, 0.0, 0.0]; body = { it = { shape = \"sphere\"; "
                 "at = [0.0, 0.0, 0.05]; radius = 0.05; mass = 0.41887902; stops = [\"bottom\"]; "
                 "velocity = [0.0, 0.0, -1.0]; }; }; contact = { floor = { of = \"body\"; with = \"side\"; "
                 "law = \"hertz-mindlin\"; young = 1e6; young_with = 1e15; restitution = %g; }; };",
                 asked[i]);
        tank_make(&t, text, NULL);
        tank_run(&t, "erk4", 1e-5, 0.5 * 0.014134399);
        if (i == 0)
            near(0.05 - row(&t, "it", "x")[2], 0.0048022693, 2.4e-5, "deepest, at half of the time");
        tank_free(&t);
        tank_make(&t, text, NULL);
        tank_run(&t, "erk4", 1e-5, 0.1);
        near(row(&t, "it", "v")[2], asked[i], 1e-3, "speed after it [m/s]");
        tank_free(&t);
    }
}

/* delta by delta_s at which the spring holds that share of mu N, by A14b. */
static double drawn(const struct touch_law *law, double depth, double slide, double share)
{
    const double N = law->k * pow(depth, 1.5), v = 1e-3 * slide / law->tau, h = 0.05 * law->tau;
    struct touch_place at = { .depth = depth, .normal = { 0, 0, 1 }, .velocity = { v }, .mass = 1e-12 };
    double xi[3] = { 0 }, rate[3], middle[3], press[3], rub[3] = { 0 }, gone = 0;

    while (-rub[0] < share * law->mu * N && gone < 3 * slide) {
        touch(law, &at, xi, press, rub, rate);
        for (int d = 0; d < 3; d++)
            middle[d] = xi[d] + 0.5 * h * rate[d];
        touch(law, &at, middle, press, rub, rate);
        for (int d = 0; d < 3; d++)
            xi[d] += h * rate[d];
        gone += v * h;
        touch(law, &at, xi, press, rub, rate);
    }
    return gone / slide;
}

/* The whole curve, and its beginning 8 a G*. */
static void rubbing_follows_mindlin(void **state)
{
    const struct touch_material m[2] = { { 3e9, 0.3 }, { 2.1e11, 0.3 } };
    const double R = 0.01, deep = 2e-5, mu = 0.35;
    const double shear = touch_materials_shear(&m[0], &m[1]);
    double depth, share, expected;
    struct touch_law law = touch_materials_law(m, R, 1, 1, 0.6, mu, &depth);
    const double N = law.k * pow(deep, 1.5), slide = 3 * mu * N / (16 * sqrt(R * deep) * shear);
    FILE *file = reference("A14b_mindlin_tangential.csv");
    char line[400];
    int rows = 0;

    (void)state;
    near(1 / shear, 2 * 1.7 * 1.3 / 3e9 + 2 * 1.7 * 1.3 / 2.1e11, 1e-15, "1/G*");
    while (fgets(line, sizeof line, file))
        if (sscanf(line, "%lf,%lf", &share, &expected) == 2 && share > 0 && share < 1) {
            near(drawn(&law, deep, slide, share), expected, 0.02, "bend by that at which all slides");
            rows++;
        }
    fclose(file);
    assert_int_equal(rows, 11);
}

#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_clump_weighs_what_its_box_does),
        cmocka_unit_test(what_overlaps_counts_once),
        cmocka_unit_test(balls_line_all_shapes),
        cmocka_unit_test(faces_of_balls_interlock),
        cmocka_unit_test(a_clump_rests_on_a_slope),
        cmocka_unit_test(the_book_of_a_clump_closes),
        cmocka_unit_test(refusals_teach),
#if DIM == 3
        cmocka_unit_test(impacts_are_those_of_hertz),
        cmocka_unit_test(a_ball_bounces_as_hertz_says),
        cmocka_unit_test(rubbing_follows_mindlin),
#endif
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
