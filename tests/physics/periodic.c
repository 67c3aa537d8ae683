/* periodic.c -- directions that repeat: rates are those of a tank that explicit copies
 * surround, do not depend on where the sides lie, and keep the books. */
#include "tank.h"

#include "base/status.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

/* Cells of 8 x 8 (3D: 6 x 6 x 6) spacings, H = 2.5 dx. */
#if DIM == 2
#define HEAD                                                                             \
    "dimension = 2; until = 1.0; spacing = 0.01; gravity = [0.3, 0.0]; eos = { c0 = 20.0; };"
#define CELL HEAD "domain = { from = [0.0, 0.0]; to = [0.08, 0.08]; periodic = "
#define WATER " }; fluid = { water = { type = \"box\"; from = [0.0, 0.0]; to = [0.08, 0.08]; }; };"
static const char *const everywhere = CELL "[\"x\", \"y\"]" WATER;
static const char *const across = CELL "[\"x\"]" WATER;
static const char *const copies = HEAD
    "domain = { from = [-0.08, -0.08]; to = [0.16, 0.16]; };"
    "fluid = { water = { type = \"box\"; from = [-0.08, -0.08]; to = [0.16, 0.16]; }; };";
static const char *const copies_across = HEAD
    "domain = { from = [-0.08, 0.0]; to = [0.16, 0.08]; open = [\"left\", \"right\"]; };"
    "fluid = { water = { type = \"box\"; from = [-0.08, 0.0]; to = [0.16, 0.08]; }; };";
#define VELOCITY "[0.7, 0.1]"
static const double cell = 0.08;
#else
#define HEAD                                                                             \
    "dimension = 3; until = 1.0; spacing = 0.01; gravity = [0.3, 0.0, 0.0]; eos = { c0 = 20.0; };"
#define CELL HEAD "domain = { from = [0.0, 0.0, 0.0]; to = [0.06, 0.06, 0.06]; periodic = "
#define WATER                                                                            \
    " }; fluid = { water = { type = \"box\"; from = [0.0, 0.0, 0.0]; to = [0.06, 0.06, 0.06]; }; };"
static const char *const everywhere = CELL "[\"x\", \"y\", \"z\"]" WATER;
static const char *const across = CELL "[\"x\", \"y\"]" WATER;
static const char *const copies = HEAD
    "domain = { from = [-0.06, -0.06, -0.06]; to = [0.12, 0.12, 0.12]; };"
    "fluid = { water = { from = [-0.06, -0.06, -0.06]; to = [0.12, 0.12, 0.12]; }; };";
static const char *const copies_across = HEAD
    "domain = { from = [-0.06, -0.06, 0.0]; to = [0.12, 0.12, 0.06];"
    "  open = [\"left\", \"right\", \"front\", \"back\"]; };"
    "fluid = { water = { from = [-0.06, -0.06, 0.0]; to = [0.12, 0.12, 0.06]; }; };";
#define VELOCITY "[0.7, -0.4, 0.1]"
static const double cell = 0.06;
#endif

#define SLIDING "wall = { tank = { type = \"frame\"; velocity = " VELOCITY "; }; };"

/* Every way to a density, every wall model, every viscosity. */
static const char *const physics[] = {
    "walls = \"own-density\";" TANK_EFFECTS TANK_ONE_KERNEL,
    "walls = \"ghost\"; effects = { summation = { }; pressure = { };"
    " laplacian-viscosity = { mu = 5.0; }; };" TANK_SEED_KERNELS,
    "walls = \"adami\";" TANK_EFFECTS TANK_ONE_KERNEL,
    "walls = \"contact\";" TANK_EFFECTS TANK_ONE_KERNEL,
};
enum { PHYSICS = sizeof physics / sizeof physics[0] };

static const double when = 0.013; /* [s]: walls have slid by nearly a spacing */

static void make(struct tank *t, const char *scene, const char *walls, const char *effects)
{
    tank_make(t, scene, walls, effects, NULL);
    tank_shake(t, 5, 0.2, 1.0, 0.02);
}

