/* beam-balance.c -- tests of src/bodies/beam: work, momentum, energy and the implicit
 * solve agree with each other to rounding. */
#include "beam.h"

/* A straight beam's skin stands at rest; sum of force . u is v . N^T force. */
static void work_on_the_skin_is_work_on_the_beam(void **state)
{
    double x[BENCH_SKIN][DIM], u[BENCH_SKIN][DIM], rest[BENCH_SKIN][DIM], none[BENCH_Y] = {0};
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.angle = 37;
    bench_make(&b);
    bodies_beam.skin(b.body, rest, NULL);
    bodies_beam.move(b.body, b.work, &b.layout, 0, b.y, x, u);
    assert_memory_equal(x, rest, b.skin * sizeof x[0]);
    for (unsigned seed = 1; seed < 5; seed++) {
        double work = 0, size = 0, given = 0, v[BENCH_DOFS], a[BENCH_DOFS], p[BENCH_DOFS];
        bench_shake(&b, seed);
        bodies_beam.move(b.body, b.work, &b.layout, 0, b.y, x, u);
        for (int i = 0; i < b.skin; i++)
            for (int d = 0; d < DIM; d++) {
                work += b.force[i][d] * u[i][d];
                size += fabs(b.force[i][d] * u[i][d]);
            }
        memcpy(b.ydot, none, sizeof none);
        bench_load(&b, 0);
        for (int i = 0; i < bench_dofs(&b); i++) {
            v[i] = b.y[bench_at(&b, i, true)];
            a[i] = b.ydot[bench_at(&b, i, true)];
        }
        band_multiply(b.body->bending->mass_free, a, p);
        for (int i = 0; i < bench_dofs(&b); i++)
            given += p[i] * v[i];
        check_close(work, given, 1e-12 * size, "virtual work");
    }
    bench_free(&b);
}

/* d(momentum)/dt = forces of the water + weight + prescribed loads + supports. */
static void check_momentum(int option, const char *root, const char *tip, double angle)
{
    double rate[DIM] = {0}, given[DIM], moving[BENCH_Y];
    struct bench b;

    bench_defaults(&b);
    bench_choose(&b, option);
    b.def.root = root;
    b.def.tip = tip;
    b.def.angle = angle;
    b.def.load = 7;
    b.def.tip_force = strcmp(tip, "free") == 0 ? 3 : 0;
    b.def.alpha = 2;
    b.def.beta = 1e-3;
    b.scales.g[0] = 1.5;
    b.scales.g[1] = -9.81;
    bench_make(&b);
    bench_shake(&b, 31);
    bench_rates(&b, 0);
    memcpy(moving, b.y, sizeof moving);
    for (int i = 0; i < bench_dofs(&b); i++)
        moving[bench_at(&b, i, true)] = b.ydot[bench_at(&b, i, true)];
    bodies_beam.momentum(b.body, b.work, &b.layout, moving, rate);
    for (int d = 0; d < DIM; d++) {
        const double across = d == 0 ? -sin(angle * M_PI / 180) : cos(angle * M_PI / 180);
        given[d] = b.load.support[d] + bodies_beam.weight(b.body) * b.scales.g[d]
                 + (b.def.load * b.def.length + b.def.tip_force) * across;
        for (int i = 0; i < b.skin; i++)
            given[d] += b.force[i][d];
        check_close(given[d], rate[d], 1e-9 * (1 + fabs(b.load.support[d])), "dP/dt");
    }
    check_close(bodies_beam.weight(b.body), bench_mass(&b), 1e-14, "mass");
    bench_free(&b);
}

static void supports_close_the_momentum(void **state)
{
    (void)state;
    for (int i = 0; i < BENCH_OPTIONS; i++) {
        check_momentum(i, "clamped", "free", 90);
        check_momentum(i, "clamped", "clamped", 37);
        check_momentum(i, "free", "pinned", 0);
        check_momentum(i, "pinned", "free", -110);
    }
}

/* Without drag the supports are what the held nodes feel; show() has the root's. */
static void support_of_a_cantilever_is_its_root(void **state)
{
    struct body_view view;
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.angle = 0;
    b.def.beta = 1e-4;
    b.scales.g[1] = -9.81;
    bench_make(&b);
    bench_shake(&b, 5);
    bench_load(&b, 0);
    bench_show(&b, 0, &view);
    check_close(view.root_force, -b.load.support[1], 1e-9 * fabs(view.root_force), "root force");
    bench_free(&b);
}

/* dE/dt = damping + prescribed loads + water; E is quadratic, so that a central
 * difference along ydot is exact. */
static void check_energy(int option)
{
    struct bench b;

    bench_defaults(&b);
    bench_choose(&b, option);
    b.def.angle = 60;
    b.def.load = 11;
    b.def.tip_force = -2;
    b.def.alpha = 3;
    b.def.beta = 1e-5;
    b.scales.g[0] = 2;
    b.scales.g[1] = -9.81;
    bench_make(&b);
    for (unsigned seed = 1; seed < 5; seed++) {
        bench_shake(&b, seed);
        bench_rates(&b, 0);
        const double power = bench_power(&b) + b.load.damping + b.load.driven;
        check_close(bench_energy_rate(&b, 1e-6) / power, 1, 1e-7, "dE/dt");
    }
    bench_free(&b);
}

static void energy_changes_by_the_named_powers(void **state)
{
    (void)state;
    for (int i = 0; i < BENCH_OPTIONS; i++)
        check_energy(i);
}

