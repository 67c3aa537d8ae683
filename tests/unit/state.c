/* state.c -- tests of src/state: filling shapes with particles. */
#include "base/status.h"
#include "fill/fill.h"
#include "state/memory.h"
#include "state/particles-private.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <cmocka.h>

#define MISSING { NAN, NAN, NAN }

/* A domain of 1 (0.5 in the third direction) at the spacing dx. */
static struct scales scales_of(double dx)
{
    return (struct scales){ .dimension = DIM, .dx = dx, .mass = 1000 * pow(dx, DIM),
                            .high = { 1, 1, 0.5 }, .fluid = true };
}

static struct shape checked(struct shape s)
{
    status_clear();
    if (shape_check(&s, "fluid.it", "a.scene:3"))
        fail_msg("%s", status_message());
    return s;
}

static struct shape box(double x0, double y0, double z0, double x1, double y1, double z1)
{
    return checked((struct shape){ .type = "box", .from = { x0, y0, z0 }, .to = { x1, y1, z1 },
                                   .centre = MISSING, .radius = NAN });
}

static struct shape ball(double x, double y, double z, double radius)
{
    return checked((struct shape){ .type = DIM == 2 ? "disc" : "sphere", .from = MISSING,
                                   .to = MISSING, .centre = { x, y, z }, .radius = radius });
}

static struct shape frame(const struct scales *s, int layers, unsigned open)
{
    struct shape shape = { .type = "frame", .from = MISSING, .to = MISSING, .centre = MISSING,
                           .radius = NAN, .thickness = layers * s->dx, .open = open };

    memcpy(shape.low, s->low, sizeof shape.low);
    memcpy(shape.high, s->high, sizeof shape.high);
    return checked(shape);
}

static struct fill_item item_of(const char *name, enum kind kind, const struct shape *shape)
{
    struct fill_item item = { .group = kind == KIND_FLUID ? "fluid" : "wall",
                              .where = "a.scene:3", .kind = kind, .shape = shape };

    snprintf(item.name, sizeof item.name, "%s", name);
    return item;
}

static struct fill_item skin_of(const char *name, int n, const double (*point)[DIM])
{
    struct fill_item item = { .group = "beam", .where = "a.scene:9", .kind = KIND_SKIN,
                              .points = n, .point = point };

    snprintf(item.name, sizeof item.name, "%s", name);
    return item;
}

static struct particles *filled(const struct fill_item *item, int items, const struct scales *s)
{
    struct particles *p;

    status_clear();
    if (fill_particles(item, items, s, 400, 400, &p))
        fail_msg("%s", status_message());
    return p;
}

static struct particles *filled_alone(const struct shape *shape, const struct scales *s)
{
    const struct fill_item item = item_of("it", KIND_FLUID, shape);

    return filled(&item, 1, s);
}

static void assert_refused_at(const struct fill_item *item, int items, const struct scales *s,
                              double bytes_each, const char *text)
{
    struct particles *p;

    status_clear();
    assert_int_equal(fill_particles(item, items, s, bytes_each, bytes_each, &p), STATUS_BAD_SCENE);
    assert_null(p);
    if (!strstr(status_message(), text))
        fail_msg("\"%s\" does not say \"%s\"", status_message(), text);
    assert_non_null(strstr(status_message(), "a.scene:"));
    status_clear();
}

static void assert_refused(const struct fill_item *item, int items, const struct scales *s,
                           const char *text)
{
    assert_refused_at(item, items, s, 400, text);
}

static void assert_near(double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%.17g is not %.17g to %g", value, expected, tolerance);
}

/* Sites at low + (i + 1/2) dx, the first axis fastest. */
static void a_box_is_a_lattice(void **state)
{
    const struct scales s = scales_of(0.1);
    const struct shape shape = box(0.2, 0.1, 0, 0.5, 0.5, 0.2);
    struct particles *p = filled_alone(&shape, &s);
    const int n[3] = { 3, 4, 2 };

    (void)state;
    assert_int_equal(p->n, DIM == 2 ? 12 : 24);
    for (int i = 0; i < p->n; i++) {
        const int site[3] = { i % n[0], i / n[0] % n[1], i / n[0] / n[1] };

        for (int d = 0; d < DIM; d++) {
            assert_near(p->x0[i][d], shape.from[d] + (site[d] + 0.5) * 0.1, 1e-15);
        }
        assert_true(p->m[i] == s.mass && p->dye[i] == 0 && p->object_of[i] == 0);
    }
    assert_ptr_equal(p->scales, &s);
    assert_null(p->x);
    particles_free(&p);
    assert_null(p);
}

