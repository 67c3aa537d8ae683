/* elastica.c -- tests of src/bodies/elastica and its element: energy, force and tangent
 * agree, turns strain nothing, small deflections are those of the linear beam. */
#include "bodies/elastica.h"
#include "bending.h"
#include "defaults.h"

#include <string.h>

enum { MOST = 4 * 22 };

static struct elastica_def plain(int elements)
{
    return (struct elastica_def){
        .bending = { .elements = elements, .length = 0.5, .EI = 0.02, .mu = 1.3,
                     .root = BENDING_CLAMPED, .tip = BENDING_FREE },
        .EA = 300, .thickness = 0.03, .speed = 1, .path = "beam.it" };
}

static struct elastica *made(struct elastica_def def, struct elastica_work **work)
{
    struct elastica *e = NULL;

    assert_int_equal(elastica_create(&def, &e), STATUS_DONE);
    assert_int_equal(elastica_work_create(e, work), STATUS_DONE);
    assert_true(e->dofs <= MOST);
    return e;
}

static void end(struct elastica **e, struct elastica_work **work)
{
    elastica_work_free(work);
    elastica_free(e);
}

/* Bent to an arc whose tip has turned by `turn`, with some noise; held ones stay. */
static void bend_to(const struct elastica *e, double turn, double rough, double *q)
{
    unsigned seed = 7;

    for (int i = 0; i < e->dofs; i += ELASTICA_NODE) {
        const double s = i / ELASTICA_NODE * e->l, L = e->def.bending.length;
        const double x = turn * s / L, R = L / turn;
        q[i] = R * sin(x) - s + rough * e->l * noise(&seed);
        q[i + 1] = R * (1 - cos(x)) + rough * e->l * noise(&seed);
        q[i + 2] = cos(x) - 1 + rough * noise(&seed);
        q[i + 3] = sin(x) + rough * noise(&seed);
    }
    for (int i = 0; i < e->dofs; i++)
        if (elastica_held(e, i))
            q[i] = 0;
}

static void force_is_the_gradient_of_the_energy(void **state)
{
    double q[MOST], f[MOST], none[MOST] = {0};
    struct elastica_work *w;
    struct elastica *e = made(plain(5), &w);

    (void)state;
    bend_to(e, 4, 0.2, q);
    elastica_resist(e, w, q, none, f);
    for (int i = 0; i < e->dofs; i++) {
        const double at = q[i], h = 1e-5;
        q[i] = at + h;
        const double up = elastica_elastic(e, q);
        q[i] = at - h;
        const double down = elastica_elastic(e, q);
        q[i] = at;
        check_close((up - down) / (2 * h), f[i], 1e-5, "dE/dq");
    }
    end(&e, &w);
}

static void tangent_is_the_gradient_of_the_force(void **state)
{
    double q[MOST], up[MOST], down[MOST], none[MOST] = {0};
    struct elastica_work *w;
    struct elastica *e = made(plain(5), &w);

    (void)state;
    bend_to(e, 4, 0.2, q);
    elastica_tangent(e, w, q);
    for (int i = 0; i < e->dofs; i++) {
        const double at = q[i], h = 1e-6;
        q[i] = at + h;
        elastica_resist(e, w, q, none, up);
        q[i] = at - h;
        elastica_resist(e, w, q, none, down);
        q[i] = at;
        for (int j = 0; j < e->dofs; j++)
            check_close((up[j] - down[j]) / (2 * h), band_at(w->tangent, i, j), 1e-4, "d2E/dq2");
    }
    end(&e, &w);
}

/* Whatever the position: turned, shifted, nothing pulls. */
static void turns_strain_nothing(void **state)
{
    struct elastica_def def = plain(5);
    double q[MOST], f[MOST], none[MOST] = {0};

    (void)state;
    def.bending.root = BENDING_FREE;
    def.bending.tip = BENDING_PINNED;
    for (double turn = -6; turn <= 6; turn += 0.5) {
        struct elastica_work *w;
        struct elastica *e = made(def, &w);
        for (int i = 0; i < e->dofs; i += ELASTICA_NODE) {
            const double s = i / ELASTICA_NODE * e->l;
            q[i] = s * (cos(turn) - 1) + 3;
            q[i + 1] = s * sin(turn) - 2;
            q[i + 2] = cos(turn) - 1;
            q[i + 3] = sin(turn);
        }
        elastica_resist(e, w, q, none, f);
        for (int i = 0; i < e->dofs; i++)
            check_close(f[i], 0, 1e-11, "force");
        check_close(elastica_elastic(e, q), 0, 1e-24, "energy");
        end(&e, &w);
    }
}