/* --- explicit copies ---------------------------------------------------------------- */

/* Particle i of the tank stands where particle of[i] of the cell does, so many cells away. */
struct copy {
    int *of;
    int (*away)[DIM];
};

static bool stands(const struct particles *big, int i, const struct particles *small, int j,
                   int *away)
{
    if (big->object[big->object_of[i]].kind != small->object[small->object_of[j]].kind)
        return false;
    for (int d = 0; d < DIM; d++) {
        const double cells = (big->x0[i][d] - small->x0[j][d]) / cell;
        away[d] = (int)lrint(cells);
        if (fabs(cells - away[d]) > 1e-6)
            return false;
    }
    return true;
}

static struct copy copies_of(const struct tank *tank, const struct tank *one)
{
    const struct particles *big = plan_particles(tank->plan), *small = plan_particles(one->plan);
    struct copy c = { test_malloc(big->n * sizeof *c.of), test_malloc(big->n * sizeof *c.away) };

    for (int i = 0; i < big->n; i++) {
        int j = 0;
        while (j < small->n && !stands(big, i, small, j, c.away[i]))
            j++;
        check(j < small->n, "no particle stands like particle %d", i);
        c.of[i] = j;
    }
    return c;
}

/* Which kind a row of y speaks of. */
static enum kind kind_of(const struct layout_row *r)
{
    return strstr(r->name, "fluid") ? KIND_FLUID : KIND_WALL;
}

/* The tank's y from that of the cell. */
static void spread(struct tank *tank, const struct tank *one, const struct copy *c)
{
    const struct layout *l = plan_layout(tank->plan);

    for (int i = 0; i < l->rows; i++) {
        const struct layout_row *to = &l->row[i], *from;
        const long at = tank_at(one, to->name, &from);
        const int first = plan_particles(tank->plan)->from[kind_of(to)];
        const int first_of = plan_particles(one->plan)->from[kind_of(to)];
        if (strcmp(to->name, "book") == 0)
            continue;
        for (int k = 0; k < to->n * to->components; k++) {
            const int p = first + k / to->components, d = k % to->components;
            tank->y[to->offset + k] = one->y[at + (c->of[p] - first_of) * to->components + d];
            if (strncmp(to->name, "position", 8) == 0)
                tank->y[to->offset + k] += c->away[p][d] * cell;
        }
    }
}

static void check_middle(const struct tank *tank, const struct tank *one, const struct copy *c,
                         const char *what)
{
    const struct layout *l = plan_layout(tank->plan);

    for (int i = 0; i < l->rows; i++) {
        const struct layout_row *to = &l->row[i], *from;
        const long at = tank_at(one, to->name, &from);
        const int first = plan_particles(tank->plan)->from[kind_of(to)];
        const int first_of = plan_particles(one->plan)->from[kind_of(to)];
        double most = 0;
        int compared = 0;
        if (strcmp(to->name, "book") == 0)
            continue;
        for (int k = 0; k < from->n * from->components; k++)
            most = fmax(most, fabs(one->ydot[at + k]));
        for (int k = 0; k < to->n * to->components; k++) {
            const int p = first + k / to->components, d = k % to->components;
            const double a = tank->ydot[to->offset + k];
            const double b = one->ydot[at + (c->of[p] - first_of) * to->components + d];
            bool middle = true;
            for (int e = 0; e < DIM; e++)
                middle &= c->away[p][e] == 0;
            check(!middle || fabs(a - b) <= 1e-11 * most, "%s\n%s, number %d: %.15g among copies, "
                  "%.15g where it repeats", what, to->name, k, a, b);
            compared += middle;
        }
        check(most > 0 && compared == from->n * from->components, "%s\n%s: the test is void", what,
              to->name);
    }
}

