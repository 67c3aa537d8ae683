/* single.c -- pairs in single precision give what those in double precision give, to the
 * digits they have, for every law, kernel and wall model; exactly opposite forces; the same
 * bits on any lanes and threads; anywhere in the domain. */
#include "tank.h"

#include "eval/inside.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

#define SINGLE "precision = \"single\";"

static const char *const physics[] = {
    TANK_EFFECTS TANK_ONE_KERNEL,
    TANK_EFFECTS TANK_SEED_KERNELS,
    TANK_SLIPS TANK_ONE_KERNEL,
    "walls = \"ghost\"; effects = { summation = { }; pressure = { };"
    " laplacian-viscosity = { mu = 0.7; }; }; eos = { tension = false; };" TANK_SEED_KERNELS,
    "walls = \"adami\"; effects = { continuity = { }; pressure = { }; artificial-stress = { };"
    " stress-viscosity = { mu = 0.7; }; };" TANK_ONE_KERNEL,
    "walls = \"own-density\"; effects = { continuity = { }; pressure-printed = { };"
    " artificial-viscosity = { only_approaching = true; }; };" TANK_ONE_KERNEL,
    TANK_SLIPS "kernel = { support = 2.5; type = \"cubic-spline\"; };",
    TANK_SLIPS "kernel = { support = 2.5; type = \"quintic-spline\"; };",
    TANK_SLIPS "kernel = { support = 2.5; type = \"gauss\"; };",
    TANK_SLIPS "kernel = { support = 2.5; type = \"wendland-c4\"; };",
    TANK_SLIPS "kernel = { support = 2.5; type = \"wendland-c6\"; };",
};
enum { PHYSICS = sizeof physics / sizeof physics[0] };

static void set_threads(int n)
{
#ifdef _OPENMP
    omp_set_num_threads(n);
#else
    (void)n;
#endif
}

static void make(struct tank *t, const char *scene, const char *how, const char *precision)
{
    tank_make(t, scene, tank_frame, how, precision, NULL);
    tank_shake(t, 7, 0.2, 1.0, 0.02);
}

/* The largest difference of a row of y, as a share of its largest entry; not of the book, whose
 * sums may cancel. */
static double difference(const struct tank *t, const double *a, const double *b, char *where,
                         size_t room)
{
    const struct layout *l = plan_layout(t->plan);
    double worst = 0;

    for (int i = 0; i < l->rows; i++) {
        const struct layout_row *r = &l->row[i];
        double size = 0, off = 0;
        if (!strstr(r->name, " of "))
            continue;
        for (long k = r->offset; k < r->offset + (long)r->n * r->components; k++) {
            size = fmax(size, fabs(a[k]));
            off = fmax(off, fabs(a[k] - b[k]));
        }
        if (size > 0 && !(off / size <= worst)) {
            worst = off / size;
            snprintf(where, room, "%s", r->name);
        }
    }
    return worst;
}

/* The masses of every other particle change, and so does how they are told. */
static void make_unlike(const struct tank *t)
{
    struct plan *p = (struct plan *)t->plan;
    struct moment *m = t->moment;

    check(p->table.mass > 0, "the masses of this tank are not alike before");
    for (int i = 0; i < m->particles->n; i += 2)
        p->particles->m[i] = m->particles->m[i] = 1.25 * p->table.mass;
    p->table.mass = 0;
}

static void check_close(const char *scene, int which, bool alike, double tolerance)
{
    struct tank wide, narrow;
    char where[100] = "";

    make(&wide, scene, physics[which], NULL);
    make(&narrow, scene, physics[which], SINGLE);
    if (!alike) {
        make_unlike(&wide);
        make_unlike(&narrow);
    }
    tank_rates(&wide, 0.01, wide.y, wide.ydot);
    tank_rates(&narrow, 0.01, narrow.y, narrow.ydot);
    const double off = difference(&wide, wide.ydot, narrow.ydot, where, sizeof where);
    check(off < tolerance, "%s: rates of %s differ by %g", physics[which], where, off);
    check(off > 1e-12, "%s: rates do not differ at all: %g", physics[which], off);
    tank_free(&wide);
    tank_free(&narrow);
}

static void rates_are_those_of_double_precision(void **state)
{
    (void)state;
    for (int which = 0; which < PHYSICS; which++) {
        check_close(tank_bare_water, which, true, 3e-6);
        check_close(tank_bare_water, which, false, 3e-6);
    }
}

