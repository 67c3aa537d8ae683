/* elastica-yield.c -- tests of how a beam that bends far yields to a force within a time: as the
 * tangent says where there is no stress, and definitely where there is. */
#include "bending.h"
#include "bodies/elastica.h"
#include "defaults.h"

#include <math.h>
#include <string.h>

enum { ELEMENTS = 6, DOFS = 4 * (ELEMENTS + 1) };

static const double tau = 2e-3; /* [s] */

static struct elastica *made(struct elastica_work **work)
{
    const struct elastica_def def = {
        .bending = { .elements = ELEMENTS, .length = 0.5, .EI = 0.02, .mu = 1.3, .alpha = 30,
                     .beta = 4e-3, .drag = 0.7, .root = BENDING_PINNED, .tip = BENDING_FREE },
        .EA = 300, .thickness = 0.03, .speed = 1, .path = "beam.it" };
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

/* Straight, turned by `angle` about the root, every length times `stretch`. */
static void turn(const struct elastica *e, double angle, double stretch, double *q)
{
    for (int i = 0; i < e->dofs; i += ELASTICA_NODE) {
        q[i + 2] = stretch * cos(angle) - 1;
        q[i + 3] = stretch * sin(angle);
        for (int c = 0; c < 2; c++)
            q[i + c] = i / ELASTICA_NODE * e->l * q[i + 2 + c];
    }
}

static void scatter(const struct elastica *e, unsigned seed, double *v)
{
    for (int i = 0; i < e->dofs; i++)
        v[i] = elastica_held(e, i) ? 0 : noise(&seed) * (i % ELASTICA_NODE < 2 ? 1 : 1 / e->l);
}

/* d/dh of dE/dq + D v at (q + h a, h b), by differences of fourth order. */
static void slope(const struct elastica *e, struct elastica_work *w, const double *q,
                  const double *a, const double *b, double *to)
{
    static const double weight[4] = { 1, -8, 8, -1 };
    const double h = 1e-4;
    double at[DOFS], rate[DOFS], force[DOFS];

    memset(to, 0, DOFS * sizeof *to);
    for (int k = 0; k < 4; k++) {
        const double by = h * (k < 2 ? k - 2 : k - 1);
        for (int i = 0; i < e->dofs; i++) {
            at[i] = q[i] + by * a[i];
            rate[i] = by * b[i];
        }
        elastica_resist(e, w, at, rate, force);
        for (int i = 0; i < e->dofs; i++)
            to[i] += weight[k] * force[i] / (12 * h);
    }
}

/* M a and what a beam at rest resists with where it moves by tau^2 a, at the rate tau a, are the
 * force; likewise what it resists with after tau v. */
static void it_is_the_tangent_where_nothing_is_stressed(void **state)
{
    double q[DOFS], v[DOFS], f[DOFS], a[DOFS], far[DOFS], fast[DOFS], rest[DOFS] = { 0 };
    double inert[DOFS], resists[DOFS], to[DOFS] = { 0 }, off = 0, most = 0;
    struct elastica_work *w;
    struct elastica *e = made(&w);

    (void)state;
    turn(e, 0.9, 1, q);
    scatter(e, 3, f);
    scatter(e, 5, v);
    assert_int_equal(elastica_yield_set(e, w, tau, q), STATUS_DONE);
    elastica_yield_stretch(e, w, tau, v, to);
    memcpy(a, f, sizeof a);
    elastica_yield(e, w, a);
    for (int i = 0; i < e->dofs; i++) {
        far[i] = tau * tau * a[i];
        fast[i] = tau * a[i];
    }
    slope(e, w, q, far, fast, resists);
    band_multiply(e->mass, a, inert);
    for (int i = 0; i < e->dofs; i++)
        if (!elastica_held(e, i)) {
            off = fmax(off, fabs(inert[i] + resists[i] - f[i]));
            most = fmax(most, fabs(f[i]));
        }
    if (!(off < 1e-8 * most))
        fail_msg("what is left of a force of %g is %g", most, off);
    for (int i = 0; i < e->dofs; i++)
        far[i] = tau * v[i];
    slope(e, w, q, far, rest, resists);
    for (int i = 0; i < e->dofs; i++)
        if (!(fabs(to[i] - resists[i]) < 1e-7 * (1 + fabs(to[i]))))
            fail_msg("entry %d: %.12g after tau v, not %.12g", i, resists[i], to[i]);
    end(&e, &w);
}

/* Pressed to nine tenths of its length it would buckle: the tangent is not definite. */
static void it_is_definite_where_a_beam_buckles(void **state)
{
    double q[DOFS], f[DOFS], g[DOFS], by_f[DOFS], by_g[DOFS];
    double one = 0, other = 0, own = 0;
    struct elastica_work *w;
    struct elastica *e = made(&w);

    (void)state;
    turn(e, 0.9, 0.9, q);
    elastica_tangent(e, w, q);
    band_sum(w->sum, 1, e->mass, 1e4 * tau * tau, w->tangent);
    elastica_hold(e, w);
    assert_false(band_factor_definite(w->factor, w->sum));
    scatter(e, 3, f);
    scatter(e, 5, g);
    assert_int_equal(elastica_yield_set(e, w, 100 * tau, q), STATUS_DONE);
    memcpy(by_f, f, sizeof f);
    memcpy(by_g, g, sizeof g);
    elastica_yield(e, w, by_f);
    elastica_yield(e, w, by_g);
    for (int i = 0; i < e->dofs; i++) {
        one += f[i] * by_g[i];
        other += g[i] * by_f[i];
        own += f[i] * by_f[i];
    }
    assert_true(band_factor_definite(w->factor, w->sum));
    if (!(own > 0) || !(fabs(one - other) < 1e-9 * own))
        fail_msg("f . a(g) = %g, g . a(f) = %g, f . a(f) = %g", one, other, own);
    end(&e, &w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_the_tangent_where_nothing_is_stressed),
        cmocka_unit_test(it_is_definite_where_a_beam_buckles),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