/* At a moment solids stand elsewhere, while all else is that of the particles. */
static void solids_of_a_moment_are_its_own(void **state)
{
    const struct scales s = scales_of(0.1);
    const struct shape shape = box(0.2, 0.1, 0, 0.5, 0.5, 0.2);
    const struct fill_item item = item_of("it", KIND_WALL, &shape);
    struct particles *p = filled(&item, 1, &s), *now[2];
    const int first = p->from[KIND_FLUID + 1];

    (void)state;
    assert_true(first < p->n);
    for (int k = 0; k < 2; k++)
        assert_int_equal(particles_create_beside(p, &now[k]), STATUS_DONE);
    for (int i = first; i < p->n; i++)
        for (int d = 0; d < DIM; d++)
            assert_true(now[0]->x[i][d] == p->x0[i][d] && now[0]->u[i][d] == 0);
    now[0]->x[p->n - 1][0] = 7;
    now[0]->object[0].omega = 3;
    assert_true(now[1]->x[p->n - 1][0] == p->x0[p->n - 1][0]);
    assert_true(now[1]->object[0].omega == 0 && p->object[0].omega == 0);
    assert_ptr_equal(now[0]->m, p->m);
    for (int k = 0; k < 2; k++)
        particles_free(&now[k]);
    particles_free(&p);
}

/* A spacing written with eleven digits: 1/3 is filled from wall to wall. */
static void a_rounded_spacing_is_spread_evenly(void **state)
{
    const struct scales s = scales_of(3.3333333333e-2);
    const struct shape shape = box(0, 0, 0, 1, 1, 0.1);
    struct particles *p = filled_alone(&shape, &s);

    (void)state;
    assert_int_equal(p->n, DIM == 2 ? 900 : 2700);
    assert_near(p->x0[0][0], 1.0 / 60, 1e-16);
    assert_near(p->x0[29][0], 59.0 / 60, 1e-15);
    assert_near(p->x0[p->n - 1][1], 59.0 / 60, 1e-15);
    particles_free(&p);
}

static void a_spacing_that_does_not_fit_is_refused(void **state)
{
    struct scales s = scales_of(0.03);
    const struct shape shape = box(0, 0, 0, 0.1, 0.2, 0.3);
    const struct fill_item item = item_of("dam", KIND_FLUID, &shape);

    (void)state;
    assert_refused(&item, 1, &s, "a.scene:3: fluid.dam: its width of 0.1 m is 3.33333 spacings of"
                                 " 0.03 m and must be a whole number of them;"
                                 " 0.1/3 = 0.0333333333333 m or 0.1/4 = 0.025 m would fit");
    s.dx = 0.025 * (1 + 3e-6);
    assert_refused(&item, 1, &s, "0.1/4 = 0.025 m");
    s.dx = 0.025 * (1 + 5e-7);
    struct particles *p = filled(&item, 1, &s);
    assert_int_equal(p->n, DIM == 2 ? 32 : 384);
    particles_free(&p);
}

/* 0.1 and 0.16: only their common measure 0.02 and its parts fit both. */
static void a_suggested_spacing_fits_every_side(void **state)
{
    const struct shape shape = box(0, 0, 0, 0.1, 0.16, 0.1);
    const struct fill_item item = item_of("dam", KIND_FLUID, &shape);
    struct scales s = scales_of(0.017);

    (void)state;
    assert_refused(&item, 1, &s, "0.1/5 = 0.02 m or 0.1/10 = 0.01 m would fit");
    s.dx = 0.025;
    assert_refused(&item, 1, &s, " of 0.16 m is 6.4 spacings of 0.025 m");
    s.dx = 0.03;
    assert_refused(&item, 1, &s, "; 0.1/5 = 0.02 m would fit");
}

static void sides_without_a_common_measure_are_told(void **state)
{
    const struct shape shape = box(0, 0, 0, 0.1, 0.1 * M_SQRT2, 0.1);
    const struct fill_item item = item_of("dam", KIND_FLUID, &shape);
    const struct scales s = scales_of(0.025);

    (void)state;
    assert_refused(&item, 1, &s, "no spacing from 0.0125 m to 0.05 m would fit");
}

static void a_frame_wants_a_domain_that_fits(void **state)
{
    struct scales s = scales_of(0.05);
    struct fill_item item = item_of("tank", KIND_WALL, NULL);

    (void)state;
    s.high[1] = 0.98;
    const struct shape shell = frame(&s, 2, 0);
    item.shape = &shell;
    assert_refused(&item, 1, &s, DIM == 2 ? "wall.tank: the domain's height of 0.98 m is 19.6 spac"
                                          : "wall.tank: the domain's depth of 0.98 m is 19.6 spac");
}