static void bits_do_not_depend_on_lanes_and_threads(void **state)
{
    static const char *const lanes[] = { "2", "4", "8" };

    (void)state;
    for (int which = 0; which < PHYSICS; which++) {
        double *first = NULL;

        for (int l = 0; l < 6; l++) {
            struct tank t;
            setenv("STIFFWATER_LANES", lanes[l / 2], 1);
            set_threads(1 + l % 2);
            make(&t, tank_bare_water, physics[which], SINGLE);
            tank_rates(&t, 0.01, t.y, t.ydot);
            if (!first)
                first = tank_copy(&t, t.ydot);
            check(memcmp(first, t.ydot, (size_t)t.n * sizeof *first) == 0,
                  "%s: other bits with %s lanes and %d threads", physics[which], lanes[l / 2],
                  1 + l % 2);
            tank_free(&t);
        }
        test_free(first);
    }
    unsetenv("STIFFWATER_LANES");
    set_threads(2);
}

/* Water in the middle of nothing, from this corner on, so wide; no gravity. */
static void make_drop(struct tank *t, double corner, double width)
{
    char text[700];
    const char *z = DIM == 3 ? ", 0.0" : "";

    snprintf(text, sizeof text, "dimension = %d; until = 1.0; spacing = 0.01; gravity = [0.0, 0.0%s];"
             "domain = { from = [%.9g, %.9g%s%.9g]; to = [%.9g, %.9g%s%.9g]; };"
             "fluid = { drop = { from = [%.9g, %.9g%s%.9g]; to = [%.9g, %.9g%s%.9g]; }; };"
             "eos = { c0 = 10.0; };" TANK_EFFECTS TANK_ONE_KERNEL SINGLE, DIM, z,
             corner - 0.5, corner - 0.5, DIM == 3 ? ", " : "];//", corner - 0.5,
             corner + 3, corner + 3, DIM == 3 ? ", " : "];//", corner + 3,
             corner, corner, DIM == 3 ? ", " : "];//", corner,
             corner + width, corner + 0.01, DIM == 3 ? ", " : "];//", corner + 0.01);
    for (char *c = text; (c = strstr(c, "];//")) != NULL; c++) {
        char *end = strchr(c + 4, ']'); /* a third number that 2D has not */
        memmove(c + 1, end + 1, strlen(end + 1) + 1);
    }
    tank_make(t, text, NULL);
}

static void forces_of_two_are_exactly_opposite(void **state)
{
    (void)state;
    for (int i = 0; i < 40; i++) {
        struct tank t;
        const struct layout_row *row;

        make_drop(&t, 0, 0.02);
        tank_shake(&t, 100 + (unsigned)i, 0.4, 1.0, 0.02);
        tank_rates(&t, 0, t.y, t.ydot);
        const double *a = t.ydot + tank_at(&t, "velocity of fluid", &row);
        assert_int_equal(row->n, 2);
        for (int d = 0; d < DIM; d++) {
            check(a[d] == -a[DIM + d], "%.17g and %.17g", a[d], a[DIM + d]);
            check(a[d] != 0, "no force");
        }
        tank_free(&t);
    }
}

/* Positions are told on a circle of 64 supports: 1.6 m here. */
static void places_do_not_matter(void **state)
{
    static const double corner[] = { 0, 0.78, 1.59, 77.7, -345.6 };
    double *first = NULL;

    (void)state;
    for (int i = 0; i < 5; i++) {
        struct tank t;
        char where[100];

        make_drop(&t, corner[i], 0.3);
        tank_shake(&t, 5, 0.2, 1.0, 0.02);
        tank_rates(&t, 0, t.y, t.ydot);
        if (!first)
            first = tank_copy(&t, t.ydot);
        const double off = difference(&t, first, t.ydot, where, sizeof where);
        check(off < 2e-6, "at %g m rates of %s differ by %g", corner[i], where, off);
        tank_free(&t);
    }
    test_free(first);
}

/* One that has left the domain takes no part: neither in the list nor, before the next
 * rebuild, through its record. */
static void who_is_outside_takes_no_part(void **state)
{
    struct tank t;

    (void)state;
    make_drop(&t, 0, 0.3);
    tank_rates(&t, 0, t.y, t.ydot);
    const long u = tank_at(&t, "velocity of fluid", NULL), x = tank_at(&t, "position of fluid", NULL);
    const int n = plan_particles(t.plan)->n;

    t.y[x + DIM * 10] = 7; /* 64 supports from nowhere near it would be 1.6 m */
    tank_rates(&t, 0, t.y, t.ydot);
    for (int d = 0; d < DIM; d++)
        check(t.ydot[u + DIM * 10 + d] == 0, "it is pushed by %g", t.ydot[u + DIM * 10 + d]);
    for (int i = 0; i < DIM * n; i++)
        check(isfinite(t.ydot[u + i]), "entry %d is %g", i, t.ydot[u + i]);
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rates_are_those_of_double_precision),
        cmocka_unit_test(bits_do_not_depend_on_lanes_and_threads),
        cmocka_unit_test(forces_of_two_are_exactly_opposite),
        cmocka_unit_test(places_do_not_matter),
        cmocka_unit_test(who_is_outside_takes_no_part),
    };

    return cmocka_run_group_tests_name("single", tests, NULL, NULL);
}
