/* beam-options.c -- tests of src/bodies/beam: with (44) and (45) of Toth (2012) a run keeps its
 * books, a beam weighs what it moves, and no eigenvalue exceeds the limit. */
#include "beam.h"

struct books { /* sums over the steps of a run */
    double power;        /* damping and prescribed loads       [J/m]   */
    double impulse[DIM]; /* supports, prescribed loads, weight [N s/m] */
};

/* One step of the implicit midpoint rule, whose balances of energy and momentum are exact:
 * y_middle - h/2 f_I(y_middle) = y + h/2 f_E, f_E being constant here. */
static void step(struct bench *b, double t, double h, struct books *books)
{
    double r[BENCH_Y], before[BENCH_Y];

    memcpy(before, b->y, sizeof before);
    memset(b->ydot, 0, sizeof b->ydot);
    bench_load(b, t);
    for (int i = 0; i < BENCH_Y; i++)
        r[i] = before[i] + h / 2 * b->ydot[i];
    assert_int_equal(bench_solve(b, t, h / 2, r, b->y), STATUS_DONE);
    bench_load(b, t);
    books->power += h * (b->load.damping + b->load.driven);
    for (int d = 0; d < DIM; d++)
        books->impulse[d] += h * (b->load.support[d] + b->load.applied[d]
                                  + bodies_beam.weight(b->body) * b->scales.g[d]);
    for (int i = 0; i < BENCH_Y; i++)
        b->y[i] = 2 * b->y[i] - before[i];
}

static void check_books(int option)
{
    struct books books = {0};
    double most = 0;
    struct bench b;

    bench_defaults(&b);
    bench_choose(&b, option);
    b.def.angle = 25;
    b.def.tip_force = 0.4;
    b.def.load = -2;
    b.def.damping_ratio = 0.01;
    b.scales.g[0] = 3;
    b.scales.g[1] = -9.81;
    bench_make(&b);
    const double period = 2 * M_PI / bending_first(&b.body->bending->def);
    const double energy = bench_energy(&b, b.y), mass = bench_mass(&b);
    for (int i = 0; i < 270; i++) {
        double p[DIM] = {0};
        step(&b, i * period / 100, period / 100, &books);
        bodies_beam.momentum(b.body, b.work, &b.layout, b.y, p);
        for (int d = 0; d < DIM; d++)
            check_close(p[d], books.impulse[d], 1e-10 * mass * 9.81 * period, "momentum");
        most = fmax(most, fabs(p[1]) / (mass * 9.81 * period));
    }
    check_close((bench_energy(&b, b.y) - energy) / books.power, 1, 1e-9, "energy");
    assert_true(b.load.damping < 0 && most > 1e-3);
    bench_free(&b);
}

static void books_close_over_a_run_of_each_option(void **state)
{
    (void)state;
    for (int i = 0; i < BENCH_OPTIONS; i++)
        check_books(i);
}

/* Lying, every node of a lumped beam weighs m g (ends by `end`) and bends the cantilever as
 * F a^2 (3 L - a)/(6 EI) from a; the root carries the mass that momentum counts. */
static void check_weight(const char *inertia, double end)
{
    const double EI = 2e6 * 1e-6 / 12, L = 0.2, l = 0.025, m = 1200 * 0.01 * l, g = 9.81;
    double bent = 0, moment = 0;
    struct body_view view;
    struct bench b;

    bench_defaults(&b);
    b.def.inertia = inertia;
    b.def.angle = 0;
    b.scales.g[1] = -g;
    bench_make(&b);
    for (int i = 1; i <= 8; i++) {
        const double a = i * l, F = (i < 8 ? 1 : end) * m * g;
        bent += F * a * a * (3 * L - a) / (6 * EI);
        moment += F * a;
    }
    bench_settle(&b, 0);
    bench_show(&b, 0, &view);
    check_close(view.tip[1] / -bent, 1, 1e-8, "tip under weight");
    check_close(view.root_force / (-(7 + 2 * end) * m * g), 1, 1e-6, "root force");
    check_close(view.root_moment / -moment, 1, 1e-6, "root moment");
    check_close(bodies_beam.weight(b.body), (7 + 2 * end) * m, 1e-14, "mass");
    bench_free(&b);
}

