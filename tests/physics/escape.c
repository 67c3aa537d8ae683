/* escape.c -- a particle out of the tank only falls, one that comes back is felt again,
 * and what cannot be is refused with the name of the particle. */
#include "tank.h"

#include "plan/memory.h"

#include <math.h>
#include <string.h>

enum { LOST = 37 };

static double *place(struct tank *t, int i)
{
    return t->y + tank_at(t, "position of fluid", NULL) + i * DIM;
}

static double *rate(struct tank *t, int i)
{
    return t->ydot + tank_at(t, "velocity of fluid", NULL) + i * DIM;
}

/* All rates but those of particle LOST and of the book are the same. */
static void check_others(struct tank *a, struct tank *b, const char *what)
{
    const struct layout_row *r;
    const long u = tank_at(a, "velocity of fluid", &r);

    for (int i = 0; i < r->n; i++)
        for (int d = 0; d < DIM && i != LOST; d++) {
            const double x = a->ydot[u + i * DIM + d], y = b->ydot[u + i * DIM + d];
            check(fabs(x - y) <= 1e-11 * (fabs(x) + 9.81), "%s: particle %d feels %g, not %g", what,
                  i, y, x);
        }
}

/* A plan with the particle outside, at `far` widths of the tank. */
static void throw_out(struct tank *t, double far)
{
    for (int d = 0; d < DIM; d++)
        place(t, LOST)[d] = d == 0 ? 0.1 * far : 0.03;
}

static void a_particle_outside_only_falls(void **state)
{
    const double far[] = { 3, 1e3, 1e9, -1e30 };
    struct plan_memory memory, wanted;
    struct tank t, other;

    (void)state;
    tank_make(&t, tank_water, tank_frame, TANK_EFFECTS, NULL);
    tank_make(&other, tank_water, tank_frame, TANK_EFFECTS, NULL);
    throw_out(&other, 2);
    tank_rates(&other, 0, other.y, other.ydot);
    for (int i = 0; i < 4; i++) {
        throw_out(&t, far[i]);
        tank_rates(&t, 0, t.y, t.ydot);
        for (int d = 0; d < DIM; d++)
            check(rate(&t, LOST)[d] == plan_scales(t.plan)->g[d],
                  "%g tanks away: acceleration %g in direction %d", far[i], rate(&t, LOST)[d], d);
        check(observe_escaped(t.moment, 0, t.y) == 1, "%d escaped", observe_escaped(t.moment, 0, t.y));
        check(t.ydot[tank_at(&t, "density of fluid", NULL) + LOST] == 0, "its density changes");
        check_others(&other, &t, "wherever it is");
        for (long k = 0; k < t.n; k++)
            check(isfinite(t.ydot[k]), "entry %ld is not finite", k);
    }
    plan_memory(t.plan, moment_pairs(t.moment), 1, &memory);
    plan_memory(other.plan, moment_pairs(other.moment), 1, &wanted);
    check(plan_memory_sum(&memory) <= plan_memory_sum(&wanted), "memory grows");
    tank_free(&t);
    tank_free(&other);
}

/* Out and in again without and with a rebuild in between: rates as before. */
static void a_particle_back_is_felt(void **state)
{
    struct tank t, other;
    double *home;

    (void)state;
    tank_make(&t, tank_water, tank_frame, TANK_EFFECTS, NULL);
    tank_make(&other, tank_water, tank_frame, TANK_EFFECTS, NULL);
    tank_shake(&t, 4, 0.1, 0.5, 0.005);
    tank_shake(&other, 4, 0.1, 0.5, 0.005);
    home = tank_copy(&t, t.y);
    tank_rates(&other, 0, other.y, other.ydot);
    tank_rates(&t, 0, t.y, t.ydot);
    throw_out(&t, 3);
    tank_rates(&t, 0, t.y, t.ydot);
    check(rate(&t, LOST)[0] != rate(&other, LOST)[0], "no neighbour notices that it left");
    memcpy(t.y, home, t.n * sizeof *home);
    tank_rates(&t, 0, t.y, t.ydot);
    check_others(&other, &t, "after it came back");
    for (int d = 0; d < DIM; d++)
        check(fabs(rate(&t, LOST)[d] - rate(&other, LOST)[d]) <= 1e-11 * 9.81 + 1e-11
              * fabs(rate(&other, LOST)[d]), "it feels %g, not %g", rate(&t, LOST)[d],
              rate(&other, LOST)[d]);
    test_free(home);
    tank_free(&t);
    tank_free(&other);
}

