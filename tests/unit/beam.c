/* beam.c -- tests of src/bodies/beam: parameters, layout, skin and refusals. */
#include "beam.h"

static void parameters_have_units_ranges_and_sentences(void **state)
{
    (void)state;
    assert_ptr_equal(bodies_table[0], &bodies_beam);
    for (const struct param *r = bodies_beam.identity.params; r->key; r++) {
        assert_non_null(r->unit);
        assert_true(r->about && r->about[0]);
        if (r->type == PARAM_NUMBER || r->type == PARAM_INTEGER)
            assert_true(r->max > r->min
                        && (r->required || (r->fallback >= r->min && r->fallback <= r->max)));
    }
}

static void four_rows_with_their_scales(void **state)
{
    static const char *const name[] = { "beam.it.w", "beam.it.theta", "beam.it.w_rate",
                                        "beam.it.theta_rate" };
    const double scale[] = { 0.01, 0.01 / 0.025, 20, 20 / 0.025 };
    struct bench b;

    (void)state;
    bench_defaults(&b);
    bench_make(&b);
    for (int i = 0; i < 4; i++) {
        const struct layout_row *row = &b.layout.row[1 + i];
        assert_string_equal(row->name, name[i]);
        assert_int_equal(row->n, 9);
        assert_int_equal(row->what, i < 2 ? LAYOUT_POSITION : LAYOUT_VELOCITY);
        check_close(row->scale, scale[i], 1e-12, "scale");
    }
    bench_free(&b);
    bench_defaults(&b); /* without water the first mode gives the speed */
    b.scales.fluid = false;
    bench_make(&b);
    check_close(b.layout.row[3].scale,
                0.01 * pow(1.875104069 / 0.2, 2) * sqrt(2e6 * 1e-4 / 12 / 1200), 1e-9, "omega h");
    bench_free(&b);
}

static void skin_is_centred_on_the_axis(void **state)
{
    double x[BENCH_SKIN][DIM], mean[DIM] = {0};
    struct bench b;
    enum kind kind;

    (void)state;
    bench_defaults(&b);
    b.def.length = 0.203; /* 20 rows, fitted */
    b.def.angle = 0;
    bench_make(&b);
    assert_int_equal(b.skin, 20 * 3);
    assert_int_equal(bodies_beam.skin(b.body, x, &kind), 60);
    for (int i = 0; i < 60; i++)
        for (int d = 0; d < DIM; d++)
            mean[d] += x[i][d] / 60;
    check_close(mean[0], 0.3 + 0.203 / 2, 1e-14, "middle along");
    check_close(mean[1], 0.1, 1e-14, "middle across");
    check_close(x[0][0], 0.3 + 0.203 / 40, 1e-15, "first row at half a spacing");
    check_close(x[0][1], 0.09, 1e-15, "first layer");
    check_close(x[3][0] - x[0][0], 0.203 / 20, 1e-15, "rows are evenly spaced");
    assert_int_equal(kind, KIND_SKIN);
    bench_free(&b);
    bench_defaults(&b);
    b.def.layers = 4;
    b.def.slip = true;
    bench_make(&b);
    assert_int_equal(b.skin, 20 * 4);
    bodies_beam.skin(b.body, NULL, &kind);
    assert_int_equal(kind, KIND_SKIN_SLIP);
    bench_free(&b);
    bench_defaults(&b); /* support 2.5 dx needs three layers too */
    b.scales.support = 0.025;
    bench_make(&b);
    assert_int_equal(b.skin, 20 * 3);
    bench_free(&b);
}

/* u is the time derivative of x along q' = v. */
static void skin_velocity_is_the_rate_of_its_position(void **state)
{
    double x[BENCH_SKIN][DIM], u[BENCH_SKIN][DIM], later[BENCH_SKIN][DIM], w[BENCH_SKIN][DIM];
    const double h = 0.01;
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.angle = -20;
    bench_make(&b);
    bench_shake(&b, 9);
    bodies_beam.move(b.body, b.work, &b.layout, 0, b.y, x, u);
    for (int i = 0; i < bench_dofs(&b); i++)
        b.y[bench_at(&b, i, false)] += h * b.y[bench_at(&b, i, true)];
    bodies_beam.move(b.body, b.work, &b.layout, h, b.y, later, w);
    for (int i = 0; i < b.skin; i++)
        for (int d = 0; d < DIM; d++)
            check_close((later[i][d] - x[i][d]) / h, u[i][d], 1e-12, "u = dx/dt");
    bench_free(&b);
}