/* Solid boxes are spread whatever their size: 0.13 m at 0.05 m are 3 sites. */
static void a_solid_box_may_have_any_size(void **state)
{
    const struct scales s = scales_of(0.05);
    const struct shape shape = box(0.1, 0.1, 0.1, 0.23, 0.2, 0.2);
    const struct fill_item item = item_of("block", KIND_WALL, &shape);
    struct particles *p = filled(&item, 1, &s);

    (void)state;
    assert_int_equal(p->n, DIM == 2 ? 6 : 12);
    for (int i = 0; i < 3; i++)
        assert_near(p->x0[i][0], 0.1 + (i + 0.5) * 0.13 / 3, 1e-15);
    particles_free(&p);
}

/* c and s of a whole number of quarter turns. */
static void quarter(int turns, double *c, double *s)
{
    const double cs[4][2] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };

    *c = cs[turns % 4][0];
    *s = cs[turns % 4][1];
}

/* Site by site, about the centre (0.5, 0.5, ..). */
static void a_box_turns_with_its_lattice(void **state)
{
    const struct scales s = scales_of(0.05);
    struct shape shape = box(0.3, 0.4, 0, 0.7, 0.6, 0.2);
    struct particles *plain = filled_alone(&shape, &s);

    (void)state;
    for (int turns = 0; turns <= 4; turns++) {
        double c, n;

        shape.angle = 90 * turns;
        quarter(turns, &c, &n);
        struct particles *p = filled_alone(&shape, &s);
        assert_int_equal(p->n, plain->n);
        for (int i = 0; i < p->n; i++) {
            const double a = plain->x0[i][0] - 0.5, b = plain->x0[i][1] - 0.5;

            assert_near(p->x0[i][0], 0.5 + (c * a - n * b), turns % 4 ? 2e-16 : 0);
            assert_near(p->x0[i][1], 0.5 + (n * a + c * b), turns % 4 ? 2e-16 : 0);
            assert_true(DIM == 2 || p->x0[i][DIM - 1] == plain->x0[i][DIM - 1]);
        }
        particles_free(&p);
    }
    particles_free(&plain);
}

static double distance(const double *a, const double *b)
{
    double r2 = 0;

    for (int d = 0; d < DIM; d++)
        r2 += (a[d] - b[d]) * (a[d] - b[d]);
    return sqrt(r2);
}

static void a_slanted_box_keeps_its_spacing(void **state)
{
    const struct scales s = scales_of(0.05);
    struct shape shape = box(0.3, 0.4, 0, 0.7, 0.6, 0.2);

    (void)state;
    shape.angle = 30;
    struct particles *p = filled_alone(&shape, &s);
    assert_int_equal(p->n, DIM == 2 ? 32 : 128);
    for (int i = 0; i < p->n; i++) {
        assert_true(shape_contains(&shape, p->x0[i]));
        if (i % 8 < 7)
            assert_near(distance(p->x0[i], p->x0[i + 1]), 0.05, 1e-15);
        if (i % 32 < 24)
            assert_near(distance(p->x0[i], p->x0[i + 8]), 0.05, 1e-15);
    }
    assert_near((p->x0[1][1] - p->x0[0][1]) / 0.05, 0.5, 1e-14);
    particles_free(&p);
}

/* Its sides must fit, not those of the box around it. */
static void a_slanted_fluid_must_fit_its_own_sides(void **state)
{
    struct scales s = scales_of(0.03);
    struct shape shape = box(0.4, 0.4, 0, 0.5, 0.6, 0.3);
    const struct fill_item item = item_of("dam", KIND_FLUID, &shape);

    (void)state;
    shape.angle = 37;
    assert_refused(&item, 1, &s, "its width of 0.1 m is 3.33333 spacings of 0.03 m");
    s.dx = 0.025;
    struct particles *p = filled_alone(&shape, &s);
    assert_int_equal(p->n, DIM == 2 ? 32 : 384);
    particles_free(&p);
}

static void fluid_in_layers_is_refused(void **state)
{
    const struct scales s = scales_of(0.05);
    struct shape shape = ball(0.5, 0.5, 0.25, 0.2);
    const struct fill_item item = item_of("drop", KIND_FLUID, &shape);

    (void)state;
    shape.fill = "layers";
    assert_refused(&item, 1, &s, "fluid.drop: fill = \"layers\" is for walls");
}