static void potential_counts_from_the_low_corner(void **state)
{
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.scales.g[1] = -10;
    b.scales.low[1] = -0.5;
    bench_make(&b); /* upright, its middle 0.2 above 0 */
    check_close(bench_energy(&b, b.y), 2.4 * 10 * 0.7, 1e-12, "potential at rest");
    bench_free(&b);
}

static void damping_only_takes(void **state)
{
    struct energies e = {0};
    struct bench b;

    (void)state;
    bench_defaults(&b);
    bench_make(&b);
    bench_shake(&b, 3);
    bench_load(&b, 0);
    check_close(b.load.damping, 0, 0, "none named, none taken");
    bench_free(&b);
    bench_defaults(&b);
    b.def.beta = 1e-3;
    bench_make(&b);
    bench_shake(&b, 3);
    bench_load(&b, 0);
    assert_true(b.load.damping < 0);
    bench_free(&b);
    bench_defaults(&b);
    b.def.damping_ratio = 0.05;
    bench_make(&b);
    bench_shake(&b, 3);
    bench_load(&b, 0);
    bodies_beam.energy(b.body, b.work, &b.layout, b.y, &e);
    check_close(b.load.damping / (2 * e.kinetic * 2 * 0.05 * bending_first(&b.body->bending->def)),
                -1, 1e-12, "2 zeta omega_1 v . M v");
    bench_free(&b);
}

/* Sum of |a_ij| |x_j| in row i. */
static double row_size(const struct band *a, int i, const double *x)
{
    double sum = 0;

    for (int j = 0; j < a->n; j++)
        sum += fabs(band_at(a, i, j) * x[j]);
    return sum;
}

/* Largest of z - gamma f_I(z) - r: of the rows of w, and, as forces (times M), of
 * those of v, each against the sum of the sizes of its terms.  Positions count with
 * their size in r: a long step leaves nearly nothing of them, by subtraction. */
static double residual(struct bench *b, double gamma, const double *r, const double *z)
{
    const struct bending *s = b->body->bending;
    double f[BENCH_Y] = {0}, q[BENCH_DOFS], v[BENCH_DOFS], d[BENCH_DOFS], g[BENCH_DOFS];
    double worst = 0;

    bodies_beam.implicit->stiff(b->body, b->work, &b->layout, 0, z, f);
    for (int i = 0; i < s->dofs; i++) {
        const long iq = bench_at(b, i, false), iv = bench_at(b, i, true);
        q[i] = fabs(z[iq]) + fabs(r[iq]);
        v[i] = z[iv];
        d[i] = z[iv] - gamma * f[iv] - r[iv];
        worst = fmax(worst, fabs(z[iq] - gamma * f[iq] - r[iq])
                                / (1e-300 + fabs(z[iq]) + fabs(gamma * f[iq])));
    }
    band_multiply(s->mass_free, d, g);
    for (int i = 0; i < s->dofs; i++)
        worst = fmax(worst, fabs(g[i]) / (1e-300 + row_size(s->mass_free, i, v)
                                          + fabs(gamma) * row_size(s->stiffness_free, i, q)));
    return worst;
}

static void check_solve(int option)
{
    static const double over_omega[] = { 0, 1e-3, 0.1, 1, 1e-3, 30, 1e3, 0.1, -0.02, 7, 1 };
    double r[BENCH_Y], z[BENCH_Y], again[BENCH_Y];
    struct bench b;

    bench_defaults(&b);
    bench_choose(&b, option);
    b.def.alpha = 1;
    b.def.beta = 1e-4;
    bench_make(&b);
    bench_shake(&b, 17);
    memcpy(r, b.y, sizeof r);
    for (size_t k = 0; k < sizeof over_omega / sizeof over_omega[0]; k++) {
        const double gamma = over_omega[k] / bending_first(&b.body->bending->def);
        for (int i = 0; i < BENCH_Y; i++)
            z[i] = again[i] = 123;
        assert_int_equal(bench_solve(&b, 0, gamma, r, z), STATUS_DONE);
        check_close(residual(&b, gamma, r, z), 0, 1e-13, "residual");
        check_close(z[0], 123, 0, "entries of others");
        assert_int_equal(bench_solve(&b, 0, gamma, r, again), STATUS_DONE);
        assert_memory_equal(z, again, sizeof z); /* kept factorization, same bits */
    }
    bench_free(&b);
}

static void solve_inverts_the_stiff_side(void **state)
{
    (void)state;
    for (int i = 0; i < BENCH_OPTIONS; i++)
        check_solve(i);
}

static void nothing_moves_without_loads(void **state)
{
    struct bench b;

    (void)state;
    bench_defaults(&b); /* upright: weight goes down the axis into the support */
    b.scales.g[1] = -9.81;
    bench_make(&b);
    bench_rates(&b, 0);
    for (int i = 0; i < b.size; i++)
        check_close(b.ydot[i], 0, 0, "rates");
    check_close(b.load.support[0], 0, 0, "support across");
    check_close(b.load.support[1], 2.4 * 9.81, 1e-12, "support along");
    bench_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(work_on_the_skin_is_work_on_the_beam),
        cmocka_unit_test(supports_close_the_momentum),
        cmocka_unit_test(support_of_a_cantilever_is_its_root),
        cmocka_unit_test(energy_changes_by_the_named_powers),
        cmocka_unit_test(potential_counts_from_the_low_corner),
        cmocka_unit_test(damping_only_takes),
        cmocka_unit_test(solve_inverts_the_stiff_side),
        cmocka_unit_test(nothing_moves_without_loads),
    };

    return cmocka_run_group_tests_name("beam-balance", tests, NULL, NULL);
}