static void images_are_like_copies(void **state)
{
    (void)state;
    for (int which = 0; which < PHYSICS; which++)
        for (int walls = 0; walls < 2; walls++) {
            struct tank one, tank;
            struct copy c;

            if (!walls && strstr(physics[which], "adami"))
                continue;
            if (DIM == 3 && strstr(physics[which], "contact")) /* sees three supports far */
                continue;
            make(&one, walls ? across : everywhere, walls ? SLIDING : "", physics[which]);
            make(&tank, walls ? copies_across : copies, walls ? SLIDING : "", physics[which]);
            c = copies_of(&tank, &one);
            spread(&tank, &one, &c);
            tank_rates(&one, when, one.y, one.ydot);
            tank_rates(&tank, when, tank.y, tank.ydot);
            check_middle(&tank, &one, &c, physics[which]);
            test_free(c.of);
            test_free(c.away);
            tank_free(&one);
            tank_free(&tank);
        }
}

/* --- where the sides lie ------------------------------------------------------------- */

static void check_close(const struct tank *t, const double *a, const double *b, double tolerance,
                        const char *what)
{
    const struct layout *l = plan_layout(t->plan);

    for (int i = 0; i < l->rows; i++) {
        const struct layout_row *r = &l->row[i];
        double most = 0;
        for (long k = 0; k < (long)r->n * r->components; k++)
            most = fmax(most, fabs(a[r->offset + k]));
        for (long k = 0; k < (long)r->n * r->components; k++)
            check(fabs(a[r->offset + k] - b[r->offset + k]) <= tolerance * most,
                  "%s: %s, number %ld: %.15g and %.15g", what, r->name, k, a[r->offset + k],
                  b[r->offset + k]);
    }
}

/* All moved by half a cell; each by lengths of its own; both by a new list. */
static void sides_may_lie_anywhere(void **state)
{
    (void)state;
    for (int which = 0; which < 2; which++) {
        struct tank t;
        const struct layout_row *r;
        unsigned seed = 11;

        make(&t, everywhere, "", physics[which]);
        const long at = tank_at(&t, "position of fluid", &r);
        double *first = test_calloc(t.n, sizeof *first), *y = tank_copy(&t, t.y);
        tank_rates(&t, 0, y, first);
        for (int k = 0; k < r->n * DIM; k++)
            y[at + k] += 0.5 * cell;
        tank_rates(&t, 0, y, t.ydot);
        check_close(&t, first, t.ydot, 1e-11, "half a cell further");
        for (int k = 0; k < r->n * DIM; k++)
            y[at + k] = t.y[at + k] + cell * rint(3 * tank_random(&seed));
        tank_rates(&t, 0, y, t.ydot);
        check_close(&t, first, t.ydot, 1e-11, "cells away");
        check(moment_counts(t.moment)->rebuilds >= 3, "the list was made anew");
        test_free(first);
        test_free(y);
        tank_free(&t);
    }
}

static double potential(struct tank *t, const double *y, double *mass)
{
    struct book_sheet s;

    observe_sheet(t->moment, 0, y, &s);
    *mass = s.mass;
    return s.energy.potential;
}

/* All drift through the sides and around twice, in one shape: nothing changes, whether
 * the list is made anew or not, but that they fall along the gravity that drives them. */
static void crossing_a_side_changes_nothing(void **state)
{
    const struct layout_row *r;
    struct tank t;
    double mass;

    (void)state;
    make(&t, everywhere, "", physics[0]);
    const long at = tank_at(&t, "position of fluid", &r);
    double *first = test_calloc(t.n, sizeof *first), *y = tank_copy(&t, t.y);
    tank_rates(&t, 0, y, first);
    const double high = potential(&t, y, &mass), g = plan_scales(t.plan)->g[0];
    for (int move = 1; move <= 200; move++) {
        const double fallen = move * cell / 97.0;
        for (int k = 0; k < r->n * DIM; k++)
            y[at + k] = t.y[at + k] + move * cell / (k % DIM ? -131.0 : 97.0);
        tank_rates(&t, 0, y, t.ydot);
        check_close(&t, first, t.ydot, 1e-11, "on the way");
        check(fabs(high - potential(&t, y, &mass) - mass * g * fallen) < 1e-10 * mass * g * cell,
              "%g m down, %g J of %g J", fallen, high - potential(&t, y, &mass),
              mass * g * fallen);
    }
    check(moment_counts(t.moment)->rebuilds > 10 && moment_counts(t.moment)->rebuilds < 190,
          "%ld lists: some are kept, some are not", moment_counts(t.moment)->rebuilds);
    test_free(first);
    test_free(y);
    tank_free(&t);
}