/* Just over the border while the list is still fresh: masked at once. */
static void border_counts_at_once(void **state)
{
    struct tank t;
    double edge;

    (void)state;
    tank_make(&t, tank_water, TANK_EFFECTS, NULL); /* no walls */
    edge = plan_scales(t.plan)->high[0]
         + (ceil(plan_scales(t.plan)->support / plan_scales(t.plan)->dx - 1e-9) + 0.5)
           * plan_scales(t.plan)->dx;
    for (int side = 0; side < 2; side++) {
        place(&t, LOST)[0] = edge + (side ? 1e-6 : -1e-6) * plan_scales(t.plan)->dx;
        place(&t, LOST + 1)[0] = edge - plan_scales(t.plan)->dx;
        place(&t, LOST + 1)[1] = place(&t, LOST)[1];
        tank_rates(&t, 0, t.y, t.ydot);
        check((rate(&t, LOST)[0] == 0) == (side == 1), "side %d: acceleration %g", side,
              rate(&t, LOST)[0]);
    }
    check(moment_counts(t.moment)->rebuilds == 1, "%ld rebuilds", moment_counts(t.moment)->rebuilds);
    tank_free(&t);
}

static void expect_refusal(struct tank *t, const char *what, const char *value)
{
    check(moment_eval(t->moment, ASK_ALL, 0.25, t->y, t->ydot) != 0, "%s is accepted", what);
    check(strstr(moment_refusal(t->moment), "particle 37") && strstr(moment_refusal(t->moment), "water")
          && strstr(moment_refusal(t->moment), "0.25 s") && strstr(moment_refusal(t->moment), value),
          "%s: the refusal says: %s", what, moment_refusal(t->moment));
}

static void the_impossible_is_refused_by_name(void **state)
{
    const double bad[] = { NAN, HUGE_VAL, -HUGE_VAL };
    double *home, *rho;
    struct tank t;

    (void)state;
    tank_make(&t, tank_water, tank_frame, TANK_EFFECTS, NULL);
    rho = t.y + tank_at(&t, "density of fluid", NULL) + LOST;
    home = tank_copy(&t, t.y);
    for (int i = 0; i < 3; i++) {
        place(&t, LOST)[DIM - 1] = bad[i];
        expect_refusal(&t, "a position that is not finite", "position");
        memcpy(t.y, home, t.n * sizeof *home);
    }
    *rho = 3001;
    expect_refusal(&t, "density 3001", "3001");
    *rho = 199;
    expect_refusal(&t, "density 199", "199");
    *rho = NAN;
    expect_refusal(&t, "density nan", "nan");
    memcpy(t.y, home, t.n * sizeof *home);
    tank_rates(&t, 0, t.y, t.ydot); /* and it goes on */
    check(moment_counts(t.moment)->refused == 6, "%ld refused", moment_counts(t.moment)->refused);
    test_free(home);
    tank_free(&t);
}

/* Particle LOST at x: is it inside that solid (NULL: in none)? */
static void expect_sunk(struct tank *t, double time, const double *x, const char *solid)
{
    struct observe_sunk sunk;

    memcpy(place(t, LOST), x, DIM * sizeof *x);
    observe_sunk(t->moment, time, t->y, &sunk);
    check(sunk.n == (solid != NULL), "%d in solids at (%g, %g), t = %g s", sunk.n, x[0], x[DIM - 1],
          time);
    check(!solid || (sunk.particle == LOST && strcmp(sunk.solid, solid) == 0), "particle %d in %s",
          sunk.particle, sunk.n ? sunk.solid : "nothing");
}

/* A ball above the water that moves along the lid. */
static const char *const obstacles =
    "wall = { tank = { type = \"frame\"; };"
#if DIM == 2
    "  ball = { type = \"disc\"; centre = [0.05, 0.076]; radius = 0.015;"
    "  velocity = [0.1, 0.0]; }; };";
#else
    "  ball = { type = \"sphere\"; centre = [0.05, 0.05, 0.15]; radius = 0.025;"
    "  velocity = [0.1, 0.0, 0.0]; }; };";
#endif

#if DIM == 2
#define TURNED_BOX "body = { box = { at = [0.05, 0.055]; size = [0.025, 0.025]; angle = 30.0;" \
                   " density = 500.0; }; };"
#else
#define TURNED_BOX "body = { box = { at = [0.05, 0.05, 0.1]; size = [0.06, 0.06, 0.06];"       \
                   " angle = [0.0, -30.0, 0.0]; density = 500.0; }; };"
#endif