static void a_ball_is_filled_symmetrically(void **state)
{
    const struct scales s = scales_of(0.01);
    const double volume = DIM == 2 ? M_PI * 0.2 * 0.2 : 4 * M_PI / 3 * 0.2 * 0.2 * 0.2;

    (void)state;
    for (double radius = 0.2; radius < 0.209; radius += 0.0013) {
        const struct shape shape = ball(0.5, 0.4, 0.25, radius);
        struct particles *p = filled_alone(&shape, &s);
        double sum[3] = { 0 };

        assert_near(p->n * pow(s.dx, DIM) / (volume * pow(radius / 0.2, DIM)), 1, 0.02);
        for (int i = 0; i < p->n; i++)
            for (int d = 0; d < DIM; d++)
                sum[d] += p->x0[i][d] - shape.centre[d];
        for (int d = 0; d < DIM; d++)
            assert_near(sum[d] / p->n, 0, 1e-14);
        particles_free(&p);
    }
}

/* Two layers round 10 x 10 (x 5) sites, for every choice of open sides. */
static void a_frame_has_the_sites_of_its_shell(void **state)
{
    const struct scales s = scales_of(0.1);
    const int inner[3] = { 10, 10, 5 };

    (void)state;
    for (unsigned open = 0; open < (1u << 2 * DIM) - 1; open++) {
        const struct shape shape = frame(&s, 2, open);
        const struct fill_item item = item_of("tank", KIND_WALL, &shape);
        struct particles *p = filled(&item, 1, &s);
        int all = 1, domain = 1;

        for (int d = 0; d < DIM; d++) {
            domain *= inner[d];
            all *= inner[d] + 2 * !(open & shape_side(d, false))
                 + 2 * !(open & shape_side(d, true));
        }
        assert_int_equal(p->n, all - domain);
        for (int i = 0; i < p->n; i++)
            for (int d = 0; d < DIM; d++) {
                const double site = p->x0[i][d] / 0.1 - 0.5;

                assert_near(site, rint(site), 1e-12);
                assert_true(site > -2.5 && site < inner[d] + 1.5);
            }
        particles_free(&p);
    }
}

#if DIM == 2
static void a_polygon_is_filled_from_its_lowest_corner(void **state)
{
    double x[][3] = { { 0.1, 0.1 }, { 0.91, 0.1 }, { 0.5, 0.7 }, { 0.1, 0.4 } };
    struct shape shape = { .type = "polygon", .from = MISSING, .to = MISSING, .centre = MISSING,
                           .radius = NAN, .points = { 4, x } };
    const struct scales s = scales_of(0.004);
    double area = 0;

    (void)state;
    for (int i = 0; i < 4; i++)
        area += 0.5 * (x[i][0] * x[(i + 1) % 4][1] - x[(i + 1) % 4][0] * x[i][1]);
    shape = checked(shape);
    struct particles *p = filled_alone(&shape, &s);
    assert_near(p->x0[0][0], 0.102, 1e-15);
    assert_near(p->x0[0][1], 0.102, 1e-15);
    assert_near(p->x0[1][0], 0.106, 1e-15);
    assert_near(p->n * s.dx * s.dx / area, 1, 0.005);
    particles_free(&p);
}

static struct shape polygon(int n, double (*x)[3])
{
    return checked((struct shape){ .type = "polygon", .from = MISSING, .to = MISSING,
                                   .centre = MISSING, .radius = NAN, .points = { n, x } });
}

/* Water in the corner of a slope: three sites in four touch the slanted border, and
 * those that the wall has no room for are left out. */
static void fluid_may_lie_on_a_slope(void **state)
{
    const struct scales s = scales_of(0.02);

    (void)state;
    for (double rise = 0.2; rise < 0.9; rise += 0.1) {
        double wedge[][3] = { { 0.2, 0 }, { 1, 0 }, { 1, 0.8 * rise } };
        double pool[][3] = { { 0.2, 0 }, { 0.8, 0.6 * rise }, { 0, 0.6 * rise }, { 0, 0 } };
        const struct shape slope = polygon(3, wedge), water = polygon(4, pool);
        const struct fill_item item[] = { item_of("water", KIND_FLUID, &water),
                                          item_of("slope", KIND_WALL, &slope) };
        struct particles *p = filled(item, 2, &s);
        const double area = 0.6 * rise * (0.2 + 0.3), border = 0.6 * hypot(1, rise);

        assert_true(p->object[0].n * s.dx * s.dx < area * 1.01);
        assert_true(p->object[0].n * s.dx * s.dx > area - 0.45 * s.dx * border);
        particles_free(&p);
    }
}

#endif

