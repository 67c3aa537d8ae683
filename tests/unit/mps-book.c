/* mps-book.c -- what a step of MPS writes in the book: works of its corrections by name, and
 * what it gave to solids, as tables tell it. */
#include "../physics/tank.h"
#include "eval/inside.h"
#include "solved/mps-inside.h"

#include <math.h>
#include <string.h>

/* All corrections there are, with a gradient that keeps momentum; water on both sides of a block
 * that moves. */
#define WALLS                                                                            \
    "walls = \"own-density\"; method = \"mps@0.1\";"                                     \
    "mps = { bundle = \"enhanced\"; gradient = \"cmps\"; ds_distance = 0.95;"                 \
    " collision_distance = 0.85; nu = 2e-3; };"
#if DIM == 2
#define WATER                                                                            \
    "dimension = 2; until = 1.0; spacing = 5e-3; gravity = [0.0, -9.81];"                \
    "domain = { from = [0.0, 0.0]; to = [0.1, 0.08]; };"                                 \
    "fluid = { left = { type = \"box\"; from = [0.0, 0.0]; to = [0.04, 0.06]; };"        \
    " right = { type = \"box\"; from = [0.06, 0.0]; to = [0.1, 0.06]; }; };"
#define SOLIDS                                                                           \
    "wall = { tank = { type = \"frame\"; };"                                             \
    " block = { type = \"box\"; from = [0.04, 0.0]; to = [0.06, 0.06]; velocity = [0.3, -0.1]; }; };" \
    "panel = { near = { of = \"tank\"; from = [-1, -1]; to = [0.05, 1]; about = [0.02, 0.01]; };" \
    " far = { of = \"tank\"; from = [0.05, -1]; to = [1, 1]; about = [0.02, 0.01]; }; };"
#else
#define WATER                                                                            \
    "dimension = 3; until = 1.0; spacing = 2e-2; gravity = [0.0, 0.0, -9.81];"           \
    "domain = { from = [0.0, 0.0, 0.0]; to = [0.14, 0.1, 0.16]; };"                      \
    "fluid = { left = { type = \"box\"; from = [0.0, 0.0, 0.0]; to = [0.04, 0.1, 0.12]; };" \
    " right = { type = \"box\"; from = [0.08, 0.0, 0.0]; to = [0.14, 0.1, 0.12]; }; };"
#define SOLIDS                                                                           \
    "wall = { tank = { type = \"frame\"; };"                                             \
    " block = { type = \"box\"; from = [0.04, 0.0, 0.0]; to = [0.08, 0.1, 0.12];"        \
    " velocity = [0.3, 0.2, -0.1]; }; };"                                                \
    "panel = { near = { of = \"tank\"; from = [-1, -1, -1]; to = [0.05, 1, 1];"          \
    " about = [0.02, 0.01, 0.03]; };"                                                    \
    " far = { of = \"tank\"; from = [0.05, -1, -1]; to = [1, 1, 1];"                     \
    " about = [0.02, 0.01, 0.03]; }; };"
#endif

static const double h = 2e-3;

/* One step from a shaken state, without gravity or laws. */
struct stirred {
    struct tank tank;
    struct mps *mps;
    double *to;
};

static void stir(struct stirred *s)
{
    tank_make(&s->tank, WATER, SOLIDS, WALLS, TANK_EFFECTS, NULL);
    tank_shake(&s->tank, 3, 0.3, 0.5, 0);
    s->to = tank_copy(&s->tank, s->tank.y);
    assert_int_equal(mps_create(s->tank.moment, &s->mps), 0);
    memset(s->tank.ydot, 0, (size_t)s->tank.n * sizeof(double));
    if (mps_step(s->mps, 0, h, s->tank.y, s->tank.ydot, s->to) != 0)
        fail_msg("%s", moment_refusal(s->tank.moment));
}

static void clear(struct stirred *s)
{
    mps_free(&s->mps);
    test_free(s->to);
    tank_free(&s->tank);
}

static const double *book(const struct stirred *s)
{
    return s->to + layout_at(&s->tank.moment->layout, s->tank.plan->book.row);
}

static double mass(const struct stirred *s)
{
    return s->tank.moment->particles->m[0];
}