static void particles_in_a_wall_are_counted(void **state)
{
    const double radius = DIM == 2 ? 0.015 : 0.025;
    double x[3] = { 0.05, DIM == 2 ? 0.076 : 0.05, 0.15 };
    const struct scales *s;
    struct tank t;

    (void)state;
    tank_make(&t, tank_water, obstacles, TANK_EFFECTS, NULL);
    s = plan_scales(t.plan);
    expect_sunk(&t, 0, x, "ball");
    expect_sunk(&t, 0.3, x, NULL); /* it has gone */
    x[0] += 0.03;
    expect_sunk(&t, 0.3, x, "ball");
    x[0] += radius - 0.6 * s->dx;
    expect_sunk(&t, 0.3, x, "ball");
    x[0] += 0.2 * s->dx;
    expect_sunk(&t, 0.3, x, NULL); /* deep, but not half a spacing */
    memcpy(x, plan_particles(t.plan)->x0[LOST], sizeof x[0] * DIM);
    x[0] = -0.4 * s->dx;
    expect_sunk(&t, 0, x, NULL);
    x[0] = -0.6 * s->dx;
    expect_sunk(&t, 0, x, "tank");
    tank_free(&t);
}

/* A box that is turned by 30 degrees, above the water: places in its frame, from its centre. */
static void particles_in_a_body_are_counted(void **state)
{
    const double half = DIM == 2 ? 0.0125 : 0.03, cosine = cos(M_PI / 6), sine = sin(M_PI / 6);
    const double centre[3] = { 0.05, DIM == 2 ? 0.055 : 0.05, 0.1 };
    struct tank t;

    (void)state;
    tank_make(&t, tank_water, tank_frame, TANK_EFFECTS, TURNED_BOX, NULL);
    const double dx = plan_scales(t.plan)->dx;
    const struct {
        double along, up; /* in the plane that it is turned in */
        const char *in;
    } look[] = {
        { 0, 0, "box" }, { half - 0.6 * dx, 0, "box" }, { half - 0.4 * dx, 0, NULL },
        { 0, -half + 0.6 * dx, "box" }, { 0, -half + 0.4 * dx, NULL },
        { half - 0.6 * dx, half - 0.6 * dx, "box" },
        { half - 0.1 * dx, -half - 0.3 * dx, NULL }, /* below an edge: points of the skin are all around */
        { half + 0.5 * dx, 0, NULL },
    };
    for (size_t i = 0; i < sizeof look / sizeof look[0]; i++) {
        double x[DIM];
        memcpy(x, centre, DIM * sizeof *x);
        x[0] += cosine * look[i].along - sine * look[i].up;
        x[DIM - 1] += sine * look[i].along + cosine * look[i].up;
        expect_sunk(&t, 0, x, look[i].in);
    }
#if DIM == 3
    expect_sunk(&t, 0, (double[3]){ 0.05 + half * cosine, 0.05 + half - 0.1 * dx,
                                    0.1 + half * sine - 0.9 * dx }, NULL);
#endif
    tank_free(&t);
}

#if DIM == 2
/* The beam of tank.c has its axis at x = 0.0675 and three layers, 5 mm apart. */
static void particles_in_a_beam_are_counted(void **state)
{
    struct tank t;

    (void)state;
    tank_make(&t, tank_parted_water, tank_frame, tank_beam, TANK_EFFECTS, NULL);
    for (double z = 0.004; z < 0.046; z += 0.0031) {
        expect_sunk(&t, 0, (double[2]){ 0.0675 + 0.0045, z }, "plate");
        expect_sunk(&t, 0, (double[2]){ 0.0675 - 0.0011, z }, "plate");
        expect_sunk(&t, 0, (double[2]){ 0.0675 - 0.0055, z }, NULL);
        expect_sunk(&t, 0, (double[2]){ 0.0675 + 0.0075, z }, NULL);
    }
    expect_sunk(&t, 0, (double[2]){ 0.0675, 0.0485 }, NULL);
    tank_free(&t);
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_particle_outside_only_falls),
        cmocka_unit_test(a_particle_back_is_felt),
        cmocka_unit_test(border_counts_at_once),
        cmocka_unit_test(the_impossible_is_refused_by_name),
        cmocka_unit_test(particles_in_a_wall_are_counted),
        cmocka_unit_test(particles_in_a_body_are_counted),
#if DIM == 2
        cmocka_unit_test(particles_in_a_beam_are_counted),
#endif
    };

    return cmocka_run_group_tests_name("escape", tests, NULL, NULL);
}
