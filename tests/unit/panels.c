/* panels.c -- unit tests of panels, in 2D and 3D: the sides of a frame make up the frame, a
 * cut in two makes up the whole, moments about two points differ by the force's own, and
 * impulses grow by the forces. */
#include "../physics/tank.h"

#include "eval/inside.h"
#include "space/list.h"

#include <math.h>
#include <string.h>

#if DIM == 2
#define SIDES "a = { of = \"tank\"; side = \"left\"; }; b = { of = \"tank\"; side = \"right\"; };" \
    " c = { of = \"tank\"; side = \"bottom\"; }; d = { of = \"tank\"; side = \"top\"; };"
#define AT "[0.3, -0.2]"
#define LOW(x) "from = [" x ", -1.0]; "
#define HIGH(x) "to = [" x ", 1.0]; "
#define ALONG "[3.0, 4.0]"
#else
#define SIDES "a = { of = \"tank\"; side = \"left\"; }; b = { of = \"tank\"; side = \"right\"; };" \
    " c = { of = \"tank\"; side = \"bottom\"; }; d = { of = \"tank\"; side = \"top\"; };" \
    " e = { of = \"tank\"; side = \"front\"; }; f = { of = \"tank\"; side = \"back\"; };"
#define AT "[0.3, -0.2, 0.7]"
#define LOW(x) "from = [" x ", -1.0, -1.0]; "
#define HIGH(x) "to = [" x ", 1.0, 1.0]; "
#define ALONG "[3.0, 0.0, 4.0]"
#endif

enum { FACES = 2 * DIM, WHOLE = FACES, AWAY, LEFT_HALF, RIGHT_HALF, PANELS };

#define PANEL_SCENE "panel = { " SIDES " whole = { of = \"tank\"; along = " ALONG "; };"  \
    " away = { of = \"tank\"; about = " AT "; };"                                         \
    " less = { of = \"tank\"; " HIGH("0.03") " }; more = { of = \"tank\"; " LOW("0.03") " }; };"

static void make(struct tank *t)
{
    tank_make(t, tank_water, tank_frame, TANK_EFFECTS, PANEL_SCENE, NULL);
    tank_shake(t, 5, 0.1, 0.5, 1e-3);
    assert_int_equal(plan_panels(t->plan), PANELS);
    assert_int_equal(observe_forces(t->moment, 0, t->y), 0);
}

static struct observe_panel panel(const struct tank *t, int i)
{
    struct observe_panel p;

    observe_panel(t->moment, i, &p);
    return p;
}

static const double *tank_force(const struct tank *t)
{
    const struct particles *all = plan_particles(t->plan);

    for (int i = 0; i < all->objects; i++)
        if (strcmp(all->object[i].name, "tank") == 0)
            return observe_force(t->moment, i);
    fail_msg("no tank");
    return NULL;
}

static double size(const double *f)
{
    double sum = 0;

    for (int d = 0; d < DIM; d++)
        sum = hypot(sum, f[d]);
    return sum;
}

/* Panels from..to-1 add up to the whole. */
static void assert_sum(const struct tank *t, int from, int to)
{
    const double *whole = tank_force(t);
    const struct observe_panel all = panel(t, WHOLE);
    double force[DIM] = { 0 }, turn[3] = { 0 };

    check(size(whole) > 1, "the water presses with %g N only", size(whole));
    for (int i = from; i < to; i++)
        for (int d = 0; d < 3; d++) {
            turn[d] += panel(t, i).turn[d];
            if (d < DIM)
                force[d] += panel(t, i).force[d];
        }
    for (int d = 0; d < DIM; d++)
        check(fabs(force[d] - whole[d]) < 1e-12 * size(whole), "parts have %.17g, the whole %.17g",
              force[d], whole[d]);
    for (int d = 0; d < 3; d++)
        check(fabs(turn[d] - all.turn[d]) < 1e-12 * size(whole),
              "parts turn by %.17g, all by %.17g", turn[d], all.turn[d]);
}

static void test_sides_make_up_the_frame(void **state)
{
    struct tank t;

    (void)state;
    make(&t);
    assert_sum(&t, 0, FACES);
    for (int i = 0; i < FACES; i++) /* water meets all but the lid */
        check((size(panel(&t, i).force) > 1e-3) == (i != 3), "side %d has %g N", i,
              size(panel(&t, i).force));
    check(panel(&t, 0).force[0] < 0 && panel(&t, 1).force[0] > 0, "walls are pushed outwards");
    check(panel(&t, 2).force[DIM - 1] < 0, "and the floor down");
    assert_sum(&t, LEFT_HALF, RIGHT_HALF + 1);
    tank_free(&t);
}

/* m_A - m_B = (B - A) x F. */
static void test_moments(void **state)
{
    const double b[3] = { 0.3, -0.2, DIM == 3 ? 0.7 : 0 };
    struct observe_panel near, far;
    double f[3] = { 0 };
    struct tank t;

    (void)state;
    make(&t);
    near = panel(&t, WHOLE);
    far = panel(&t, AWAY);
    memcpy(f, near.force, sizeof near.force);
    for (int d = DIM == 2 ? 2 : 0; d < 3; d++) {
        const int i = (d + 1) % 3, k = (d + 2) % 3;
        const double wanted = b[i] * f[k] - b[k] * f[i];
        check(fabs(near.turn[d] - far.turn[d] - wanted) < 1e-12 * size(f), "%.17g is not %.17g",
              near.turn[d] - far.turn[d], wanted);
        check(fabs(wanted) > 1e-6 || d != 2, "nothing is tried");
    }
    check(fabs(near.drag - (0.6 * f[0] + 0.8 * f[DIM - 1])) < 1e-12 * size(f), "drag %g",
          near.drag);
    assert_true(isnan(far.drag));
    tank_free(&t);
}

/* A moment by hand: of all particles' forces, with what each of them has. */
static void test_moment_by_hand(void **state)
{
    const struct particles *all;
    double turn = 0;
    struct tank t;

    (void)state;
    make(&t);
    all = t.moment->observer->particles;
    for (int k = KIND_WALL; k <= KIND_WALL_SLIP; k++)
        for (int i = all->from[k]; i < all->from[k + 1]; i++) {
            const int s = t.moment->observer->list->slot[i];
            const double *f = t.moment->work->f + (size_t)s * DIM, *x = all->x0[i];
            if (s >= 0)
                turn += x[0] * f[1] - x[1] * f[0];
        }
    check(fabs(turn - panel(&t, WHOLE).turn[2]) < 1e-12 * fabs(turn) + 1e-12, "%g is not %g",
          panel(&t, WHOLE).turn[2], turn);
    tank_free(&t);
}

/* Impulses are quadratures beside all others of the book. */
static void test_impulses_grow_by_forces(void **state)
{
    double *ydot;
    struct tank t;

    (void)state;
    make(&t);
    ydot = tank_copy(&t, t.y);
    tank_rates(&t, 0, t.y, ydot);
    for (int i = 0; i < PANELS; i++)
        for (int d = 0; d < DIM; d++)
            assert_true(plan_panel_impulse(t.plan, ydot, i)[d] == panel(&t, i).force[d]);
    test_free(ydot);
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sides_make_up_the_frame),
        cmocka_unit_test(test_moments),
        cmocka_unit_test(test_moment_by_hand),
        cmocka_unit_test(test_impulses_grow_by_forces),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
