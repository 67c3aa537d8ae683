/* beam.c -- tests of src/bodies/beam: the kind of body as the plan sees it. */
#include "beam.h"

static void parameters_have_units_ranges_and_sentences(void **state)
{
    (void)state;
    assert_ptr_equal(bodies_table[0], &bodies_beam);
    for (const struct param *r = bodies_beam.params; r->key; r++) {
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
    const double scale[] = { 0.01, 0.01 / 0.025, 2, 2 / 0.025 };
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

    (void)state;
    bench_defaults(&b);
    b.def.length = 0.203; /* 20 rows, fitted */
    b.def.angle = 0;
    bench_make(&b);
    assert_int_equal(b.skin, 20 * 3);
    assert_int_equal(bodies_beam.skin(b.body, x), 60);
    for (int i = 0; i < 60; i++)
        for (int d = 0; d < DIM; d++)
            mean[d] += x[i][d] / 60;
    check_close(mean[0], 0.3 + 0.203 / 2, 1e-14, "middle along");
    check_close(mean[1], 0.1, 1e-14, "middle across");
    check_close(x[0][0], 0.3 + 0.203 / 40, 1e-15, "first row at half a spacing");
    check_close(x[0][1], 0.09, 1e-15, "first layer");
    check_close(x[3][0] - x[0][0], 0.203 / 20, 1e-15, "rows are evenly spaced");
    assert_int_equal(bodies_beam.skin_kind(b.body), KIND_SKIN);
    bench_free(&b);
    bench_defaults(&b);
    b.def.layers = 4;
    b.def.slip = true;
    bench_make(&b);
    assert_int_equal(b.skin, 20 * 4);
    assert_int_equal(bodies_beam.skin_kind(b.body), KIND_SKIN_SLIP);
    bench_free(&b);
    bench_defaults(&b); /* support 2.5 dx needs three layers too */
    b.scales.support = 0.025;
    bench_make(&b);
    assert_int_equal(b.skin, 20 * 3);
    bench_free(&b);
}

/* A straight beam's skin stands at rest; sum of force . u is v . N^T force. */
static void work_on_the_skin_is_work_on_the_beam(void **state)
{
    double x[BENCH_SKIN][DIM], u[BENCH_SKIN][DIM], rest[BENCH_SKIN][DIM], none[BENCH_Y] = {0};
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.angle = 37;
    bench_make(&b);
    bodies_beam.skin(b.body, rest);
    bodies_beam.move(b.body, &b.layout, 0, b.y, x, u);
    assert_memory_equal(x, rest, b.skin * sizeof x[0]);
    for (unsigned seed = 1; seed < 5; seed++) {
        double work = 0, size = 0, given = 0, v[BENCH_DOFS], a[BENCH_DOFS], p[BENCH_DOFS];
        bench_shake(&b, seed);
        bodies_beam.move(b.body, &b.layout, 0, b.y, x, u);
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
    bodies_beam.move(b.body, &b.layout, 0, b.y, x, u);
    for (int i = 0; i < bench_dofs(&b); i++)
        b.y[bench_at(&b, i, false)] += h * b.y[bench_at(&b, i, true)];
    bodies_beam.move(b.body, &b.layout, h, b.y, later, w);
    for (int i = 0; i < b.skin; i++)
        for (int d = 0; d < DIM; d++)
            check_close((later[i][d] - x[i][d]) / h, u[i][d], 1e-12, "u = dx/dt");
    bench_free(&b);
}

/* d(momentum)/dt = forces of the water + weight + prescribed loads + supports. */
static void check_momentum(const char *root, const char *tip, double angle)
{
    double rate[DIM] = {0}, given[DIM], moving[BENCH_Y];
    struct bench b;

    bench_defaults(&b);
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
    bodies_beam.momentum(b.body, &b.layout, moving, rate);
    for (int d = 0; d < DIM; d++) {
        const double across = d == 0 ? -sin(angle * M_PI / 180) : cos(angle * M_PI / 180);
        given[d] = b.load.support[d] + bodies_beam.weight(b.body) * b.scales.g[d]
                 + (b.def.load * b.def.length + b.def.tip_force) * across;
        for (int i = 0; i < b.skin; i++)
            given[d] += b.force[i][d];
        check_close(given[d], rate[d], 1e-9 * (1 + fabs(b.load.support[d])), "dP/dt");
    }
    check_close(bodies_beam.weight(b.body), 1200 * 0.01 * 0.2, 1e-14, "mass");
    bench_free(&b);
}

static void supports_close_the_momentum(void **state)
{
    (void)state;
    check_momentum("clamped", "free", 90);
    check_momentum("clamped", "clamped", 37);
    check_momentum("free", "pinned", 0);
    check_momentum("pinned", "free", -110);
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

static double energy_at(const struct bench *b, const double *y)
{
    struct energies e = {0};

    bodies_beam.energy(b->body, &b->layout, y, &e);
    return e.kinetic + e.potential + e.internal + e.elastic;
}

/* dE/dt = damping + prescribed loads + water; E is quadratic, so that a central
 * difference along ydot is exact. */
static void energy_changes_by_the_named_powers(void **state)
{
    double x[BENCH_SKIN][DIM], u[BENCH_SKIN][DIM], up[BENCH_Y], down[BENCH_Y];
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.angle = 60;
    b.def.load = 11;
    b.def.tip_force = -2;
    b.def.alpha = 3;
    b.def.beta = 1e-5;
    b.scales.g[0] = 2;
    b.scales.g[1] = -9.81;
    bench_make(&b);
    for (unsigned seed = 1; seed < 5; seed++) {
        const double h = 1e-6;
        double power = 0;
        bench_shake(&b, seed);
        bench_rates(&b, 0);
        bodies_beam.move(b.body, &b.layout, 0, b.y, x, u);
        for (int i = 0; i < b.skin; i++)
            for (int d = 0; d < DIM; d++)
                power += b.force[i][d] * u[i][d];
        for (int i = 0; i < b.size; i++) {
            up[i] = b.y[i] + h * b.ydot[i];
            down[i] = b.y[i] - h * b.ydot[i];
        }
        power += b.load.damping + b.load.driven;
        check_close((energy_at(&b, up) - energy_at(&b, down)) / (2 * h) / power, 1, 1e-7, "dE/dt");
    }
    bench_free(&b);
}

static void potential_counts_from_the_low_corner(void **state)
{
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.scales.g[1] = -10;
    b.scales.low[1] = -0.5;
    bench_make(&b); /* upright, its middle 0.2 above 0 */
    check_close(energy_at(&b, b.y), 2.4 * 10 * 0.7, 1e-12, "potential at rest");
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
    bodies_beam.energy(b.body, &b.layout, b.y, &e);
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
 * those of v, each against the sum of the sizes of its terms. */
static double residual(struct bench *b, double gamma, const double *r, const double *z)
{
    const struct bending *s = b->body->bending;
    double f[BENCH_Y] = {0}, q[BENCH_DOFS], v[BENCH_DOFS], d[BENCH_DOFS], g[BENCH_DOFS];
    double worst = 0;

    bodies_beam.stiff(b->body, &b->layout, 0, z, f);
    for (int i = 0; i < s->dofs; i++) {
        const long iq = bench_at(b, i, false), iv = bench_at(b, i, true);
        q[i] = z[iq];
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

static void solve_inverts_the_stiff_side(void **state)
{
    static const double over_omega[] = { 0, 1e-3, 0.1, 1, 1e-3, 30, 1e3, 0.1, -0.02, 7, 1 };
    double r[BENCH_Y], z[BENCH_Y], again[BENCH_Y];
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.alpha = 1;
    b.def.beta = 1e-4;
    bench_make(&b);
    bench_shake(&b, 17);
    memcpy(r, b.y, sizeof r);
    for (size_t k = 0; k < sizeof over_omega / sizeof over_omega[0]; k++) {
        const double gamma = over_omega[k] / bending_first(&b.body->bending->def);
        for (int i = 0; i < BENCH_Y; i++)
            z[i] = again[i] = 123;
        assert_int_equal(bodies_beam.solve(b.body, &b.layout, 0, gamma, r, z), STATUS_DONE);
        check_close(residual(&b, gamma, r, z), 0, 1e-13, "residual");
        check_close(z[0], 123, 0, "entries of others");
        assert_int_equal(bodies_beam.solve(b.body, &b.layout, 0, gamma, r, again), STATUS_DONE);
        assert_memory_equal(z, again, sizeof z); /* kept factorization, same bits */
    }
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
    bodies_beam.stiff(b.body, &b.layout, 0, b.y, b.ydot);
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
            b.y[bench_at(&b, held[c][k], true)] = 1; /* even if somebody wrote there */
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

/* F L^3/(3 EI), root force F and moment F L, for 1 to 100 elements. */
static void tip_force_bends_as_theory_says(void **state)
{
    (void)state;
    for (int n = 1; n <= 100; n++) {
        const double EI = 2e6 * 1e-6 / 12, F = 0.3, L = 0.2;
        struct body_view view;
        struct bench b;
        bench_defaults(&b);
        b.def.elements = n;
        b.def.tip_force = F;
        bench_make(&b);
        bench_settle(&b, 0);
        bench_show(&b, 0, &view);
        check_close(view.tip[0] / (-F * L * L * L / (3 * EI)), 1, 1e-8, "F L^3/(3 EI)");
        check_close(view.mid[0] / (-F * L * L * L * 5 / (48 * EI)), 1, 1e-8, "5 F L^3/(48 EI)");
        check_close(view.tip_angle / (F * L * L / (2 * EI)), 1, 1e-8, "F L^2/(2 EI)");
        check_close(view.root_force / F, 1, 1e-6, "root force");
        check_close(view.root_moment / (F * L), 1, 1e-6, "root moment");
        bench_free(&b);
    }
}

/* q L^4/(8 EI) lying down, by weight and, for the catalogue's A08c, by a load;
 * a plate between clamped ends q L^4/(384 D). */
static void uniform_loads_bend_as_theory_says(void **state)
{
    struct body_view view;
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.angle = 0;
    b.scales.g[1] = -9.81;
    bench_make(&b);
    bench_settle(&b, 0);
    bench_show(&b, 0, &view);
    check_close(view.tip[1] / (-1200 * 0.01 * 9.81 * pow(0.2, 4) / (8 * 2e6 * 1e-6 / 12)), 1, 1e-8,
                "own weight");
    check_close(view.root_force / (-2.4 * 9.81), 1, 1e-6, "the root carries the weight");
    check_close(view.root_moment / (-2.4 * 9.81 * 0.1), 1, 1e-6, "and its moment");
    bench_free(&b);

    bench_defaults(&b);
    b.def.length = 0.079;
    b.def.thickness = 0.005;
    b.def.E = 12e6;
    b.def.nu = 0.4;
    b.def.plane = "strain";
    b.def.load = 686.7;
    bench_make(&b);
    bench_settle(&b, 0);
    bench_show(&b, 0, &view);
    check_close(-view.tip[0], 0.022467497, 1e-8, "A08c, antoci_gate");
    bench_free(&b);

    bench_defaults(&b);
    b.def.root = b.def.tip = "clamped";
    b.def.load = 100;
    bench_make(&b);
    bench_settle(&b, 0);
    bench_show(&b, 0, &view);
    check_close(-view.mid[0] / (100 * pow(0.2, 4) / (384 * 2e6 * 1e-6 / 12)), 1, 1e-8,
                "both ends clamped");
    bench_free(&b);
}

static void pinned_root_feels_no_moment(void **state)
{
    struct body_view view;
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.root = b.def.tip = "pinned";
    b.def.load = 100;
    bench_make(&b);
    bench_settle(&b, 0);
    bench_show(&b, 0, &view);
    check_close(view.root_moment, 0, 0, "moment");
    check_close(view.root_force / 10, 1, 1e-6, "half the load");
    check_close(-view.mid[0] / (5 * 100 * pow(0.2, 4) / (384 * 2e6 * 1e-6 / 12)), 1, 1e-8, "mid");
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

/* Shape of the first mode of a cantilever and its slope, at x from 0 to 1. */
static void first_mode(double x, double *w, double *slope)
{
    const double k = 1.875104068711961, r = 0.7340955137589128; /* (cosh + cos)/(sinh + sin) ^-1 */

    *w = cosh(k * x) - cos(k * x) - r * (sinh(k * x) - sin(k * x));
    *slope = k * (sinh(k * x) + sin(k * x) - r * (cosh(k * x) - cos(k * x)));
}

/* Swings by the implicit midpoint rule through solve(); returns the time of the
 * first passage through rest, a quarter of the period. */
static double quarter_period(struct bench *b, double h)
{
    const double before = energy_at(b, b->y);
    double t = 0, last = b->y[bench_at(b, bench_dofs(b) - 2, false)];

    for (;;) {
        double middle[BENCH_Y] = {0};
        assert_int_equal(bodies_beam.solve(b->body, &b->layout, t, h / 2, b->y, middle), 0);
        for (int i = 0; i < bench_dofs(b); i++)
            for (int rate = 0; rate < 2; rate++) {
                const long at = bench_at(b, i, rate);
                b->y[at] = 2 * middle[at] - b->y[at];
            }
        const double tip = b->y[bench_at(b, bench_dofs(b) - 2, false)];
        check_close(energy_at(b, b->y) / before, 1, 1e-9, "midpoint rule keeps energy");
        if (tip <= 0 || t > 10)
            return t + h * last / (last - tip);
        last = tip;
        t += h;
    }
}

/* Gray's plate, A08b: period in plane strain within the catalogue's 0.5 %. */
static void free_plate_swings_with_the_published_period(void **state)
{
    static const double plate[][2] = { { 0.22, 0.27006105 }, { 0.3975, 0.25403243 } };
    struct bench b;

    (void)state;
    for (int k = 0; k < 2; k++) {
        bench_defaults(&b);
        b.def.length = 0.2;
        b.def.thickness = 0.02;
        b.def.E = 2e6;
        b.def.density = 1000;
        b.def.nu = plate[k][0];
        b.def.plane = "strain";
        b.def.elements = 10;
        bench_make(&b);
        for (int i = 0; i <= 10; i++) {
            double w, slope;
            first_mode(i / 10.0, &w, &slope);
            b.y[bench_at(&b, 2 * i, false)] = 0.001 * w;
            b.y[bench_at(&b, 2 * i + 1, false)] = 0.001 * slope / 0.2;
        }
        check_close(4 * quarter_period(&b, 1e-4) / plate[k][1], 1, 1e-3, "period");
        bench_free(&b);
    }
}

static void limit_names_the_beam(void **state)
{
    struct limit limit;
    struct bench b;

    (void)state;
    bench_defaults(&b);
    bench_make(&b);
    bodies_beam.limit(b.body, &limit);
    check_close(limit.rate, b.body->bending->fastest, 0, "rate");
    assert_false(limit.decay);
    assert_int_equal(limit.where, 7);
    assert_string_equal(limit.part, "beam.it");
    bench_free(&b);
    bench_defaults(&b); /* D so large that the fastest mode only creeps: beta omega^2 */
    b.def.beta = 1;
    bench_make(&b);
    bodies_beam.limit(b.body, &limit);
    assert_true(limit.decay);
    check_close(limit.rate / pow(b.body->bending->fastest, 2), 1, 1e-6, "rate of decay");
    bench_free(&b);
}

static void check_refusal(const struct bench *b, const char *word)
{
    struct body *body = NULL;

    status_clear();
    assert_int_equal(bodies_beam.create(&b->def, &b->scales, "it", "beam.it", &body),
                     STATUS_BAD_SCENE);
    assert_null(body);
    if (!strstr(status_message(), "beam.it") || !strstr(status_message(), word))
        fail_msg("\"%s\" does not name beam.it and %s", status_message(), word);
    status_clear();
}

static void refuses_what_cannot_stand(void **state)
{
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.root = b.def.tip = "free";
    check_refusal(&b, "both free");
    bench_defaults(&b);
    b.def.root = b.def.tip = "clamped";
    b.def.elements = 1;
    check_refusal(&b, "elements");
    bench_defaults(&b);
    b.def.mass = 2;
    check_refusal(&b, "both density");
    b.def.mass = b.def.density = 0;
    check_refusal(&b, "neither density nor mass");
    bench_defaults(&b);
    b.def.tip = "pinned";
    b.def.tip_force = 1;
    check_refusal(&b, "tip_force");
    bench_defaults(&b);
    b.def.thickness = 0.3;
    check_refusal(&b, "thickness");
    bench_defaults(&b);
    b.def.load_until = 1;
    check_refusal(&b, "load_until");
}

/* The mass of the seed: 0.165 kg, EI 2.667 N m: omega_1 = 624.7 rad/s. */
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parameters_have_units_ranges_and_sentences),
        cmocka_unit_test(four_rows_with_their_scales),
        cmocka_unit_test(skin_is_centred_on_the_axis),
        cmocka_unit_test(work_on_the_skin_is_work_on_the_beam),
        cmocka_unit_test(skin_velocity_is_the_rate_of_its_position),
        cmocka_unit_test(supports_close_the_momentum),
        cmocka_unit_test(support_of_a_cantilever_is_its_root),
        cmocka_unit_test(energy_changes_by_the_named_powers),
        cmocka_unit_test(potential_counts_from_the_low_corner),
        cmocka_unit_test(damping_only_takes),
        cmocka_unit_test(solve_inverts_the_stiff_side),
        cmocka_unit_test(stiff_adds_and_load_sets),
        cmocka_unit_test(held_degrees_of_freedom_never_move),
        cmocka_unit_test(direction_does_not_matter),
        cmocka_unit_test(nothing_moves_without_loads),
        cmocka_unit_test(tip_force_bends_as_theory_says),
        cmocka_unit_test(uniform_loads_bend_as_theory_says),
        cmocka_unit_test(pinned_root_feels_no_moment),
        cmocka_unit_test(loads_end_when_told),
        cmocka_unit_test(free_plate_swings_with_the_published_period),
        cmocka_unit_test(limit_names_the_beam),
        cmocka_unit_test(refuses_what_cannot_stand),
        cmocka_unit_test(mass_may_be_given_instead_of_density),
    };

    return cmocka_run_group_tests_name("beam", tests, NULL, NULL);
}