static void a_lumped_beam_weighs_its_nodes(void **state)
{
    (void)state;
    check_weight("lumped", 1);
    check_weight("lumped-ends", 0.5);
}

/* Drag takes d v^2 from every deflection and rotation, and only that. */
static void drag_takes_its_power(void **state)
{
    double squares = 0;
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.drag = 0.7;
    bench_make(&b);
    bench_shake(&b, 6);
    bench_load(&b, 0);
    for (int i = 0; i < bench_dofs(&b); i++)
        squares += pow(b.y[bench_at(&b, i, true)], 2);
    check_close(b.load.damping / (0.7 * squares), -1, 1e-14, "power of drag");
    bench_free(&b);
}

/* Lowest place of the tip over two periods after it was let go of, over where it started. */
static double swing_back(int elements, const char *inertia)
{
    struct books unused = {0};
    struct bench b;
    double least = 1;

    bench_defaults(&b);
    b.def.length = 0.08;
    b.def.thickness = 4e-3;
    b.def.E = 0.5e9;
    b.def.density = 0;
    b.def.mass = 0.165;
    b.def.elements = elements;
    b.def.inertia = inertia;
    b.def.drag = 0.01;
    b.def.tip_force = 10;
    b.def.load_until = 1;
    bench_make(&b);
    bench_settle(&b, 0);
    const double start = b.y[bench_at(&b, 2 * elements, false)];
    for (int i = 0; i < 400; i++) {
        step(&b, 1, 0.01006 / 200, &unused);
        least = fmin(least, b.y[bench_at(&b, 2 * elements, false)] / start);
    }
    bench_free(&b);
    return least;
}

static void the_seeds_drag_stops_swings_on_fine_meshes(void **state)
{
    (void)state;
    assert_true(swing_back(10, "lumped") < -0.2);
    assert_true(swing_back(10, "consistent") < -0.2);
    assert_true(swing_back(100, "lumped") > 0);
    assert_true(swing_back(100, "consistent") > 0);
}

/* No eigenvalue of the stiff side exceeds the limit, which is at most twice the largest. */
static void check_limit(const char *inertia, int elements, double drag, double beta)
{
    struct limit limit = {0};
    struct bench b;
    double most = 0;

    bench_defaults(&b);
    b.def.inertia = inertia;
    b.def.elements = elements;
    b.def.drag = drag;
    b.def.beta = beta;
    bench_make(&b);
    gsl_vector_complex *lambda = bending_eigenvalues(b.body->bending);
    for (size_t i = 0; i < lambda->size; i++)
        most = fmax(most, gsl_complex_abs(gsl_vector_complex_get(lambda, i)));
    gsl_vector_complex_free(lambda);
    bodies_beam.implicit->limit(b.body, &limit);
    if (!(limit.rate >= most * (1 - 1e-6) && limit.rate <= 2.03 * most))
        fail_msg("%s, %d elements, drag %g, beta %g: limit %g, largest eigenvalue %g", inertia,
                 elements, drag, beta, limit.rate, most);
    bench_free(&b);
}

static void limit_bounds_every_eigenvalue(void **state)
{
    static const char *const inertia[] = { "consistent", "lumped", "lumped-ends" };

    (void)state;
    for (int i = 0; i < 3; i++)
        for (int n = 1; n <= 9; n += 4)
            for (double drag = 1e-6; drag < 1e3; drag *= 7) {
                check_limit(inertia[i], n, drag, 0);
                check_limit(inertia[i], n, drag, 1e-4);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(books_close_over_a_run_of_each_option),
        cmocka_unit_test(a_lumped_beam_weighs_its_nodes),
        cmocka_unit_test(drag_takes_its_power),
        cmocka_unit_test(the_seeds_drag_stops_swings_on_fine_meshes),
        cmocka_unit_test(limit_bounds_every_eigenvalue),
    };

    return cmocka_run_group_tests_name("beam-options", tests, NULL, NULL);
}