/* Kinds in their order, items in theirs; the table says which object each belongs to. */
static void particles_stand_in_creation_order(void **state)
{
    const struct scales s = scales_of(0.1);
    const struct shape one = box(0, 0, 0, 0.3, 0.2, 0.1), two = box(0.5, 0, 0, 0.7, 0.2, 0.1);
    const struct shape tank = frame(&s, 1, 0), block = box(0.8, 0.5, 0.1, 0.9, 0.6, 0.2);
    const double point[2][DIM] = { { 0.4, 0.75 }, { 0.4, 0.85 } };
    const struct fill_item item[] = {
        item_of("tank", KIND_WALL_SLIP, &tank), skin_of("plate", 2, point),
        item_of("one", KIND_FLUID, &one), item_of("block", KIND_WALL, &block),
        item_of("two", KIND_FLUID, &two), skin_of("bare", 0, NULL),
    };
    const char *const order[] = { "one", "two", "block", "tank", "plate", "bare" };
    const int shell = DIM == 2 ? 44 : 12 * 12 * 7 - 500;
    const int from[] = { 0, 6, 10, 11, 11 + shell, 13 + shell, 13 + shell };
    const int kind_from[KINDS + 1] = { 0, 10, 11, 11 + shell, 13 + shell, 13 + shell };
    struct particles *p = filled(item, 6, &s);

    (void)state;
    assert_int_equal(p->objects, 6);
    assert_memory_equal(p->from, kind_from, sizeof kind_from);
    for (int k = 0; k < 6; k++) {
        assert_string_equal(p->object[k].name, order[k]);
        assert_int_equal(p->object[k].from, from[k]);
        assert_int_equal(p->object[k].n, from[k + 1] - from[k]);
        for (int i = from[k]; i < from[k + 1]; i++)
            assert_int_equal(p->object_of[i], k);
    }
    assert_int_equal(p->object[3].kind, KIND_WALL_SLIP);
    assert_int_equal(particles_count(p, KIND_SKIN), 2);
    assert_memory_equal(p->x0[11 + shell], point, sizeof point);
    particles_free(&p);
}

static void fluid_in_fluid_is_refused(void **state)
{
    const struct scales s = scales_of(0.1);
    const struct shape one = box(0, 0, 0, 0.4, 0.2, 0.2);
    const struct shape inside = box(0.3, 0.1, 0.1, 0.7, 0.3, 0.3);
    const struct shape close = box(0.36, 0, 0, 0.56, 0.2, 0.2);
    const struct shape beside = box(0.4, 0, 0, 0.6, 0.2, 0.2);
    struct fill_item item[] = { item_of("one", KIND_FLUID, &one),
                                item_of("two", KIND_FLUID, &inside) };

    (void)state;
    assert_refused(item, 2, &s, DIM == 2
        ? "fluid.one overlaps fluid.two (a.scene:3): near (0.35, 0.15) m two of their particles are"
        : "fluid.one overlaps fluid.two (a.scene:3): near (0.35, 0.15, 0.15) m two of their");
    item[1].shape = &close;
    assert_refused(item, 2, &s, "are 0.06 m apart, and less than 0.7 spacings (0.07 m) is too");
    item[1].shape = &beside;
    struct particles *p = filled(item, 2, &s);
    particles_free(&p);
}

/* The least distance of x from a particle of a solid [m]. */
static double to_solids(const struct particles *p, const double *x)
{
    double least = HUGE_VAL;

    for (int i = p->from[KIND_FLUID + 1]; i < p->n; i++) {
        double r2 = 0;
        for (int d = 0; d < DIM; d++)
            r2 += (x[d] - p->x0[i][d]) * (x[d] - p->x0[i][d]);
        least = fmin(least, sqrt(r2));
    }
    return least;
}

/* Item 0 is fluid, item 1 a solid: the sites of the fluid alone that stand outside of the
 * solid's shape and 0.75 dx or more from its particles are there, in their order, no others. */
static void assert_carved(const struct fill_item *item, const struct scales *s)
{
    struct particles *alone = filled(item, 1, s), *p = filled(item, 2, s);
    int n = 0;

    for (int i = 0; i < alone->n; i++) {
        if (to_solids(p, alone->x0[i]) < 0.75 * s->dx
            || (item[1].shape && shape_contains(item[1].shape, alone->x0[i])))
            continue;
        assert_true(n < p->object[0].n);
        assert_memory_equal(p->x0[n++], alone->x0[i], sizeof *p->x0);
    }
    assert_int_equal(p->object[0].n, n);
    assert_int_equal(p->object[0].carved, alone->n - n);
    if (n < alone->n)
        assert_int_equal(p->object[0].carver, 1);
    particles_free(&p);
    particles_free(&alone);
}

