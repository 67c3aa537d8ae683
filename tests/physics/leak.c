/* leak.c -- water that is thrown at slanted and round walls stays out of them: onto
 * edges and tips and into corners, where two walls meet or one has a notch. */
#include "tank.h"

#include "base/status.h"
#include "shapes/shape-box.h"
#include "shapes/shape-polygon.h"
#include "time/method.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WALLS = 2 };

/* Walls in the way; each case also has the frame of the tank. */
struct obstacle {
    const char *name;
    struct shape wall[WALLS]; /* as a scene gives them; type NULL: none */
};

#define NONE { NAN, NAN, NAN }

#if DIM == 2
#define BOX(A, B, C, D, TURN) { .type = "box", .from = { A, B }, .to = { C, D }, .centre = NONE, \
                                .radius = NAN, .angle = TURN }
#define POLYGON(X) { .type = "polygon", .from = NONE, .to = NONE, .centre = NONE, .radius = NAN, \
                     .points = { sizeof (X) / sizeof *(X), X } }
static const char water[] = /* walls, c0, speed */
    "walls = \"%s\"; dimension = 2; until = 1.0; spacing = 5e-3; gravity = [0.0, -9.81];"
    "eos = { c0 = %g; };"
    "domain = { from = [0.0, 0.0]; to = [0.2, 0.2]; };"
    "fluid = { water = { type = \"box\"; from = [0.07, 0.14]; to = [0.13, 0.19];"
    "  velocity = [0.0, -%g]; }; };";

/* Height 0.12 m over 20 degrees. */
static double tip[][3] = { { 0.0788, 0 }, { 0.1212, 0 }, { 0.1, 0.12 } };
static double notch[][3] = { { 0, 0 }, { 0.2, 0 }, { 0.2, 0.1 }, { 0.12, 0.1 }, { 0.1, 0.02 },
                             { 0.08, 0.1 }, { 0, 0.1 } };
static double star[][3] = { { 0.1, 0.13 }, { 0.112, 0.082 }, { 0.16, 0.07 }, { 0.112, 0.058 },
                            { 0.1, 0.01 }, { 0.088, 0.058 }, { 0.04, 0.07 }, { 0.088, 0.082 } };

static struct obstacle obstacles[] = {
    { "two turned boxes, a V of 90 degrees",
      { BOX(0.015, 0.035, 0.115, 0.055, -45), BOX(0.085, 0.035, 0.185, 0.055, 45) } },
    { "two turned boxes, a V of 60 degrees",
      { BOX(-0.02, 0.07, 0.15, 0.09, -60), BOX(0.05, 0.07, 0.22, 0.09, 60) } },
    { "a turned box and the left wall of the tank", { BOX(-0.05, 0.06, 0.2, 0.08, 40) } },
    { "a polygon with a sharp tip", { POLYGON(tip) } },
    { "a polygon with a notch", { POLYGON(notch) } },
    { "a star", { POLYGON(star) } },
    { "a disc", { { .type = "disc", .from = NONE, .to = NONE, .centre = { 0.103, 0.06 },
                    .radius = 0.03 } } },
};
#else
#define BOX(A, B, C, D, TURN) { .type = "box", .from = { A, B, -0.06 }, .to = { C, D, 0.2 }, \
                                .centre = NONE, .radius = NAN, .angle = TURN }
/* walls, c0, speed; boxes turn about z, so that down is -x here */
static const char water[] =
    "walls = \"%s\"; dimension = 3; until = 1.0; spacing = 1e-2; gravity = [-9.81, 0.0, 0.0];"
    "eos = { c0 = %g; };"
    "domain = { from = [0.0, 0.0, 0.0]; to = [0.2, 0.2, 0.14]; };"
    "fluid = { water = { type = \"box\"; from = [0.12, 0.07, 0.04]; to = [0.18, 0.13, 0.1];"
    "  velocity = [-%g, 0.0, 0.0]; }; };";
static struct obstacle obstacles[] = {
    { "two turned boxes, a V of 90 degrees",
      { BOX(-0.01, 0.025, 0.13, 0.055, -45), BOX(-0.01, 0.145, 0.13, 0.175, 45) } },
    { "a sphere", { { .type = "sphere", .from = NONE, .to = NONE, .centre = { 0.05, 0.103, 0.07 },
                      .radius = 0.04 } } },
};
#endif

static int print_vector(char *to, const char *key, const double *x)
{
    return isnan(x[0]) ? 0 : DIM == 2 ? sprintf(to, "%s = [%.17g, %.17g]; ", key, x[0], x[1])
                           : sprintf(to, "%s = [%.17g, %.17g, %.17g]; ", key, x[0], x[1], x[2]);
}

static int print_shape(char *to, int i, const struct shape *s)
{
    int n = sprintf(to, "w%d = { type = \"%s\"; angle = %g; ", i, s->type, s->angle);

    n += print_vector(to + n, "from", s->from);
    n += print_vector(to + n, "to", s->to);
    n += print_vector(to + n, "centre", s->centre);
    if (!isnan(s->radius))
        n += sprintf(to + n, "radius = %.17g; ", s->radius);
    for (int k = 0; k < s->points.n; k++)
        n += sprintf(to + n, "%s[%.17g, %.17g]%s", k ? ", " : "points = (", s->points.x[k][0],
                     s->points.x[k][1], k + 1 == s->points.n ? "); " : "");
    return n + sprintf(to + n, "}; ");
}

struct blow {
    double c0, speed; /* [m/s] */
    double most;      /* how deep the water may get into a wall [dx] */
    const char *walls;
};