/* Of fluid that has u [n], and what it had more after the step. */
static double kinetic(const struct stirred *s, const double *y)
{
    const struct layout_row *row;
    const long u = tank_at(&s->tank, "velocity of fluid", &row);
    double sum = 0;

    for (long i = 0; i < (long)row->n * DIM; i++)
        sum += 0.5 * mass(s) * y[u + i] * y[u + i];
    return sum;
}

static void works_by_name_are_all_that_changes_the_kinetic_energy(void **state)
{
    struct stirred s;

    (void)state;
    stir(&s);
    const struct plan_book *b = &s.tank.plan->book;
    const double change = kinetic(&s, s.to) - kinetic(&s, s.tank.y);
    double sum = book(&s)[b->walls];
    check(b->solved_works == MPS_WORKS, "%d columns", b->solved_works);
    for (int k = 0; k < MPS_WORKS; k++) {
        sum += book(&s)[b->solved + k];
        check(fabs(book(&s)[b->solved + k]) > 1e-6 * fabs(change), "column %d has %g of %g J", k,
              book(&s)[b->solved + k], change);
    }
    check(fabs(book(&s)[b->walls]) > 1e-6 * fabs(change), "walls gave %g J", book(&s)[b->walls]);
    check(fabs(sum - change) < 1e-11 * kinetic(&s, s.to), "works are %.17g J, the change is %.17g J",
          sum, change);
    check(book(&s)[b->solved + MPS_VISCOSITY] < 0, "viscosity gave %g J",
          book(&s)[b->solved + MPS_VISCOSITY]);
    clear(&s);
}

static void solids_get_what_fluid_loses(void **state)
{
    struct stirred s;

    (void)state;
    stir(&s);
    const struct plan_book *b = &s.tank.plan->book;
    const struct particles *all = s.tank.moment->particles;
    const struct layout_row *row;
    const long u = tank_at(&s.tank, "velocity of fluid", &row);
    for (int d = 0; d < DIM; d++) {
        double sum = 0, size = 0;
        for (int i = 0; i < row->n; i++)
            sum += mass(&s) * (s.to[u + (long)i * DIM + d] - s.tank.y[u + (long)i * DIM + d]);
        for (int o = 0; o < all->objects; o++)
            if (all->object[o].kind != KIND_FLUID) {
                sum += book(&s)[b->impulse + o * DIM + d];
                size += fabs(book(&s)[b->impulse + o * DIM + d]);
            }
        check(size > 0 && fabs(sum) < 1e-11 * size, "direction %d: %g of %g N s are missed", d,
              sum, size);
    }
    clear(&s);
}

/* Panels near and far are all of the tank. */
static void tables_tell_the_forces_of_the_step(void **state)
{
    struct stirred s;

    (void)state;
    stir(&s);
    struct moment *m = s.tank.moment;
    const struct plan_book *b = &s.tank.plan->book;
    double turn = 0, sum = 0;
    assert_int_equal(observe_forces(m, h, s.to), 0);
    for (int o = 0; o < m->particles->objects; o++)
        for (int d = 0; d < DIM; d++)
            if (m->particles->object[o].kind != KIND_FLUID)
                check(fabs(observe_force(m, o)[d] * h - book(&s)[b->impulse + o * DIM + d])
                      < 1e-12, "%s, direction %d: %g N", m->particles->object[o].name, d,
                      observe_force(m, o)[d]);
    for (int k = 0; k < 2; k++) {
        struct observe_panel p;
        observe_panel(m, k, &p);
        turn += p.turn[2];
        sum += p.force[0];
    }
    for (int id = 0; id < m->particles->n; id++) {
        const int o = m->particles->object_of[id];
        const double *f = s.mps->gave.push[id], *x = m->particles->x[id];
        if (strcmp(m->particles->object[o].name, "tank") == 0) {
            turn -= ((x[0] - 0.02) * f[1] - (x[1] - 0.01) * f[0]) / h;
            sum -= f[0] / h;
        }
    }
    check(fabs(sum) < 1e-8 && fabs(turn) < 1e-8, "panels miss %g N, %g N m", sum, turn);
    moment_restart(m);
    assert_int_equal(observe_forces(m, h, s.to), 0);
    check(observe_force(m, 0) == moment_force(m->observer, 0), "a restart keeps the forces");
    clear(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(works_by_name_are_all_that_changes_the_kinetic_energy),
        cmocka_unit_test(solids_get_what_fluid_loses),
        cmocka_unit_test(tables_tell_the_forces_of_the_step),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