/* Wherever a solid stands, on the lattice or between its sites, turned or round. */
static void fluid_makes_room_for_a_solid(void **state)
{
    const struct scales s = scales_of(0.05);
    const struct shape dam = box(0, 0, 0, 0.8, 0.6, 0.4);

    (void)state;
    for (double at = 0.3; at < 0.4; at += 0.007) {
        struct shape block = box(at, at, 0.1, at + 0.23, at + 0.1, 0.2);
        const struct shape drop = ball(at, at, 0.2, 0.15);
        struct fill_item item[] = { item_of("dam", KIND_FLUID, &dam),
                                    item_of("block", KIND_WALL, &block) };

        assert_carved(item, &s);
        block.angle = 700 * (at - 0.3);
        assert_carved(item, &s);
        item[1] = item_of("drop", KIND_WALL_SLIP, &drop);
        assert_carved(item, &s);
    }
}

/* On the fluid's own lattice one spacing stays between them: as many sites go as the solid
 * has particles. */
static void a_solid_on_the_lattice_takes_its_own_sites(void **state)
{
    const struct scales s = scales_of(0.1);
    const struct shape dam = box(0, 0, 0, 0.8, 0.6, 0.4), block = box(0.3, 0.2, 0.1, 0.5, 0.5, 0.3);
    const struct fill_item item[] = { item_of("dam", KIND_FLUID, &dam),
                                      item_of("block", KIND_WALL, &block) };
    struct particles *p = filled(item, 2, &s);

    (void)state;
    assert_int_equal(p->object[0].carved, p->object[1].n);
    for (int i = 0; i < p->object[0].n; i++)
        assert_true(to_solids(p, p->x0[i]) > 0.999 * s.dx);
    particles_free(&p);
}

/* In a wall that is hollow behind its layers there is no fluid either. */
static void a_hollow_wall_holds_no_fluid(void **state)
{
    const struct scales s = scales_of(0.02);
    const struct shape dam = box(0, 0, 0, 0.8, 0.6, 0.4);
    struct shape drop = ball(0.4, 0.3, 0.2, 0.15);
    struct fill_item item[] = { item_of("dam", KIND_FLUID, &dam),
                                item_of("drop", KIND_WALL, &drop) };

    (void)state;
    drop.thickness = 2.5 * s.dx;
    assert_carved(item, &s);
}

/* A point of a skin, also over a periodic side. */
static void fluid_makes_room_for_a_skin(void **state)
{
    struct scales s = scales_of(0.1);
    const struct shape dam = box(0, 0, 0, 0.4, 0.2, 0.2);
    const double point[1][DIM] = { { 0.22, 0.12 } }, beyond[1][DIM] = { { 0.98, 0.05 } };
    struct fill_item item[] = { item_of("dam", KIND_FLUID, &dam), skin_of("plate", 1, point) };

    (void)state;
    assert_carved(item, &s);
    item[1] = skin_of("plate", 1, beyond);
    struct particles *p = filled(item, 2, &s);
    assert_int_equal(p->object[0].carved, 0);
    particles_free(&p);
    s.period[0] = 1;
    p = filled(item, 2, &s);
    assert_int_equal(p->object[0].carved, DIM == 2 ? 1 : 0);
    particles_free(&p);
}

static void fluid_that_is_mostly_in_solids_is_refused(void **state)
{
    const struct scales s = scales_of(0.1);
    const struct shape dam = box(0, 0, 0, 0.4, 0.2, 0.2), all = box(-0.1, 0, 0, 0.5, 0.2, 0.2);
    const struct shape half = box(0, 0, 0, 0.2, 0.2, 0.2), more = box(0.2, 0, 0, 0.3, 0.2, 0.2);
    struct fill_item item[] = { item_of("dam", KIND_FLUID, &dam), item_of("one", KIND_WALL, &all),
                                item_of("two", KIND_WALL_SLIP, &more) };

    (void)state;
    assert_refused(item, 2, &s, "fluid.dam lies wholly in solids");
    assert_refused(item, 2, &s, "wall.one (a.scene:3) takes 100 %");
    item[1].shape = &half;
    struct particles *p = filled(item, 2, &s); /* just half is left */
    particles_free(&p);
    assert_refused(item, 3, &s, "fluid.dam lies more than half in solids");
    assert_refused(item, 3, &s, "wall.one (a.scene:3) takes 50 %, wall.two (a.scene:3) takes 25 %");
}