static void stiff_adds_and_load_sets(void **state)
{
    struct bench b;

    (void)state;
    bench_defaults(&b);
    bench_make(&b);
    bench_shake(&b, 2);
    for (int i = 0; i < BENCH_Y; i++)
        b.ydot[i] = 5;
    bench_load(&b, 0);
    check_close(b.ydot[bench_at(&b, 6, false)], 0, 0, "explicit rate of w");
    const double before = b.ydot[bench_at(&b, 6, true)];
    bodies_beam.implicit->stiff(b.body, b.work, &b.layout, 0, b.y, b.ydot);
    check_close(b.ydot[bench_at(&b, 6, false)], b.y[bench_at(&b, 6, true)], 0, "w' = v");
    assert_true(b.ydot[bench_at(&b, 6, true)] != before);
    for (int i = 0; i < 3; i++)
        check_close(b.ydot[i], 5, 0, "rows of others");
    bench_free(&b);
}

static void held_degrees_of_freedom_never_move(void **state)
{
    static const char *const end[][2] = { { "clamped", "free" }, { "pinned", "clamped" },
                                          { "free", "pinned" } };
    static const int held[][4] = { { 0, 1, -1, -1 }, { 0, 16, 17, -1 }, { 16, -1, -1, -1 } };
    struct bench b;

    (void)state;
    for (int c = 0; c < 3; c++) {
        bench_defaults(&b);
        b.def.root = end[c][0];
        b.def.tip = end[c][1];
        b.def.load = 1;
        bench_make(&b);
        bench_shake(&b, 8);
        for (int k = 0; k < 4 && held[c][k] >= 0; k++)
            b.y[bench_at(&b, held[c][k], true)] = 1; /* even if something is written there */
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

/* The same forces in the beam's own frame bend it the same in every direction. */
static void direction_does_not_matter(void **state)
{
    static const double angle[] = { 0, 90, 180, -90, 37 };
    double first[BENCH_Y];
    struct bench b;

    (void)state;
    for (int k = 0; k < 5; k++) {
        const double c = cos(angle[k] * M_PI / 180), s = sin(angle[k] * M_PI / 180);
        struct body_view view;
        bench_defaults(&b);
        b.def.angle = angle[k];
        b.def.load = 4;
        bench_make(&b);
        bench_shake(&b, 12);
        for (int i = 0; i < b.skin; i++) {
            const double along = b.force[i][0], across = b.force[i][1];
            b.force[i][0] = c * along - s * across;
            b.force[i][1] = s * along + c * across;
        }
        bench_rates(&b, 0);
        if (k == 0)
            memcpy(first, b.ydot, sizeof first);
        for (int i = 0; i < b.size; i++)
            check_close(b.ydot[i], first[i], 1e-12 * (1 + fabs(first[i])), "rates");
        bench_show(&b, 0, &view);
        const double w = b.y[bench_at(&b, 16, false)];
        check_close(view.tip[0], -s * w, 1e-15, "tip x");
        check_close(view.tip[1], c * w, 1e-15, "tip y");
        bench_free(&b);
    }
    bench_defaults(&b);
    bench_make(&b);
    assert_true(b.body->along[0] == 0 && b.body->along[1] == 1 && b.body->normal[0] == -1);
    bench_free(&b);
}

static void loads_end_when_told(void **state)
{
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.load = 100;
    b.def.load_until = 0.5;
    bench_make(&b);
    bench_shake(&b, 4);
    memset(b.force, 0, sizeof b.force);
    bench_load(&b, 0.49);
    assert_true(b.ydot[bench_at(&b, 16, true)] != 0 && b.load.driven != 0);
    bench_load(&b, 0.5);
    assert_true(b.ydot[bench_at(&b, 16, true)] == 0 && b.load.driven == 0);
    bench_free(&b);
}

static void limit_names_the_beam(void **state)
{
    struct limit limit;
    struct bench b;

    (void)state;
    bench_defaults(&b);
    bench_make(&b);
    bodies_beam.implicit->limit(b.body, &limit);
    check_close(limit.rate, b.body->bending->fastest, 0, "rate");
    assert_false(limit.decay);
    assert_int_equal(limit.where, 7);
    assert_string_equal(limit.part, "beam.it");
    bench_free(&b);
    bench_defaults(&b); /* D so large that the fastest mode only creeps: beta omega^2 */
    b.def.beta = 1;
    bench_make(&b);
    bodies_beam.implicit->limit(b.body, &limit);
    assert_true(limit.decay);
    check_close(limit.rate / pow(b.body->bending->fastest, 2), 1, 1e-6, "rate of decay");
    bench_free(&b);
}

static void refuses_what_cannot_stand(void **state)
{
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.root = b.def.tip = "free";
    bench_refuses(&b, "both free");
    bench_defaults(&b);
    b.def.root = b.def.tip = "clamped";
    b.def.elements = 1;
    bench_refuses(&b, "elements");
    bench_defaults(&b);
    b.def.mass = 2;
    bench_refuses(&b, "both density");
    b.def.mass = b.def.density = 0;
    bench_refuses(&b, "neither density nor mass");
    bench_defaults(&b);
    b.def.tip = "pinned";
    b.def.tip_force = 1;
    bench_refuses(&b, "tip_force");
    bench_defaults(&b);
    b.def.thickness = 0.3;
    bench_refuses(&b, "thickness");
    bench_defaults(&b);
    b.def.load_until = 1;
    bench_refuses(&b, "load_until");
}

/* The mass of Toth (2012): 0.165 kg, EI 2.667 N m: omega_1 = 624.7 rad/s. */
static void mass_may_be_given_instead_of_density(void **state)
{
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.length = 0.08;
    b.def.thickness = 0.004;
    b.def.E = 0.5e9;
    b.def.density = 0;
    b.def.mass = 0.165;
    bench_make(&b);
    check_close(bodies_beam.weight(b.body), 0.165, 1e-15, "mass");
    check_close(bending_first(&b.body->bending->def), 624.7, 0.1, "omega_1");
    bench_free(&b);
}

/* w = s^3 + 2 s^2, integrated from 0. */
static double integral(double s)
{
    return pow(s, 4) / 4 + 2 * pow(s, 3) / 3;
}

/* Of elements shorter than its share of the length a point moves with the mean, and forces
 * go back by the transpose. */
static void short_elements_move_points_by_their_mean(void **state)
{
    const struct skin_def def = { .along = { 0, 1 }, .normal = { -1, 0 }, .length = 1,
                                       .spacing = 0.26, .elements = 10, .layers = 2 };
    double q[22], v[22], f[22] = { 0 }, x[8][DIM], u[8][DIM], work = 0, given = 0, sum = 0;
    const double force[8][DIM] = { { 1, 2 }, { -3, 1 }, { 0.5, 0 }, { 2, 0 }, { 1 }, { -1 }, { 4 },
                                   { 2 } };
    struct beam_skin *s;

    (void)state;
    assert_int_equal(beam_skin_create(&def, &s), STATUS_DONE);
    assert_int_equal(s->points, 8);
    for (int i = 0; i <= 10; i++) {
        const double at = 0.1 * i;
        q[2 * i] = at * at * at + 2 * at * at;
        q[2 * i + 1] = 3 * at * at + 4 * at;
        v[2 * i] = sin(7.0 * i);
        v[2 * i + 1] = cos(5.0 * i);
    }
    beam_skin_move(s, q, v, x, u);
    for (int i = 0; i < 8; i++) {
        const double low = i / 2 * 0.25, mean = (integral(low + 0.25) - integral(low)) / 0.25;
        const double eta = (i % 2 - 0.5) * 0.26;
        check_close(x[i][0], -(eta + mean), 1e-14, "mean deflection");
        work += force[i][0] * u[i][0];
        sum += force[i][0];
    }
    beam_skin_load(s, force, f);
    for (int i = 0; i < 22; i++)
        given += f[i] * v[i];
    check_close(work, given, 1e-13, "virtual work");
    given = 0;
    for (int i = 0; i < 22; i += 2)
        given -= f[i];
    check_close(sum, given, 1e-13, "sum of forces");
    beam_skin_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(short_elements_move_points_by_their_mean),
        cmocka_unit_test(parameters_have_units_ranges_and_sentences),
        cmocka_unit_test(four_rows_with_their_scales),
        cmocka_unit_test(skin_is_centred_on_the_axis),
        cmocka_unit_test(skin_velocity_is_the_rate_of_its_position),
        cmocka_unit_test(stiff_adds_and_load_sets),
        cmocka_unit_test(held_degrees_of_freedom_never_move),
        cmocka_unit_test(direction_does_not_matter),
        cmocka_unit_test(loads_end_when_told),
        cmocka_unit_test(limit_names_the_beam),
        cmocka_unit_test(refuses_what_cannot_stand),
        cmocka_unit_test(mass_may_be_given_instead_of_density),
    };

    return cmocka_run_group_tests_name("beam", tests, NULL, NULL);
}
