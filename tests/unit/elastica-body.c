/* elastica-body.c -- tests of src/bodies/elastica-body: skin, work, momentum, energy, ends
 * and refusals. */
#include "elastica.h"

/* Bent and turned far, moving, pushed. */
static void far_out(struct bench *b, unsigned seed)
{
    b->def.bent = 200;
    b->def.bent_rate = -900;
    bench_make(b);
    bench_shake(b, seed);
}

static void eight_rows_with_their_scales(void **state)
{
    static const char *const name[] = { "beam.it.u", "beam.it.w", "beam.it.u_slope",
                                        "beam.it.w_slope", "beam.it.u_rate", "beam.it.w_rate",
                                        "beam.it.u_slope_rate", "beam.it.w_slope_rate" };
    const double scale[] = { 0.01, 0.01, 0.01 / 0.025, 0.01 / 0.025, 20, 20, 20 / 0.025,
                             20 / 0.025 };
    struct bench b;

    (void)state;
    bench_defaults(&b);
    bench_make(&b);
    for (int i = 0; i < 8; i++) {
        const struct layout_row *row = &b.layout.row[1 + i];
        assert_string_equal(row->name, name[i]);
        assert_int_equal(row->n, 9);
        assert_int_equal(row->what, i < 4 ? LAYOUT_POSITION : LAYOUT_VELOCITY);
        check_close(row->scale, scale[i], 1e-12, "scale");
    }
    bench_free(&b);
}

/* At rest the skin stands as the linear beam's; layers keep their distance however far the
 * beam is bent and turned. */
static void skin_follows_the_beam(void **state)
{
    double x[BENCH_SKIN][DIM];
    struct bench b;

    (void)state;
    bench_defaults(&b);
    bench_make(&b);
    assert_int_equal(bodies_elastica.skin(b.body, x, NULL), 20 * 3);
    for (int i = 0; i < 60; i++) {
        check_close(x[i][0], 0.3 - (i % 3 - 1) * 0.01, 1e-15, "layer");
        check_close(x[i][1], 0.1 + (i / 3 + 0.5) * 0.01, 1e-15, "row");
    }
    bench_free(&b);
    for (double bent = -400; bent <= 400; bent += 200) {
        bench_defaults(&b);
        b.def.elements = 20;
        b.def.bent = bent;
        bench_make(&b);
        bodies_elastica.skin(b.body, x, NULL);
        for (int i = 0; i + 3 < b.skin; i++) {
            const double layer = hypot(x[i + 1][0] - x[i][0], x[i + 1][1] - x[i][1]);
            const double row = hypot(x[i + 3][0] - x[i][0], x[i + 3][1] - x[i][1]);
            if (i % 3 < 2)
                check_close(layer, 0.01, 1e-15, "distance of layers");
            if (i % 3 == 1)
                check_close(row, 0.01, 5e-4, "distance of rows");
        }
        bench_free(&b);
    }
}

/* u is the time derivative of x along q' = v. */
static void skin_velocity_is_the_rate_of_its_position(void **state)
{
    static double up[BENCH_SKIN][DIM], u[BENCH_SKIN][DIM], down[BENCH_SKIN][DIM];
    const double h = 1e-6;
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.angle = -20;
    far_out(&b, 9);
    bodies_elastica.move(b.body, b.work, &b.layout, 0, b.y, up, u);
    for (int side = -1; side <= 1; side += 2) {
        for (int i = 0; i < bench_dofs(&b); i++)
            b.y[bench_at(&b, i, false)] += (side < 0 ? -h : 2 * h) * b.y[bench_at(&b, i, true)];
        bodies_elastica.move(b.body, b.work, &b.layout, 0, b.y, side < 0 ? down : up, NULL);
    }
    for (int i = 0; i < b.skin; i++)
        for (int d = 0; d < DIM; d++)
            check_close((up[i][d] - down[i][d]) / (2 * h), u[i][d], 1e-7, "u = dx/dt");
    bench_free(&b);
}

/* Sum of force . u is v . F. */
static void work_on_the_skin_is_work_on_the_beam(void **state)
{
    double x[BENCH_SKIN][DIM], u[BENCH_SKIN][DIM];
    struct bench b;

    (void)state;
    for (unsigned seed = 1; seed < 5; seed++) {
        double work = 0, size = 0, given = 0, a[BENCH_DOFS], p[BENCH_DOFS];
        bench_defaults(&b);
        b.def.angle = 37;
        far_out(&b, seed);
        bodies_elastica.move(b.body, b.work, &b.layout, 0, b.y, x, u);
        for (int i = 0; i < b.skin; i++)
            for (int d = 0; d < DIM; d++) {
                work += b.force[i][d] * u[i][d];
                size += fabs(b.force[i][d] * u[i][d]);
            }
        bench_load(&b, 0);
        for (int i = 0; i < bench_dofs(&b); i++)
            a[i] = b.ydot[bench_at(&b, i, true)];
        band_multiply(b.body->beam->mass, a, p);
        for (int i = 0; i < bench_dofs(&b); i++)
            given += p[i] * b.y[bench_at(&b, i, true)];
        check_close(work, given, 1e-12 * size, "virtual work");
        bench_free(&b);
    }
}