/* A beam rolled up to `turn` holds EI turn^2/(2 L), a stretched one EA/4 (a^2 - 1 - ln a^2). */
static void energy_is_that_of_bending_and_stretching(void **state)
{
    struct elastica_def def = plain(20);
    double q[MOST];

    (void)state;
    for (double turn = 0.5; turn < 7; turn += 1.5) {
        struct elastica_work *w;
        struct elastica *e = made(def, &w);
        bend_to(e, turn, 0, q);
        check_close(elastica_elastic(e, q) / (0.02 * turn * turn / 2 / 0.5), 1, 2e-5 * turn * turn,
                    "energy of an arc");
        end(&e, &w);
    }
    struct elastica_work *w;
    struct elastica *e = made(def, &w);
    memset(q, 0, sizeof q);
    for (int i = 0; i < e->dofs; i += ELASTICA_NODE) {
        q[i] = 0.1 * i / ELASTICA_NODE * e->l;
        q[i + 2] = 0.1;
    }
    check_close(elastica_elastic(e, q), 300 / 4.0 * (0.21 - log(1.21)) * 0.5, 1e-12,
                "energy of stretch");
    end(&e, &w);
}

/* Across, the tangent at rest is the linear beam's stiffness, and nothing couples. */
static void straight_it_is_the_linear_beam(void **state)
{
    const double none[MOST] = {0};
    struct elastica_work *w;
    struct elastica *e = made(plain(6), &w);

    (void)state;
    elastica_tangent(e, w, none);
    for (int i = 0; i < e->dofs / 2; i++)
        for (int j = 0; j < e->dofs / 2; j++) {
            check_close(band_at(w->tangent, 2 * i + 1, 2 * j + 1),
                        band_at(e->plane->stiffness, i, j), 1e-9, "stiffness across");
            check_close(band_at(e->mass, 2 * i + 1, 2 * j + 1),
                        band_at(e->plane->mass, i, j), 0, "mass across");
            check_close(band_at(w->tangent, 2 * i, 2 * j + 1), 0, 0, "along and across");
        }
    end(&e, &w);
}

/* Largest eigenvalue of the tangent at rest against the mass: under the limit, not far. */
static void check_fastest(struct elastica_def def)
{
    const double none[MOST] = {0};
    struct elastica_work *w;
    struct elastica *e = made(def, &w);
    double low = 0, high = 2;

    elastica_tangent(e, w, none);
    while (high - low > 1e-4) {
        const double part = (low + high) / 2;
        band_sum(w->sum, pow(part * e->fastest, 2), e->mass, -1, w->tangent);
        for (int i = 0; i < e->dofs; i++)
            if (elastica_held(e, i))
                band_hold(w->sum, i, 1);
        *(band_factor_definite(w->factor, w->sum) ? &high : &low) = part;
    }
    if (!(high <= 1.001 && high >= 0.97))
        fail_msg("EA %g: the largest frequency is %g of the limit", def.EA, high);
    end(&e, &w);
}

static void no_frequency_exceeds_the_limit(void **state)
{
    static const enum bending_inertia all[] = { BENDING_CONSISTENT, BENDING_LUMPED,
                                                BENDING_LUMPED_ENDS };

    (void)state;
    for (int i = 0; i < 3; i++)
        for (double EA = 3; EA < 1e6; EA *= 10) {
            struct elastica_def def = plain(7);
            def.EA = EA;
            def.bending.inertia = all[i];
            check_fastest(def);
        }
}

/* Residual of z - gamma f_I(z) = r, times M, over the size of its terms. */
static double residual(const struct elastica *e, struct elastica_work *w, double gamma,
                       const double *rq, const double *rv, const double *q, const double *v)
{
    double f[MOST], off[MOST], push[MOST], worst = 0, size = 1e-300;

    elastica_resist(e, w, q, v, f);
    for (int i = 0; i < e->dofs; i++)
        off[i] = v[i] - rv[i];
    band_multiply(e->mass, off, push);
    for (int i = 0; i < e->dofs; i++) {
        size = fmax(size, fabs(push[i]));
        if (elastica_held(e, i))
            continue;
        worst = fmax(worst, fabs(push[i] + gamma * f[i]));
        check_close(q[i], rq[i] + gamma * v[i], 1e-15, "z_q = r_q + gamma z_v");
    }
    return worst / size;
}

