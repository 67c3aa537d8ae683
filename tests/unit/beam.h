/* beam.h -- a beam on a bench of its own: layout, state and forces for tests. */
#ifndef TESTS_UNIT_BEAM_H
#define TESTS_UNIT_BEAM_H

#include "bench.h"
#include "bodies/beam-make.h"

static inline void bench_defaults(struct bench *b)
{
    bench_of(b, &bodies_beam);
}

/* What a scene may ask for of (44) and (45). */
static const struct bench_option {
    const char *inertia;
    double drag;
} bench_option[] = { { "consistent", 0 }, { "lumped", 0 }, { "lumped-ends", 0 },
                     { "consistent", 0.3 }, { "lumped", 0.02 }, { "lumped-ends", 4 } };
enum { BENCH_OPTIONS = sizeof bench_option / sizeof bench_option[0] };

static inline void bench_choose(struct bench *b, int option)
{
    b->def.inertia = bench_option[option].inertia;
    b->def.drag = bench_option[option].drag;
}

/* Mass of the beam on the bench: (44) as printed has that of one element more. */
static inline double bench_mass(const struct bench *b)
{
    const double mass = b->def.density * b->def.thickness * b->def.length;

    return strcmp(b->def.inertia, "lumped") ? mass : mass * (1 + 1.0 / b->def.elements);
}

static inline int bench_dofs(const struct bench *b)
{
    return 2 * (b->def.elements + 1);
}

/* Entry of y that holds degree of freedom i (w, theta, w, ...), or its rate. */
static inline long bench_at(const struct bench *b, int i, bool rate)
{
    return layout_at(&b->layout, 1 + (rate ? 2 : 0) + i % 2) + i / 2;
}

/* Some bent, moving state with forces all over the skin. */
static inline void bench_shake(struct bench *b, unsigned seed)
{
    for (int i = 0; i < bench_dofs(b); i++)
        if (!bending_held(b->body->bending, i)) {
            const double size = i % 2 ? 0.1 : 0.003;
            b->y[bench_at(b, i, false)] = size * noise(&seed);
            b->y[bench_at(b, i, true)] = 10 * size * noise(&seed);
        }
    bench_push(b, &seed);
}

/* Puts the beam where its loads hold it at rest: one implicit step so long that
 * inertia is nothing, z = gamma f_E + gamma f_I(z), whose rates are dropped. */
static inline void bench_settle(struct bench *b, double t)
{
    const double gamma = 1e9 / b->body->bending->fastest * bench_dofs(b) * bench_dofs(b);
    double r[BENCH_Y] = {0};

    memset(b->ydot, 0, sizeof b->ydot);
    bench_load(b, t);
    for (int i = 0; i < bench_dofs(b); i++)
        r[bench_at(b, i, true)] = gamma * b->ydot[bench_at(b, i, true)];
    assert_int_equal(bench_solve(b, t, gamma, r, b->y), STATUS_DONE);
    for (int i = 0; i < bench_dofs(b); i++)
        b->y[bench_at(b, i, true)] = 0;
}

#endif