static const struct option {
    const char *root, *tip, *inertia;
    bool follower;
} options[] = { { "clamped", "free", "consistent", false }, { "clamped", "free", "lumped", true },
                { "pinned", "free", "consistent", true },
                { "pinned", "free", "lumped-ends", false } };
enum { OPTIONS = sizeof options / sizeof options[0] };

static void choose(struct bench *b, int option)
{
    bench_defaults(b);
    b->def.root = options[option].root;
    b->def.tip = options[option].tip;
    b->def.inertia = options[option].inertia;
    b->def.follower = options[option].follower;
    b->def.angle = 70;
    b->def.load = 7;
    b->def.tip_force = -3;
    b->def.alpha = 2;
    b->def.drag = 0.02;
    b->def.damping_ratio = 0.1;
    b->scales.g[0] = 1.5;
    b->scales.g[1] = -9.81;
    far_out(b, 31);
}

/* d(momentum)/dt = forces of the water + weight + prescribed loads + supports; at a free
 * root's instead there is no support. */
static void supports_close_the_momentum(void **state)
{
    (void)state;
    for (int k = 0; k < OPTIONS; k++) {
        double rate[DIM] = {0}, moving[BENCH_Y];
        struct bench b;
        choose(&b, k);
        bench_rates(&b, 0);
        memcpy(moving, b.y, sizeof moving);
        for (int i = 0; i < bench_dofs(&b); i++)
            moving[bench_at(&b, i, true)] = b.ydot[bench_at(&b, i, true)];
        bodies_elastica.momentum(b.body, b.work, &b.layout, moving, rate);
        for (int d = 0; d < DIM; d++) {
            double given = b.load.support[d] + b.load.applied[d]
                         + bodies_elastica.weight(b.body) * b.scales.g[d];
            for (int i = 0; i < b.skin; i++)
                given += b.force[i][d];
            check_close(given, rate[d], 1e-9 * (1 + fabs(b.load.support[d])), "dP/dt");
        }
        bench_free(&b);
    }
}

/* dE/dt = damping + prescribed loads + water, by central differences along ydot. */
static void energy_changes_by_the_named_powers(void **state)
{
    (void)state;
    for (int k = 0; k < OPTIONS; k++) {
        struct bench b;
        choose(&b, k);
        bench_rates(&b, 0);
        const double power = bench_power(&b) + b.load.damping + b.load.driven;
        const double size = fabs(b.load.damping) + fabs(b.load.driven);
        check_close(bench_energy_rate(&b, 1e-7), power, 2e-5 * size, "dE/dt");
        assert_true(b.load.damping < 0);
        bench_free(&b);
    }
}

/* Bent far and at rest, the root carries what the loads weigh and turn. */
static void root_carries_the_loads(void **state)
{
    struct body_view view;
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.angle = 0;
    b.def.tip_force = -10;
    b.def.elements = 20;
    bench_make(&b);
    bench_settle(&b, 0);
    bench_show(&b, 0, &view);
    assert_true(view.tip[1] < -0.1);
    check_close(view.root_force / -10, 1, 1e-6, "force");
    check_close(view.root_moment / (-10 * (0.2 + view.tip[0])), 1, 1e-4, "moment");
    bench_free(&b);
}

/* A force that turns with the tip stays across it: nothing pulls the tip along. */
static void followers_turn_with_the_beam(void **state)
{
    struct body_view view;
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.angle = 0;
    b.def.tip_force = 10;
    b.def.follower = true;
    b.def.elements = 20;
    bench_make(&b);
    bench_settle(&b, 0);
    bench_load(&b, 0);
    bench_show(&b, 0, &view);
    assert_true(view.tip_angle > 1);
    check_close(b.load.applied[0] / (-10 * sin(view.tip_angle)), 1, 1e-9, "applied x");
    check_close(b.load.applied[1] / (10 * cos(view.tip_angle)), 1, 1e-9, "applied y");
    check_close(view.root_moment / (10 * (cos(view.tip_angle) * (0.2 + view.tip[0])
                                          + sin(view.tip_angle) * view.tip[1])), 1, 1e-4,
                "moment at the root");
    bench_free(&b);
}

