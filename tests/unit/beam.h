/* beam.h -- a beam on a bench of its own: layout, state and forces for tests. */
#ifndef TESTS_UNIT_BEAM_H
#define TESTS_UNIT_BEAM_H

#include "bending.h"
#include "bodies/beam-make.h"
#include "defaults.h"

#include <string.h>

enum { BENCH_DOFS = 256, BENCH_Y = 2 * BENCH_DOFS + 16, BENCH_SKIN = 600 };

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
    fill_defaults(bodies_beam.params, &b->def);
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

static inline void bench_make(struct bench *b)
{
    status_clear();
    if (bodies_beam.create(&b->def, &b->scales, "it", "beam.it", &b->body))
        fail_msg("%s", status_message());
    layout_add(&b->layout, LAYOUT_POSITION, "others", "m", 3, 1, 1);
    assert_int_equal(bodies_beam.rows(b->body, &b->layout), STATUS_DONE);
    layout_add(&b->layout, LAYOUT_VELOCITY, "others", "m/s", 3, 1, 1);
    layout_done(&b->layout);
    b->size = layout_size(&b->layout);
    b->skin = bodies_beam.skin(b->body, NULL);
    assert_true(b->size <= BENCH_Y && b->skin <= BENCH_SKIN);
    bodies_beam.start(b->body, &b->layout, b->y);
}

static inline void bench_free(struct bench *b)
{
    bodies_beam.free(&b->body);
    assert_null(b->body);
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
    for (int i = 0; i < b->skin; i++)
        for (int d = 0; d < DIM; d++)
            b->force[i][d] = 5 * noise(&seed);
}

static inline void bench_load(struct bench *b, double t)
{
    bodies_beam.load(b->body, &b->layout, t, b->y, (const double (*)[DIM])b->force, b->ydot,
                     &b->load);
}

static inline double bench_energy(const struct bench *b, const double *y)
{
    struct energies e = {0};

    bodies_beam.energy(b->body, &b->layout, y, &e);
    return e.kinetic + e.potential + e.internal + e.elastic;
}

/* ydot of both sides. */
static inline void bench_rates(struct bench *b, double t)
{
    memset(b->ydot, 0, sizeof b->ydot);
    bench_load(b, t);
    bodies_beam.stiff(b->body, &b->layout, t, b->y, b->ydot);
}

static inline void bench_show(struct bench *b, double t, struct body_view *view)
{
    bodies_beam.show(b->body, &b->layout, t, b->y, (const double (*)[DIM])b->force, view);
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
    assert_int_equal(bodies_beam.solve(b->body, &b->layout, t, gamma, r, b->y), STATUS_DONE);
    for (int i = 0; i < bench_dofs(b); i++)
        b->y[bench_at(b, i, true)] = 0;
}

#endif
