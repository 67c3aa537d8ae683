/* elastica-friction.c -- tests of damping by the rate at which a beam bends: it takes what its
 * power says, nothing from a beam that spins, and from small vibrations what its ratio says. */
#include "bodies/elastica-friction.h"
#include "bending.h"
#include "bodies/elastica.h"
#include "defaults.h"

#include <string.h>

enum { ELEMENTS = 10, MOST = 4 * (ELEMENTS + 1) };

static const double gauss[2] = { 0.21132486540518713, 0.78867513459481287 };

/* Damped as the first mode of a cantilever wants it, however this one is held. */
static struct elastica_def plain(enum bending_end root, double ratio)
{
    struct elastica_def def = {
        .bending = { .elements = ELEMENTS, .length = 0.5, .EI = 0.02, .mu = 1.3,
                     .root = BENDING_CLAMPED, .tip = BENDING_FREE },
        .EA = 300, .thickness = 0.03, .speed = 1, .path = "beam.it" };

    def.bending.beta = 2 * ratio / bending_first(&def.bending);
    def.bending.root = root;
    return def;
}

static struct elastica *made(struct elastica_def def, struct elastica_work **work)
{
    struct elastica *e = NULL;

    assert_int_equal(elastica_create(&def, &e), STATUS_DONE);
    assert_int_equal(elastica_work_create(e, work), STATUS_DONE);
    return e;
}

static void end(struct elastica **e, struct elastica_work **work)
{
    elastica_work_free(work);
    elastica_free(e);
}

/* An arc whose tip has turned by `bent`, turned by `angle` as a whole, with some noise. */
static void bend_to(const struct elastica *e, double bent, double angle, double rough, double *q)
{
    unsigned seed = 7;

    for (int i = 0; i < e->dofs; i += ELASTICA_NODE) {
        const double s = i / ELASTICA_NODE * e->l, R = e->def.bending.length / bent;
        const double x = s / R + angle;
        q[i] = R * (sin(x) - sin(angle)) - s + rough * e->l * noise(&seed);
        q[i + 1] = R * (cos(angle) - cos(x)) + rough * e->l * noise(&seed);
        q[i + 2] = cos(x) - 1 + rough * noise(&seed);
        q[i + 3] = sin(x) + rough * noise(&seed);
    }
}

/* kappa at part xi of an element, written plainly: cubics of Hermite and (BE4). */
static double kappa(double l, double xi, const double *q)
{
    double a[2], b[2];

    for (int c = 0; c < 2; c++) {
        const double from = q[c], to = (c == 0) * l + q[4 + c];
        const double m = l * ((c == 0) + q[2 + c]), n = l * ((c == 0) + q[6 + c]);
        a[c] = (6 * xi * (1 - xi) * (to - from) + (1 - xi) * (1 - 3 * xi) * m
                + xi * (3 * xi - 2) * n) / l;
        b[c] = ((6 - 12 * xi) * (to - from) + (6 * xi - 4) * m + (6 * xi - 2) * n) / (l * l);
    }
    return (a[0] * b[1] - a[1] * b[0]) / (a[0] * a[0] + a[1] * a[1]);
}

/* power = -beta EI int (dkappa/dt)^2 ds, the rate by central differences. */
static double power_by_hand(const struct elastica *e, const double *q, const double *v)
{
    const double h = 1e-6;
    double sum = 0, up[8], down[8];

    for (int n = 0; n < ELEMENTS; n++)
        for (int p = 0; p < 2; p++) {
            for (int i = 0; i < 8; i++) {
                up[i] = q[4 * n + i] + h * v[4 * n + i];
                down[i] = q[4 * n + i] - h * v[4 * n + i];
            }
            const double rate = (kappa(e->l, gauss[p], up) - kappa(e->l, gauss[p], down)) / (2 * h);
            sum -= e->def.bending.beta * e->def.bending.EI * e->l / 2 * rate * rate;
        }
    return sum;
}

static void power_is_that_of_the_moment(void **state)
{
    struct elastica_work *w;
    struct elastica *e = made(plain(BENDING_FREE, 0.3), &w);
    double q[MOST], v[MOST], none[MOST] = {0}, f[MOST], bend[MOST], work = 0;
    unsigned seed = 3;

    (void)state;
    bend_to(e, 3, 0.4, 0.1, q);
    for (int i = 0; i < e->dofs; i++)
        v[i] = 0.2 * noise(&seed);
    elastica_resist(e, w, q, v, f);
    elastica_resist(e, w, q, none, bend);
    for (int i = 0; i < e->dofs; i++)
        work -= v[i] * (f[i] - bend[i]);
    const double power = elastica_damping(e, q, v);
    assert_true(power < -1e-3);
    check_close(work / power, 1, 1e-12, "work of its forces");
    check_close(power_by_hand(e, q, v) / power, 1, 1e-7, "beta EI int (dkappa/dt)^2 ds");
    end(&e, &w);
}