static void a_skin_in_a_solid_is_refused(void **state)
{
    const struct scales s = scales_of(0.02);
    const struct shape block = box(0.3, 0.1, 0.1, 0.5, 0.4, 0.2);
    struct shape drop = ball(0.7, 0.5, 0.25, 0.2);
    const double in[1][DIM] = { { 0.32, 0.12 } }, middle[1][DIM] = { { 0.7, 0.5 } };
    const double beside[1][DIM] = { { 0.51, 0.15 } };
    struct fill_item item[] = { item_of("block", KIND_WALL, &block), skin_of("plate", 1, beside),
                                skin_of("flap", 1, beside) };

    (void)state;
    struct particles *p = filled(item, 2, &s);
    particles_free(&p);
    assert_refused(item, 3, &s, "beam.plate overlaps beam.flap (a.scene:9)");
    item[1] = skin_of("plate", 1, in);
    if (DIM == 3)
        return; /* its points have no third coordinate here */
    assert_refused(item, 2, &s, "beam.plate overlaps wall.block (a.scene:3)");
    drop.thickness = 2.5 * s.dx;
    item[0] = item_of("drop", KIND_WALL, &drop);
    item[1] = skin_of("plate", 1, middle);
    assert_refused(item, 2, &s, "beam.plate overlaps wall.drop (a.scene:3): a particle of beam.");
}

static void solids_may_touch_solids(void **state)
{
    const struct scales s = scales_of(0.1);
    const struct shape tank = frame(&s, 2, 0), block = box(0.3, 0.03, 0.1, 0.5, 0.2, 0.2);
    const double point[2][DIM] = { { 0.8, 0.05 }, { 0.8, 0.15 } };
    const struct fill_item item[] = { item_of("tank", KIND_WALL, &tank), skin_of("plate", 2, point),
                                      item_of("block", KIND_WALL, &block) };
    struct particles *p = filled(item, 3, &s);

    (void)state;
    particles_free(&p);
}

/* What the items' filling says on standard error. */
static void heard(const struct fill_item *item, int items, const struct scales *s, char *text,
                  size_t room)
{
    FILE *file = tmpfile();
    const int kept = dup(STDERR_FILENO);

    assert_non_null(file);
    dup2(fileno(file), STDERR_FILENO);
    struct particles *p = filled(item, items, s);
    dup2(kept, STDERR_FILENO);
    close(kept);
    rewind(file);
    text[fread(text, 1, room - 1, file)] = '\0';
    fclose(file);
    particles_free(&p);
}

static void walls_in_one_place_get_a_warning(void **state)
{
    const struct scales s = scales_of(0.1);
    const struct shape foot = box(0, 0, 0, 0.4, 0.2, 0.2), leg = box(0.2, 0, 0, 0.4, 0.6, 0.2);
    const struct shape beside = box(0.4, 0, 0, 0.5, 0.6, 0.2);
    struct fill_item item[] = { item_of("foot", KIND_WALL, &foot),
                                item_of("leg", KIND_WALL, &leg) };
    char text[500];

    (void)state;
    heard(item, 2, &s, text, sizeof text);
    assert_non_null(strstr(text, "wall.foot and wall.leg (a.scene:3) fill the same space near"));
    item[1].shape = &beside;
    heard(item, 2, &s, text, sizeof text);
    assert_string_equal(text, "");
}

#if DIM == 2
/* An arm that no layer fits into; beside it the wall is sound. */
static void walls_too_thin_get_a_warning(void **state)
{
    const struct scales s = scales_of(0.1);
    double thin[][3] = { { 0, 0 }, { 0.5, 0 }, { 0.5, 0.4 }, { 1, 0.41 }, { 1, 0.43 }, { 0.5, 0.5 },
                         { 0, 0.5 } };
    struct shape flag = polygon(7, thin);
    struct fill_item item = item_of("flag", KIND_WALL, &flag);
    char text[500];

    (void)state;
    heard(&item, 1, &s, text, sizeof text);
    assert_non_null(strstr(text, "wall.flag is too thin near ("));
    thin[3][1] = 0.3;
    thin[4][1] = 0.5;
    heard(&item, 1, &s, text, sizeof text);
    assert_string_equal(text, "");
}
#endif

static void fluid_outside_the_domain_is_refused(void **state)
{
    const struct scales s = scales_of(0.1);
    const struct shape shape = box(0.8, 0, 0, 1.1, 0.2, 0.2);
    const struct fill_item item = item_of("dam", KIND_FLUID, &shape);

    (void)state;
    assert_refused(&item, 1, &s, "fluid.dam reaches out of the domain: along x a particle stands at"
                                 " 1.05 m, the domain goes from 0 m to 1 m");
}