/* The tank with the obstacle in it; its shapes become ready for questions. */
static void make(struct tank *t, struct obstacle *o, const struct blow *b)
{
    char text[1024], walls[4096] = "wall = { tank = { type = \"frame\"; }; ";
    int n = strlen(walls);

    for (int i = 0; i < WALLS; i++)
        if (o->wall[i].type) {
            assert_int_equal(shape_check(&o->wall[i], "wall", "leak.c"), STATUS_DONE);
            n += print_shape(walls + n, i, &o->wall[i]);
        }
    strcpy(walls + n, "};");
    snprintf(text, sizeof text, water, b->walls, b->c0, b->speed);
    tank_make(t, text, walls,
              "effects = { continuity = { }; pressure = { }; density-diffusion = { };"
              "  artificial-viscosity = { alpha = 0.05; }; };", NULL);
}

/* How deep x is inside of the shape [m]; negative: outside. */
static double depth(const struct shape *s, const double *x)
{
    double own[DIM], least = HUGE_VAL, r2 = 0;

    if (s->kind == SHAPE_POLYGON)
        return (shape_contains(s, x) ? 1 : -1) * shape_polygon_distance(&s->points, x);
    if (s->kind == SHAPE_BOX) {
        shape_box_own(s, x, own);
        for (int d = 0; d < DIM; d++)
            least = fmin(least, fmin(own[d] - s->from[d], s->to[d] - own[d]));
        return least;
    }
    for (int d = 0; d < DIM; d++)
        r2 += (x[d] - s->centre[d]) * (x[d] - s->centre[d]);
    return s->radius - sqrt(r2);
}

/* Greatest depth of a fluid particle in a wall of o or beyond the tank's sides [dx]. */
static double deepest(const struct tank *t, const struct obstacle *o, const double *y)
{
    const struct particles *p = plan_particles(t->plan);
    const double *x = y + tank_at(t, "position of fluid", NULL);
    double most = -HUGE_VAL;

    for (int i = 0; i < particles_count(p, KIND_FLUID); i++, x += DIM) {
        for (int d = 0; d < DIM; d++)
            most = fmax(most, fmax(p->scales->low[d] - x[d], x[d] - p->scales->high[d]));
        for (int k = 0; k < WALLS; k++)
            if (o->wall[k].type)
                most = fmax(most, depth(&o->wall[k], x));
    }
    return most / p->scales->dx;
}

/* The greatest depth of all steps, from the fall through impact to splash. */
static double throw(struct obstacle *o, const struct blow *b)
{
    struct method_def def = method_def_default();
    struct method_step step = { 0 };
    const struct method *m;
    double most = -HUGE_VAL;
    struct tank t;
    void *self;

    make(&t, o, b);
    assert_int_equal(method_find("erk3", &def, &m), STATUS_DONE);
    assert_int_equal(m->create(m, &def, t.moment, 0, t.y, &self), STATUS_DONE);
    while (step.t < 0.1) {
        if (m->step(self, 0.1, &step) != STATUS_DONE)
            fail_msg("%s: %s", o->name, status_message());
        most = fmax(most, deepest(&t, o, m->state(self)));
    }
    m->free(&self);
    tank_free(&t);
    return most;
}

/* Brief tests try each obstacle with some of the blows, and each blow with some obstacles. */
static void throw_at_all(const struct blow *b)
{
    const size_t every = !tank_brief() ? 1 : DIM == 2 ? 3 : 2;
    static size_t blows;

    for (size_t i = blows++ % every; i < sizeof obstacles / sizeof *obstacles; i += every) {
        struct obstacle *o = &obstacles[i];
        const double most = throw(o, b);

        print_message("# %s, %g m/s, c0 = %g m/s, %s: as deep as %.2f dx\n", b->walls, b->speed,
                      b->c0, o->name, most);
        check(most > -1, "%s: %g dx: the water was never near it", o->name, most);
        check(most < b->most, "%s: the water gets %g dx into it", o->name, most);
    }
}

/* With the sound speed that a scene should have, 10 times the largest speed and more. */
static void no_particle_gets_into_walls(void **state)
{
    (void)state;
    throw_at_all(&(struct blow){ .c0 = 30, .speed = 2, .most = 0, .walls = "own-density" });
}

/* With the fluid, and with it the wall, too soft for such a speed. */
static void a_hard_blow_gets_no_further_than_the_first_row(void **state)
{
    (void)state;
    throw_at_all(&(struct blow){ .c0 = 20, .speed = 3, .most = 1, .walls = "own-density" });
}

/* Walls that take their pressure from the fluid let it come nearer. */
static void adami_walls_let_nobody_past_the_first_row(void **state)
{
    (void)state;
    throw_at_all(&(struct blow){ .c0 = 30, .speed = 2, .most = 1, .walls = "adami" });
}

/* Walls that press by a mean yield where one particle hits them, by 0.7 dx at most where it meets
 * few others, on tips and balls. */
static void contact_walls_let_none_past_the_first_row(void **state)
{
    (void)state;
    throw_at_all(&(struct blow){ .c0 = 30, .speed = 2, .most = 1, .walls = "contact" });
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_particle_gets_into_walls),
        cmocka_unit_test(a_hard_blow_gets_no_further_than_the_first_row),
        cmocka_unit_test(adami_walls_let_nobody_past_the_first_row),
        cmocka_unit_test(contact_walls_let_none_past_the_first_row),
    };

    omp_set_num_threads(1); /* so few particles are not worth more */
    return cmocka_run_group_tests_name("leak", tests, NULL, NULL);
}