/* --- books -------------------------------------------------------------------------- */

static void momentum_closes(void **state)
{
    (void)state;
    for (int which = 0; which < PHYSICS; which++)
        for (int walls = 0; walls < 2; walls++) {
            struct tank t;

            make(&t, walls ? across : everywhere, walls ? SLIDING : "",
                 physics[walls || which < 2 ? which : 0]);
            const struct particles *p = plan_particles(t.plan);
            const double *g = plan_scales(t.plan)->g;
            const double *udot = t.ydot + tank_at(&t, "velocity of fluid", NULL);
            tank_rates(&t, when, t.y, t.ydot);
            for (int d = 0; d < DIM; d++) {
                double sum = 0, size = 0;
                for (int i = 0; i < particles_count(p, KIND_FLUID); i++) {
                    sum += p->m[i] * (udot[i * DIM + d] - g[d]);
                    size += p->m[i] * fabs(udot[i * DIM + d]);
                }
                for (int o = 0; o < p->objects; o++)
                    sum += p->object[o].kind == KIND_FLUID ? 0 : moment_force(t.moment, o)[d];
                check(fabs(sum) <= 1e-12 * size, "%s\ndirection %d: %g N of %g N come from nowhere",
                      physics[which], d, sum, size);
            }
            tank_free(&t);
        }
}

/* What energy changed beside the booked works, at y + h ydot [J]. */
static double defect_at(struct tank *t, double h)
{
    double *y = tank_copy(t, t->y), defect;
    struct book_sheet s;

    for (long i = 0; i < t->n; i++)
        y[i] += h * t->ydot[i];
    observe_sheet(t->moment, when + h, y, &s);
    defect = s.total - s.pressure_defect;
    for (int i = 0; i < s.works; i++)
        defect -= s.work[i];
    test_free(y);
    return defect;
}

static void energy_closes(void **state)
{
    static const double step = 2e-8; /* [s] */

    (void)state;
    for (int which = 0; which < PHYSICS; which++)
        for (int walls = 0; walls < 2; walls++) {
            double size = 0, slope;
            struct tank t;

            make(&t, walls ? across : everywhere, walls ? SLIDING : "",
                 physics[walls || which < 2 ? which : 0]);
            const struct particles *p = plan_particles(t.plan);
            const long at = tank_at(&t, "velocity of fluid", NULL);
            tank_rates(&t, when, t.y, t.ydot);
            for (int k = 0; k < particles_count(p, KIND_FLUID) * DIM; k++)
                size += p->m[k / DIM] * fabs(t.y[at + k] * t.ydot[at + k]);
            slope = (8 * (defect_at(&t, step) - defect_at(&t, -step))
                     - (defect_at(&t, 2 * step) - defect_at(&t, -2 * step))) / (12 * step);
            check(fabs(slope) <= 1e-8 * size, "%s\nenergy changes by %g W more than the book says,"
                  " of %g W", physics[which], slope, size);
            tank_free(&t);
        }
}

/* --- the implicit side, threads, refusals ------------------------------------------- */

#define THICK                                                                            \
    "effects = { continuity = { }; pressure = { };"                                      \
    " laminar-viscosity = { mu = 50.0; side = \"implicit\"; }; };" TANK_ONE_KERNEL