static void items_without_a_particle_are_refused(void **state)
{
    const struct scales s = scales_of(0.1);
    const struct shape drop = ball(0.5, 0.5, 0.25, 0.02), thin = box(0, 0, 0, 0.04, 1, 1);
    struct fill_item item = item_of("drop", KIND_FLUID, &drop);

    (void)state;
    assert_refused(&item, 1, &s, "fluid.drop holds no particle");
    item = item_of("sheet", KIND_WALL, &thin);
    assert_refused(&item, 1, &s, "wall.sheet holds no particle");
    item = item_of("nothing", KIND_FLUID, NULL);
    assert_refused(&item, 1, &s, "fluid.nothing holds no particle");
}

static void a_scene_without_items_is_empty(void **state)
{
    const struct scales s = scales_of(0);
    struct particles *p = filled(NULL, 0, &s);

    (void)state;
    assert_int_equal(p->n, 0);
    assert_int_equal(p->from[KINDS], 0);
    particles_free(&p);
}

static void too_many_particles_are_refused(void **state)
{
    struct scales s = scales_of(0.1);
    const struct shape shape = box(0, 0, 0, 1, 1, 0.5);
    const struct fill_item item = item_of("dam", KIND_FLUID, &shape);

    (void)state;
    assert_refused_at(&item, 1, &s, 1e15, "GiB of memory, and ");
    s.dx = 1e-5;
    assert_refused_at(&item, 1, &s, 1e-3, "more than this program can number (5.37e+08); at ");
    s.dx = 1e-300;
    assert_refused(&item, 1, &s, "fluid.dam");
    s.dx = 0;
    assert_refused(&item, 1, &s, "the spacing must be above 0");
    s.dx = NAN;
    assert_refused(&item, 1, &s, "the spacing must be above 0");
}

static void free_memory_is_read_or_asked_for(void **state)
{
    char name[] = P_tmpdir "/meminfo-XXXXXX";
    const int file = mkstemp(name);
    const char text[] = "MemTotal:  8000 kB\nMemAvailable:   1234 kB\nBuffers:  5 kB\n";

    (void)state;
    assert_true(file >= 0);
    assert_int_equal(write(file, text, sizeof text - 1), sizeof text - 1);
    close(file);
    assert_true(memory_available(name) == 1234 * 1024.0);
    unlink(name);
    assert_true(memory_available(name) > 1e6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_box_is_a_lattice),
        cmocka_unit_test(solids_of_a_moment_are_its_own),
        cmocka_unit_test(a_rounded_spacing_is_spread_evenly),
        cmocka_unit_test(a_spacing_that_does_not_fit_is_refused),
        cmocka_unit_test(a_suggested_spacing_fits_every_side),
        cmocka_unit_test(sides_without_a_common_measure_are_told),
        cmocka_unit_test(a_frame_wants_a_domain_that_fits),
        cmocka_unit_test(a_solid_box_may_have_any_size),
        cmocka_unit_test(a_box_turns_with_its_lattice),
        cmocka_unit_test(a_slanted_box_keeps_its_spacing),
        cmocka_unit_test(a_slanted_fluid_must_fit_its_own_sides),
        cmocka_unit_test(fluid_in_layers_is_refused),
        cmocka_unit_test(a_ball_is_filled_symmetrically),
        cmocka_unit_test(a_frame_has_the_sites_of_its_shell),
#if DIM == 2
        cmocka_unit_test(a_polygon_is_filled_from_its_lowest_corner),
        cmocka_unit_test(fluid_may_lie_on_a_slope),
            cmocka_unit_test(walls_too_thin_get_a_warning),
#endif
        cmocka_unit_test(particles_stand_in_creation_order),
        cmocka_unit_test(fluid_in_fluid_is_refused),
        cmocka_unit_test(fluid_makes_room_for_a_solid),
        cmocka_unit_test(a_solid_on_the_lattice_takes_its_own_sites),
        cmocka_unit_test(a_hollow_wall_holds_no_fluid),
        cmocka_unit_test(fluid_makes_room_for_a_skin),
        cmocka_unit_test(fluid_that_is_mostly_in_solids_is_refused),
        cmocka_unit_test(a_skin_in_a_solid_is_refused),
        cmocka_unit_test(solids_may_touch_solids),
        cmocka_unit_test(walls_in_one_place_get_a_warning),
        cmocka_unit_test(fluid_outside_the_domain_is_refused),
        cmocka_unit_test(items_without_a_particle_are_refused),
        cmocka_unit_test(a_scene_without_items_is_empty),
        cmocka_unit_test(too_many_particles_are_refused),
        cmocka_unit_test(free_memory_is_read_or_asked_for),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