/* gamma d(force)/dv at q = r + gamma v, by central differences, element by element. */
static void tangent_is_the_gradient_of_the_force(void **state)
{
    struct elastica_work *w;
    struct elastica *e = made(plain(BENDING_FREE, 0.3), &w);
    const double gamma = 0.3, h = 1e-5, beta = e->def.bending.beta;
    double q[MOST], v[8], k[8][8] = { { 0 } }, skew = 0, most = 0;
    unsigned seed = 9;

    (void)state;
    bend_to(e, 3, 0.4, 0.1, q);
    for (int i = 0; i < 8; i++)
        v[i] = noise(&seed);
    elastica_friction_tangent(&e->element, beta, gamma, q, v, k);
    for (int i = 0; i < 8; i++)
        for (int j = 0; j < 8; j++) {
            most = fmax(most, fabs(k[i][j]));
            skew = fmax(skew, fabs(k[i][j] - k[j][i]));
        }
    assert_true(skew > 0.01 * most); /* else this tests no half that is skew */
    for (int j = 0; j < 8; j++) {
        double at[2][8], rate[2][8], f[2][8] = { { 0 } };
        for (int s = 0; s < 2; s++) {
            memcpy(at[s], q, sizeof at[s]);
            memcpy(rate[s], v, sizeof rate[s]);
            at[s][j] += (s ? -h : h) * gamma;
            rate[s][j] += s ? -h : h;
            elastica_friction_force(&e->element, beta, at[s], rate[s], f[s]);
        }
        for (int i = 0; i < 8; i++)
            check_close(gamma * (f[0][i] - f[1][i]) / (2 * h), k[i][j], 1e-6 * most, "tangent");
    }
    end(&e, &w);
}

/* A bent beam that turns and moves as a whole feels nothing of it. */
static void a_turn_as_a_whole_is_free(void **state)
{
    struct elastica_work *w;
    struct elastica *e = made(plain(BENDING_FREE, 1), &w);
    double q[MOST], v[MOST], none[MOST] = {0}, f[MOST], bend[MOST];

    (void)state;
    for (int turn = 0; turn < 7; turn++) {
        bend_to(e, 2, 0.9 * turn, 0.05, q);
        for (int i = 0; i < e->dofs; i += ELASTICA_NODE) {
            const double x = i / ELASTICA_NODE * e->l + q[i];
            v[i] = 3 - 20 * q[i + 1];
            v[i + 1] = 1 + 20 * x;
            v[i + 2] = -20 * q[i + 3];
            v[i + 3] = 20 * (1 + q[i + 2]);
        }
        check_close(elastica_damping(e, q, v), 0, 1e-20, "power");
        elastica_resist(e, w, q, v, f);
        elastica_resist(e, w, q, none, bend);
        for (int i = 0; i < e->dofs; i++)
            check_close(f[i], bend[i], 1e-9, "force");
    }
    end(&e, &w);
}

static void solve(const struct elastica *e, struct elastica_work *w, double gamma,
                  const double *rq, const double *rv, double *q, double *v)
{
    if (elastica_solve(e, w, gamma, rq, rv, q, v) != STATUS_DONE)
        fail_msg("%s", status_message());
}

/* A step of two stages, order 2, that lets stiff modes die: Alexander, SIAM J. Numer.
 * Anal. 14 (1977) 1006-1021. */
static void step(const struct elastica *e, struct elastica_work *w, double h, double *q, double *v)
{
    const double g = 1 - sqrt(0.5), c = (1 - g) / g;
    double zq[MOST], zv[MOST], rq[MOST], rv[MOST];

    for (int i = 0; i < e->dofs; i++)
        zq[i] = q[i] + g * h * v[i];
    solve(e, w, g * h, q, v, zq, zv);
    for (int i = 0; i < e->dofs; i++) {
        rq[i] = q[i] + c * (zq[i] - q[i]);
        rv[i] = v[i] + c * (zv[i] - v[i]);
    }
    memcpy(q, zq, (size_t)e->dofs * sizeof *q);
    solve(e, w, g * h, rq, rv, q, v);
}