/* z - gamma f_I(z) = r: products over images are sums over images. */
static void implicit_viscosity_sees_images(void **state)
{
    static const double gamma = 1e-3; /* [s] */

    (void)state;
    for (int walls = 0; walls < 2; walls++) {
        const struct layout_row *r;
        struct tank t;
        double most = 0;

        make(&t, walls ? across : everywhere, walls ? SLIDING : "", THICK);
        const long at = tank_at(&t, "velocity of fluid", &r);
        double *z = tank_copy(&t, t.y);
        moment_solve_tolerance(t.moment, 1e-9);
        assert_int_equal(moment_solve(t.moment, when, gamma, t.y, z), STATUS_DONE);
        assert_int_equal(moment_eval(t.moment, ASK_IMPLICIT_SIDE, when, z, t.ydot), STATUS_DONE);
        for (int k = 0; k < r->n * DIM; k++) {
            const double left = z[at + k] - gamma * t.ydot[at + k] - t.y[at + k];
            most = fmax(most, fabs(z[at + k] - t.y[at + k]));
            check(fabs(left) < 1e-8, "entry %d: %g m/s are left", k, left);
        }
        check(most > 0.1, "velocities change by %g m/s: the test is void", most);
        test_free(z);
        tank_free(&t);
    }
}

static void set_threads(int n)
{
#ifdef _OPENMP
    omp_set_num_threads(n);
#else
    (void)n;
#endif
}

/* More than 4,096 particles: fewer would not wake all threads that there are. */
static const char *const wide =
#if DIM == 2
    "dimension = 2; until = 1.0; spacing = 0.002; gravity = [0.3, 0.0]; eos = { c0 = 20.0; };"
    "domain = { from = [0.0, 0.0]; to = [0.2, 0.1]; periodic = [\"x\"]; };"
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0]; to = [0.2, 0.1]; }; };"
#else
    "dimension = 3; until = 1.0; spacing = 0.01; gravity = [0.3, 0.0, 0.0]; eos = { c0 = 20.0; };"
    "domain = { from = [0.0, 0.0, 0.0]; to = [0.2, 0.2, 0.12]; periodic = [\"x\", \"y\"]; };"
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0, 0.0]; to = [0.2, 0.2, 0.12]; }; };"
#endif
    SLIDING;

static void threads_and_lanes_do_not_matter(void **state)
{
    static const char *const lanes[] = { "2", "4", "8" };

    (void)state;
    for (int which = 0; which < PHYSICS; which++) {
        double *first = NULL;
        for (int l = 0; l < 3; l++)
            for (int threads = 1; threads <= 4; threads *= 2) {
                struct tank t;
                setenv("STIFFWATER_LANES", lanes[l], 1);
                set_threads(threads);
                make(&t, wide, "", physics[which]);
                tank_rates(&t, when, t.y, t.ydot);
                if (first)
                    assert_memory_equal(first, t.ydot, t.n * sizeof *first);
                else
                    first = tank_copy(&t, t.ydot);
                tank_free(&t);
            }
        test_free(first);
    }
    unsetenv("STIFFWATER_LANES");
    set_threads(2);
}

/* Looking from another place, where more have images, disturbs nothing. */
static void looking_disturbs_nothing(void **state)
{
    const struct layout_row *r;
    struct tank t, other;

    (void)state;
    make(&t, everywhere, "", physics[0]);
    make(&other, everywhere, "", physics[0]);
    const long at = tank_at(&t, "position of fluid", &r);
    double *y = tank_copy(&t, t.y);
    tank_rates(&t, 0, t.y, t.ydot);
    tank_rates(&other, 0, other.y, other.ydot);
    for (int k = 0; k < r->n * DIM; k++) /* all near the sides */
        y[at + k] = 0.5 * y[at + k] * (1 + 0.01 * (k % 7));
    observe_forces(t.moment, 0, y);
    for (int k = 0; k < r->n * DIM; k++)
        t.y[at + k] += 1e-5, other.y[at + k] += 1e-5;
    tank_rates(&t, 0, t.y, t.ydot);
    tank_rates(&other, 0, other.y, other.ydot);
    assert_memory_equal(t.ydot, other.ydot, t.n * sizeof *t.ydot);
    test_free(y);
    tank_free(&t);
    tank_free(&other);
}

static void check_refused(const char *text, const char *sentence)
{
    struct tank t;

    check(tank_try(&t, text) == STATUS_BAD_SCENE, "not refused: %s", text);
    check(strstr(status_message(), sentence), "\"%s\" does not say \"%s\"", status_message(),
          sentence);
    tank_free(&t);
}

