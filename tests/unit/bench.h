/* bench.h -- a beam of some kind on a bench of its own: layout, state and forces for tests. */
#ifndef TESTS_UNIT_BENCH_H
#define TESTS_UNIT_BENCH_H

#include "bending.h"
#include "bodies/beam-def.h"
#include "bodies/bodies.h"
#include "defaults.h"

#include <string.h>

enum { BENCH_DOFS = 256, BENCH_Y = 2 * BENCH_DOFS + 16, BENCH_SKIN = 600 };

struct bench {
    const struct body_kind *kind;
    struct beam_def def;
    struct scales scales;
    struct body *body;
    struct body_work *work;
    struct layout layout;
    int skin;
    long size;
    double y[BENCH_Y], ydot[BENCH_Y];
    double force[BENCH_SKIN][DIM];
    struct body_load load;
};

/* A plain cantilever in a world with water and no gravity. */
static inline void bench_of(struct bench *b, const struct body_kind *kind)
{
    memset(b, 0, sizeof *b);
    b->kind = kind;
    fill_defaults(kind->identity.params, &b->def);
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
    if (b->kind->make.create(&b->def, &b->scales, "it", "beam.it", &b->body))
        fail_msg("%s", status_message());
    assert_int_equal(b->kind->make.work(b->body, &b->work), STATUS_DONE);
    layout_add(&b->layout, LAYOUT_POSITION, "others", "m", 3, 1, 1);
    assert_int_equal(b->kind->rows(b->body, &b->layout), STATUS_DONE);
    layout_add(&b->layout, LAYOUT_VELOCITY, "others", "m/s", 3, 1, 1);
    layout_done(&b->layout);
    b->size = layout_size(&b->layout);
    b->skin = b->kind->skin(b->body, NULL, NULL);
    assert_true(b->size <= BENCH_Y && b->skin <= BENCH_SKIN);
    b->kind->start(b->body, &b->layout, b->y);
}

static inline void bench_free(struct bench *b)
{
    b->kind->make.work_free(&b->work);
    b->kind->make.free(&b->body);
    assert_null(b->work);
    assert_null(b->body);
}

/* The def is refused, by a message with `word`. */
static inline void bench_refuses(const struct bench *b, const char *word)
{
    struct body *body = NULL;

    status_clear();
    assert_int_equal(b->kind->make.create(&b->def, &b->scales, "it", "beam.it", &body),
                     STATUS_BAD_SCENE);
    assert_null(body);
    if (!strstr(status_message(), "beam.it") || !strstr(status_message(), word))
        fail_msg("\"%s\" does not name beam.it and %s", status_message(), word);
    status_clear();
}

static inline void bench_push(struct bench *b, unsigned *seed)
{
    for (int i = 0; i < b->skin; i++)
        for (int d = 0; d < DIM; d++)
            b->force[i][d] = 5 * noise(seed);
}

static inline void bench_load(struct bench *b, double t)
{
    b->kind->load(b->body, b->work, &b->layout, t, b->y, (const double (*)[DIM])b->force,
                  b->ydot, &b->load);
}

static inline double bench_energy(const struct bench *b, const double *y)
{
    struct energies e = {0};

    b->kind->energy(b->body, b->work, &b->layout, y, &e);
    return e.kinetic + e.potential + e.internal + e.elastic;
}

/* As implicit->solve() of the kind. */
static inline int bench_solve(struct bench *b, double t, double gamma, const double *r, double *z)
{
    return b->kind->implicit->solve(b->body, b->work, &b->layout, t, gamma, r, z);
}

/* ydot of both sides. */
static inline void bench_rates(struct bench *b, double t)
{
    memset(b->ydot, 0, sizeof b->ydot);
    bench_load(b, t);
    b->kind->implicit->stiff(b->body, b->work, &b->layout, t, b->y, b->ydot);
}

/* Power of the forces on the skin, at t = 0. */
static inline double bench_power(const struct bench *b)
{
    static double x[BENCH_SKIN][DIM], u[BENCH_SKIN][DIM];
    double power = 0;

    b->kind->move(b->body, b->work, &b->layout, 0, b->y, x, u);
    for (int i = 0; i < b->skin; i++)
        for (int d = 0; d < DIM; d++)
            power += b->force[i][d] * u[i][d];
    return power;
}

/* Rate of the energy along ydot, by steps of h to both sides. */
static inline double bench_energy_rate(const struct bench *b, double h)
{
    double up[BENCH_Y], down[BENCH_Y];

    for (int i = 0; i < b->size; i++) {
        up[i] = b->y[i] + h * b->ydot[i];
        down[i] = b->y[i] - h * b->ydot[i];
    }
    return (bench_energy(b, up) - bench_energy(b, down)) / (2 * h);
}

static inline void bench_show(struct bench *b, double t, struct body_view *view)
{
    b->kind->show(b->body, b->work, &b->layout, t, b->y, (const double (*)[DIM])b->force, view);
}

#endif
