/* elastica.h -- a beam that bends far on a bench of its own, for tests. */
#ifndef TESTS_UNIT_ELASTICA_H
#define TESTS_UNIT_ELASTICA_H

#include "bending.h"
#include "bodies/elastica-make.h"
#include "defaults.h"

#include <string.h>

enum { BENCH_DOFS = 4 * 42, BENCH_Y = 2 * BENCH_DOFS + 16, BENCH_SKIN = 400 };

struct bench {
    struct beam_def def;
    struct scales scales;
    struct body *body;
    struct layout layout;
    int skin;
    long size;
    double y[BENCH_Y], ydot[BENCH_Y];
    double force[BENCH_SKIN][DIM];
    struct body_load load;
};

/* A plain cantilever in a world with water and no gravity. */
static inline void bench_defaults(struct bench *b)
{
    memset(b, 0, sizeof *b);
    fill_defaults(bodies_elastica.params, &b->def);
    b->def.theory = "elastica";
    b->def.at[0] = 0.3;
    b->def.at[1] = 0.1;
    b->def.length = 0.2;
    b->def.thickness = 0.01;
    b->def.E = 2e6;
    b->def.density = 1200;
    b->def.elements = 8;
    b->scales = (struct scales){ .dimension = DIM, .dx = 0.01, .support = 0.03, .hs = 0.015,
                                 .rho0 = 1000, .c0 = 20, .speed = 2, .fluid = true };
}

static inline void bench_make(struct bench *b)
{
    status_clear();
    if (bodies_elastica.create(&b->def, &b->scales, "it", "beam.it", &b->body))
        fail_msg("%s", status_message());
    layout_add(&b->layout, LAYOUT_POSITION, "others", "m", 3, 1, 1);
    assert_int_equal(bodies_elastica.rows(b->body, &b->layout), STATUS_DONE);
    layout_add(&b->layout, LAYOUT_VELOCITY, "others", "m/s", 3, 1, 1);
    layout_done(&b->layout);
    b->size = layout_size(&b->layout);
    b->skin = bodies_elastica.skin(b->body, NULL);
    assert_true(b->size <= BENCH_Y && b->skin <= BENCH_SKIN);
    bodies_elastica.start(b->body, &b->layout, b->y);
}

static inline void bench_free(struct bench *b)
{
    bodies_elastica.free(&b->body);
    assert_null(b->body);
}

static inline int bench_dofs(const struct bench *b)
{
    return b->body->beam->dofs;
}

/* Entry of y that holds degree of freedom i (u, w, their slopes, u, ...), or its rate. */
static inline long bench_at(const struct bench *b, int i, bool rate)
{
    return layout_at(&b->layout, 1 + (rate ? 4 : 0) + i % 4) + i / 4;
}

/* Some moving state, bent far and turned, with forces all over the skin. */
static inline void bench_shake(struct bench *b, unsigned seed)
{
    for (int i = 0; i < bench_dofs(b); i++)
        if (!elastica_held(b->body->beam, i)) {
            const double size = i % 4 < 2 ? 0.002 : 0.1;
            b->y[bench_at(b, i, false)] += size * noise(&seed);
            b->y[bench_at(b, i, true)] = 10 * size * noise(&seed);
        }
    for (int i = 0; i < b->skin; i++)
        for (int d = 0; d < DIM; d++)
            b->force[i][d] = 5 * noise(&seed);
}

static inline void bench_load(struct bench *b, double t)
{
    bodies_elastica.load(b->body, &b->layout, t, b->y, (const double (*)[DIM])b->force, b->ydot,
                         &b->load);
}

static inline double bench_energy(const struct bench *b, const double *y)
{
    struct energies e = {0};

    bodies_elastica.energy(b->body, &b->layout, y, &e);
    return e.kinetic + e.potential + e.internal + e.elastic;
}

/* ydot of both sides. */
static inline void bench_rates(struct bench *b, double t)
{
    memset(b->ydot, 0, sizeof b->ydot);
    bench_load(b, t);
    bodies_elastica.stiff(b->body, &b->layout, t, b->y, b->ydot);
}

static inline void bench_show(struct bench *b, double t, struct body_view *view)
{
    bodies_elastica.show(b->body, &b->layout, t, b->y, (const double (*)[DIM])b->force, view);
}

/* One implicit step of length gamma under the load at its beginning. */
static inline int bench_step(struct bench *b, double t, double gamma)
{
    double r[BENCH_Y];

    memset(b->ydot, 0, sizeof b->ydot);
    bench_load(b, t);
    for (int i = 0; i < BENCH_Y; i++)
        r[i] = b->y[i] + gamma * b->ydot[i];
    return bodies_elastica.solve(b->body, &b->layout, t, gamma, r, b->y);
}

/* Puts the beam where its loads hold it at rest: implicit steps from rest whose rates are
 * dropped, longer and longer, but shorter where the solve finds nothing. */
static inline void bench_settle(struct bench *b, double t)
{
    const double slow = 1 / bending_first(&b->body->beam->plane->def);
    double gamma = slow;

    while (gamma < 1e5 * slow) {
        if (bench_step(b, t, gamma) == STATUS_DONE)
            gamma *= 2;
        else if ((gamma /= 4) < 1e-3 * slow)
            fail_msg("%s", status_message());
        status_clear();
        for (int i = 0; i < bench_dofs(b); i++)
            b->y[bench_at(b, i, true)] = 0;
    }
}

#endif