/* From a guess at rest, with damping, pressed and pulled, from short to long steps. */
static void solve_inverts_the_stiff_side(void **state)
{
    static const double over_omega[] = { 1e-4, 0.01, 0.1, 0.5, -0.02, 0 };
    struct elastica_def def = plain(10);

    (void)state;
    def.bending.alpha = 2;
    def.bending.drag = 0.01;
    def.bending.beta = 0.05 / bending_first(&def.bending);
    struct elastica_work *w;
    struct elastica *e = made(def, &w);
    for (int k = 0; k < 6; k++) {
        const double gamma = over_omega[k] / bending_first(&def.bending);
        double rq[MOST], rv[MOST] = {0}, q[MOST], v[MOST];
        unsigned seed = 3;
        bend_to(e, 2.5, 0.01, rq);
        memcpy(q, rq, sizeof q);
        for (int i = 0; i < e->dofs; i++)
            rv[i] = elastica_held(e, i) ? 0 : 0.3 * noise(&seed);
        if (elastica_solve(e, w, gamma, rq, rv, q, v) != STATUS_DONE)
            fail_msg("gamma %g: %s", gamma, status_message());
        check_close(residual(e, w, gamma, rq, rv, q, v), 0, 1e-10, "residual");
    }
    end(&e, &w);
}

/* Static balance under a load that turns the tip by half a radian, from a straight beam:
 * each step is as long as the square of the one before, times what does not grow. */
static void newtons_method_is_quadratic(void **state)
{
    double q[MOST] = {0}, f[MOST], none[MOST] = {0}, size[12], worst = 0;
    struct elastica_work *w;
    struct elastica *e = made(plain(10), &w);
    int n = 0;

    (void)state;
    do {
        assert_true(n < 12);
        elastica_resist(e, w, q, none, f);
        for (int i = 0; i < e->dofs; i++)
            f[i] = elastica_held(e, i) ? 0 : -f[i];
        f[e->dofs - 3] += 0.08;
        elastica_tangent(e, w, q);
        band_sum(w->sum, 1, w->tangent, 0, e->mass);
        for (int i = 0; i < e->dofs; i++)
            if (elastica_held(e, i))
                band_hold(w->sum, i, 1);
        assert_int_equal(band_factor_set(w->factor, w->sum), STATUS_DONE);
        band_factor_solve(w->factor, f);
        size[n] = 0;
        for (int i = 0; i < e->dofs; i++) {
            q[i] += f[i];
            size[n] = fmax(size[n], fabs(f[i]));
        }
    } while (size[n++] > 1e-10);
    for (int i = n - 3; i < n; i++)
        worst = fmax(worst, size[i] / (size[i - 1] * size[i - 1]));
    check_close(atan2(q[e->dofs - 1], 1 + q[e->dofs - 2]), 0.45, 0.1, "turn of the tip");
    if (!(worst < 300))
        fail_msg("%d steps, the last %g %g %g %g", n, size[n - 4], size[n - 3], size[n - 2],
                 size[n - 1]);
    end(&e, &w);
}

/* Neither scales that rounding cannot meet nor a NaN take for ever. */
static void a_solve_that_finds_nothing_says_so(void **state)
{
    struct elastica_def def = plain(10);
    double rq[MOST], rv[MOST], q[MOST] = {0}, v[MOST];
    unsigned seed = 5;

    (void)state;
    def.thickness = def.speed = 1e-100;
    struct elastica_work *w;
    struct elastica *e = made(def, &w);
    bend_to(e, 1, 0.01, rq);
    for (int i = 0; i < e->dofs; i++)
        rv[i] = noise(&seed);
    status_clear();
    assert_int_equal(elastica_solve(e, w, 1e-2, rq, rv, q, v), STATUS_FAILED);
    assert_non_null(strstr(status_message(), "beam.it"));
    status_clear();
    rv[9] = NAN;
    assert_int_equal(elastica_solve(e, w, 1e-2, rq, rv, q, v), STATUS_FAILED);
    status_clear();
    end(&e, &w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(force_is_the_gradient_of_the_energy),
        cmocka_unit_test(tangent_is_the_gradient_of_the_force),
        cmocka_unit_test(turns_strain_nothing),
        cmocka_unit_test(energy_is_that_of_bending_and_stretching),
        cmocka_unit_test(straight_it_is_the_linear_beam),
        cmocka_unit_test(no_frequency_exceeds_the_limit),
        cmocka_unit_test(solve_inverts_the_stiff_side),
        cmocka_unit_test(newtons_method_is_quadratic),
        cmocka_unit_test(a_solve_that_finds_nothing_says_so),
    };

    return cmocka_run_group_tests_name("elastica", tests, NULL, NULL);
}