#if DIM == 2
#define PLACE(from, to) "from = [" from ", 0.0]; to = [" to ", 0.08];"
#define START "dimension = 2; until = 1.0; spacing = 0.01;"
#define ALONG "gravity = [1.0, 0.0];"
#define BALL                                                                             \
    "domain = { from = [0.0, 0.0]; to = [0.0953, 0.2]; periodic = [\"x\"]; };"            \
    "fluid = { drop = { type = \"disc\"; centre = [0.04765, 0.1]; radius = 0.0476; }; };"
#else
#define PLACE(from, to) "from = [" from ", 0.0, 0.0]; to = [" to ", 0.08, 0.08];"
#define START "dimension = 3; until = 1.0; spacing = 0.01;"
#define ALONG "gravity = [1.0, 0.0, 0.0];"
#define BALL                                                                             \
    "domain = { from = [0.0, 0.0, 0.0]; to = [0.0953, 0.2, 0.2]; periodic = [\"x\"]; };"  \
    "fluid = { drop = { type = \"sphere\"; centre = [0.04765, 0.1, 0.1]; radius = 0.0476; }; };"
#endif
#if DIM == 2 /* two drops that are near each other over a corner only */
#define CORNERS                                                                          \
    "domain = { from = [0.0, 0.0]; to = [0.1, 0.1]; periodic = [\"x\", \"y\"]; };"        \
    "fluid = { a = { type = \"disc\"; centre = [0.0027, 0.0027]; radius = 0.0026; };"     \
    "          b = { type = \"polygon\"; points = [[0.0948, 0.0948], [0.1, 0.0948], [0.1, 0.1]," \
    "                                            [0.0948, 0.1]]; }; };"
#endif
#define EFFECTS "effects = { continuity = { }; pressure = { }; };"
#define PLAIN START "eos = { c0 = 20.0; };" EFFECTS
#define WITHIN(from, to) "domain = { " PLACE(from, to) " periodic = [\"x\"]; };"
#define BOX(from, to) "fluid = { water = { type = \"box\"; " PLACE(from, to) " }; };"

static void what_cannot_repeat_is_refused(void **state)
{
    (void)state;
    check_refused(PLAIN WITHIN("0.0", "0.06") BOX("0.0", "0.06"), "needs at least 0.063 m");
    check_refused(PLAIN WITHIN("0.0", "0.1") BOX("0.05", "0.15"), "reaches over a periodic side");
    check_refused(PLAIN WITHIN("0.0", "0.1") BOX("0.0", "0.1")
                  "wall = { block = { " PLACE("-0.05", "0.1") " }; };",
                  "wall.block reaches over a periodic side");
    check_refused(PLAIN BALL, "fluid.drop overlaps fluid.drop");
#if DIM == 2
    check_refused(PLAIN CORNERS, "two of their particles are 0.0041 m apart");
#endif
    check_refused(START "eos = { c0 = 20.0; };"
                  "effects = { continuity = { }; central-force = { }; };"
                  WITHIN("0.0", "0.1") BOX("0.0", "0.1"), "depends on the place");
    check_refused(START ALONG EFFECTS WITHIN("0.0", "0.1") BOX("0.0", "0.1"), "eos.c0 is needed");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(images_are_like_copies),
        cmocka_unit_test(sides_may_lie_anywhere),
        cmocka_unit_test(crossing_a_side_changes_nothing),
        cmocka_unit_test(momentum_closes),
        cmocka_unit_test(energy_closes),
        cmocka_unit_test(implicit_viscosity_sees_images),
        cmocka_unit_test(threads_and_lanes_do_not_matter),
        cmocka_unit_test(looking_disturbs_nothing),
        cmocka_unit_test(what_cannot_repeat_is_refused),
    };

    return cmocka_run_group_tests_name(DIM == 2 ? "periodic in 2D" : "periodic in 3D", tests, NULL,
                                       NULL);
}
