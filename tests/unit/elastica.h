/* elastica.h -- a beam that bends far on a bench of its own, for tests. */
#ifndef TESTS_UNIT_ELASTICA_H
#define TESTS_UNIT_ELASTICA_H

#include "bench.h"
#include "bodies/elastica-make.h"

static inline void bench_defaults(struct bench *b)
{
    bench_of(b, &bodies_elastica);
    b->def.theory = "elastica";
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
    bench_push(b, &seed);
}

/* One implicit step of length gamma under the load at its beginning. */
static inline int bench_step(struct bench *b, double t, double gamma)
{
    double r[BENCH_Y];

    memset(b->ydot, 0, sizeof b->ydot);
    bench_load(b, t);
    for (int i = 0; i < BENCH_Y; i++)
        r[i] = b->y[i] + gamma * b->ydot[i];
    return bench_solve(b, t, gamma, r, b->y);
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