/* The same in the beam's own frame in every direction. */
static void direction_does_not_matter(void **state)
{
    static const double angle[] = { 0, 90, 180, -90, 37 };
    double first[BENCH_Y];
    struct bench b;

    (void)state;
    for (int k = 0; k < 5; k++) {
        const double c = cos(angle[k] * M_PI / 180), s = sin(angle[k] * M_PI / 180);
        bench_defaults(&b);
        b.def.angle = angle[k];
        b.def.load = 4;
        far_out(&b, 12);
        for (int i = 0; i < b.skin; i++) {
            const double along = b.force[i][0], across = b.force[i][1];
            b.force[i][0] = c * along - s * across;
            b.force[i][1] = s * along + c * across;
        }
        bench_rates(&b, 0);
        if (k == 0)
            memcpy(first, b.ydot, sizeof first);
        for (int i = 0; i < b.size; i++)
            check_close(b.ydot[i], first[i], 1e-9 * (1 + fabs(first[i])), "rates");
        bench_free(&b);
    }
}

static void held_degrees_of_freedom_never_move(void **state)
{
    static const char *const end[][2] = { { "clamped", "free" }, { "pinned", "clamped" },
                                          { "free", "pinned" } };
    static const int held[][8] = { { 0, 1, 3, -1 }, { 0, 1, 32, 33, 35, -1 }, { 32, 33, -1 } };
    struct bench b;

    (void)state;
    for (int c = 0; c < 3; c++) {
        bench_defaults(&b);
        b.def.root = end[c][0];
        b.def.tip = end[c][1];
        b.def.load = 1;
        bench_make(&b);
        bench_shake(&b, 8);
        const double energy = bench_energy(&b, b.y);
        for (int k = 0; held[c][k] >= 0; k++) /* even if something is written there */
            b.y[bench_at(&b, held[c][k], false)] = b.y[bench_at(&b, held[c][k], true)] = 1;
        check_close(bench_energy(&b, b.y), energy, 0, "energy");
        bench_rates(&b, 0);
        for (int i = 0, k = 0; i < bench_dofs(&b); i++) {
            const bool is_held = held[c][k] == i;
            k += is_held;
            assert_true((b.ydot[bench_at(&b, i, true)] == 0) == is_held);
            assert_true((b.ydot[bench_at(&b, i, false)] == 0) == is_held);
        }
        bench_free(&b);
    }
}

static void loads_end_when_told(void **state)
{
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.load = 3;
    b.def.follower = true;
    b.def.load_until = 0.5;
    far_out(&b, 2);
    check_close(bodies_elastica.watch->event(b.body, 0.1), 0.5, 0, "event");
    assert_true(bodies_elastica.watch->event(b.body, 0.5) == HUGE_VAL);
    bench_load(&b, 0.4);
    assert_true(b.load.driven != 0);
    bench_load(&b, 0.5);
    assert_true(b.load.driven == 0 && b.load.applied[0] == 0);
    bench_free(&b);
}

static void refuses_what_cannot_stand(void **state)
{
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.bent = 10;
    b.def.tip = "pinned";
    bench_refuses(&b, "tip");
    bench_defaults(&b);
    b.def.theory = "linear";
    b.def.follower = true;
    bench_refuses(&b, "elastica");
}

/* "linear" and "elastica" are two kinds with the same parameters. */
/* Of the linear beam it goes to alpha, which holds on to the ground. */
static void damping_ratio_turns_with_the_beam(void **state)
{
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.damping_ratio = 0.05;
    b.def.beta = 1e-3;
    bench_make(&b);
    const struct bending_def *d = &b.body->beam->def.bending;
    check_close(d->beta * bending_first(d) - 1e-3 * bending_first(d), 2 * 0.05, 1e-13, "beta");
    check_close(d->alpha, 0, 0, "alpha");
    bench_free(&b);
}

static void theory_chooses_the_kind(void **state)
{
    struct bench b;

    (void)state;
    bench_defaults(&b);
    assert_ptr_equal(bodies_beam.identity.choose(&b.def), &bodies_elastica);
    b.def.theory = "linear";
    assert_ptr_equal(bodies_beam.identity.choose(&b.def), &bodies_beam);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eight_rows_with_their_scales),
        cmocka_unit_test(skin_follows_the_beam),
        cmocka_unit_test(skin_velocity_is_the_rate_of_its_position),
        cmocka_unit_test(work_on_the_skin_is_work_on_the_beam),
        cmocka_unit_test(supports_close_the_momentum),
        cmocka_unit_test(energy_changes_by_the_named_powers),
        cmocka_unit_test(root_carries_the_loads),
        cmocka_unit_test(followers_turn_with_the_beam),
        cmocka_unit_test(direction_does_not_matter),
        cmocka_unit_test(held_degrees_of_freedom_never_move),
        cmocka_unit_test(loads_end_when_told),
        cmocka_unit_test(refuses_what_cannot_stand),
        cmocka_unit_test(damping_ratio_turns_with_the_beam),
        cmocka_unit_test(theory_chooses_the_kind),
    };

    return cmocka_run_group_tests_name("elastica-body", tests, NULL, NULL);
}