/* Hinged and without weight, it spins for five turns.  Its share of energy at the end; what
 * damping took goes to *lost. */
static double spin(double ratio, double *lost)
{
    struct elastica_def def = plain(BENDING_PINNED, ratio);
    const double omega = 2, h = 2 * M_PI / omega / 400;
    double q[MOST] = {0}, v[MOST] = {0};

    def.EA = 3e4;
    struct elastica_work *w;
    struct elastica *e = made(def, &w);
    for (int i = 0; i < e->dofs; i += ELASTICA_NODE) {
        v[i + 1] = omega * (i / ELASTICA_NODE) * e->l;
        v[i + 3] = omega;
    }
    const double energy = elastica_kinetic(e, v);
    *lost = 0;
    for (int n = 0; n < 2000; n++) {
        step(e, w, h, q, v);
        *lost -= h * elastica_damping(e, q, v) / energy;
    }
    const double left = (elastica_kinetic(e, v) + elastica_elastic(e, q)) / energy;
    end(&e, &w);
    return left;
}

/* At the start it stretches a little, and so it bends, by Coriolis' force. */
static void a_beam_that_spins_loses_nothing(void **state)
{
    double none, lost;

    (void)state;
    check_close(spin(1, &lost), spin(0, &none), 1e-7, "energy with and without");
    check_close(lost, 0, 1e-7, "what damping took");
}

/* A cantilever let go from what a force at its tip makes of it: fast modes die at once,
 * then its energy falls by exp(-2 ratio omega t) from swing to swing. */
static void check_decay(double ratio, double turned)
{
    const struct elastica_def def = plain(BENDING_CLAMPED, ratio);
    struct elastica_work *w;
    struct elastica *e = made(def, &w);
    const double omega = bending_first(&def.bending), swing = omega * sqrt(1 - ratio * ratio);
    const double h = 2 * M_PI / swing / 200, L = def.bending.length;
    double q[MOST], v[MOST] = {0}, energy[2];

    for (int i = 0; i < e->dofs; i += ELASTICA_NODE) {
        const double x = i / ELASTICA_NODE * e->l / L;
        q[i] = q[i + 2] = 0;
        q[i + 1] = turned * L * x * x * (3 - x) / 3;
        q[i + 3] = turned * x * (2 - x);
    }
    for (int n = 0; n < 2; n++) {
        for (int i = 0; i < 600; i++)
            step(e, w, h, q, v);
        energy[n] = elastica_kinetic(e, v) + elastica_elastic(e, q);
    }
    const double rate = log(energy[0] / energy[1]) / (2 * 600 * h);
    check_close(rate / (ratio * omega), 1, 0.01, "decay");
    end(&e, &w);
}

static void small_vibrations_die_by_the_ratio(void **state)
{
    (void)state;
    check_decay(0.01, 1e-4);
    check_decay(0.05, 1e-4);
    check_decay(0.2, 1e-4);
}

/* At rest its matrix is beta times that of the linear beam, and so is its fastest decay. */
static void its_fastest_decay_is_that_of_the_linear_beam(void **state)
{
    const struct elastica_def def = plain(BENDING_CLAMPED, 0.4);
    struct elastica_work *w;
    struct elastica *e = made(def, &w);
    struct bending *b = bending_of(def.bending);
    double v[MOST] = {0}, rest[MOST] = {0}, across[2 * (ELEMENTS + 1)];
    unsigned seed = 4;

    (void)state;
    for (int i = 0; i < b->dofs; i++) {
        across[i] = bending_held(b, i) ? 0 : noise(&seed);
        v[2 * i + 1] = across[i];
    }
    check_close(elastica_damping(e, rest, v) / bending_damping(b, across), 1, 1e-12, "power");
    check_close(e->decay, b->decay, 0, "decay");
    check_close(e->decay / (def.bending.beta * b->fastest * b->fastest), 1, 1e-12, "beta omega^2");
    bending_free(&b);
    end(&e, &w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(power_is_that_of_the_moment),
        cmocka_unit_test(tangent_is_the_gradient_of_the_force),
        cmocka_unit_test(a_turn_as_a_whole_is_free),
        cmocka_unit_test(a_beam_that_spins_loses_nothing),
        cmocka_unit_test(small_vibrations_die_by_the_ratio),
        cmocka_unit_test(its_fastest_decay_is_that_of_the_linear_beam),
    };

    return cmocka_run_group_tests_name("elastica-friction", tests, NULL, NULL);
}
