/* mps.c -- one step of MPS, Koshizuka and Oka, Nucl. Sci. Eng. 123 (1996) 421-434:
 *
 *     u* = u + dt (nu lap u + g + f),  r* = r + dt u*
 *     collisions (M15); n*; surfaces n* < beta n0; (M7) with (M6), (M10) or (M11)
 *     u = u* - dt/rho0 grad p,  r = r* + dt (u - u*)                              (M8)
 *     stabilisation (M16) */
#include "solved/mps-inside.h"

#include "base/status.h"
#include "eval/given.h"
#include "matter/eos.h"
#include "plan/solver.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* --- refusals, told by the moment -------------------------------------------------- */

static void place_text(const struct mps *s, int i, char *text, size_t size)
{
    int n = snprintf(text, size, "particle %d (%s) at (%g", mps_id(s, i),
                     s->moment->particles->object[mps_object(s, i)].name, s->near.x[i][0]);

    for (int d = 1; d < DIM; d++)
        n += snprintf(text + n, size - (size_t)n, ", %g", s->near.x[i][d]);
    snprintf(text + n, size - (size_t)n, ") m");
}

static int refuse_loose(struct mps *s, int i, int joined)
{
    const struct scales *scales = &s->moment->plan->scales;
    char where[160];

    place_text(s, i, where, sizeof where);
    snprintf(s->moment->refusal, sizeof s->moment->refusal, "mps: %.150s and %d more have no surface "
             "near them, so their pressure is known but for a constant: fluid that walls close in "
             "on all sides; leave air, or set mps.compressibility = %.2g, that of eos.c0", where,
             joined - 1, 1 / (scales->rho0 * scales->c0 * scales->c0));
    return STATUS_FAILED;
}

static int refuse_solve(struct mps *s)
{
    char where[120];
    int worst = 0;

    for (int i = 1; i < s->near.n; i++)
        if (fabs(s->source[i]) > fabs(s->source[worst]))
            worst = i;
    place_text(s, worst, where, sizeof where);
    snprintf(s->moment->refusal, sizeof s->moment->refusal, "mps: no pressure is found: %.110s (to "
             "%g allowed, mps.residual, in %d, mps.iterations); its source is largest at %.100s, "
             "n = %.3g n0; allow more, or set mps.compressibility", s->poisson.why, s->key->residual,
             s->key->iterations, where, s->number[worst] / s->density.n0);
    return STATUS_FAILED;
}

/* Pressures stand in y as densities, and the source grows as 1/dt^2. */
static int refuse_pressure(struct mps *s, int i)
{
    const struct plan *p = s->moment->plan;
    char where[160];

    place_text(s, i, where, sizeof where);
    snprintf(s->moment->refusal, sizeof s->moment->refusal, "mps: pressure %.3g Pa of %.110s, n = "
             "%.3g n0, is beyond %g rho0, eos.highest: a step of %.3g s takes too much compression "
             "back, and the pressure for it grows as 1/step^2; longer steps, mps.gamma = 0.2, or "
             "room between fluid and walls at the start", s->p[i], where,
             s->number[i] / s->density.n0, p->in.eos.highest, s->h);
    return STATUS_FAILED;
}

static int refuse_place(struct mps *s, double t)
{
    snprintf(s->moment->refusal, sizeof s->moment->refusal,
             "mps: %s at t = %g s; the step before was too violent: a smaller one, mps@0.1",
             s->list->bad < 0 ? "no memory for the list of pairs"
                              : "the place of a particle is not finite", t);
    return STATUS_FAILED;
}

/* --- the parts of a step ----------------------------------------------------------- */

/* Neighbours at (t, y). */
static int look(struct mps *s, double t, const double *y)
{
    struct cloud cloud = { 0 };
    struct view v;

    moment_view(s->moment, t, y, &v);
    memcpy(cloud.from, v.p->from, sizeof cloud.from);
    memcpy(cloud.x, v.x, sizeof cloud.x);
    memcpy(cloud.row, v.p->row, sizeof cloud.row);
    if (s->moment->plan->engine->sum->list->update(s->list, &cloud) != STATUS_DONE)
        return refuse_place(s, t);
    s->moment->counts.passes++;
    return near_make(&s->near, s->list, &v, s->reach);
}

/* What is asked of the moment before the explicit part: n and its rate for (M11), by id. */
static void remember(struct mps *s)
{
    mps_number(s, s->number);
    mps_rate(s, s->rate);
    for (int i = 0; i < s->near.n; i++) {
        s->before[mps_id(s, i)] = s->number[i];
        s->rate_before[mps_id(s, i)] = s->rate[i];
    }
}

/* u* and r*, but for collisions; the book by the rates at the start. */
static int predict(struct mps *s, double t, const double *y, const double *f, double *to)
{
    const struct moment *m = s->moment;
    const long size = moment_size(m), x = layout_at(&m->layout, m->plan->row.x),
               u = layout_at(&m->layout, m->plan->row.u);
    const int n = particles_count(m->particles, KIND_FLUID);
    const bool ecs = mps_is(s->key->source, "ecs");

    for (long i = 0; i < size; i++)
        to[i] = y[i] + s->h * f[i];
    if (s->key->nu > 0 || ecs)
        TRY(look(s, t, y));
    if (ecs)
        remember(s);
    if (s->key->nu > 0) {
        mps_viscosity(s);
        for (int i = 0; i < s->near.fluid; i++) {
            memcpy(s->gave.kick[MPS_VISCOSITY][mps_id(s, i)], s->du[i], sizeof s->du[i]);
            for (int d = 0; d < DIM; d++)
                to[u + (long)s->list->order[i] * DIM + d] += s->du[i][d];
        }
    }
    for (long i = 0; i < (long)n * DIM; i++)
        to[x + i] = y[x + i] + s->h * to[u + i];
    return STATUS_DONE;
}

/* The guess: pressures that stand in y. */
static void guess(struct mps *s, const double *y)
{
    const struct plan *p = s->moment->plan;

    for (int k = 0; k < KINDS; k++)
        for (int i = s->list->start[k]; i < s->list->start[k + 1]; i++) {
            const int row = s->list->order[i] - s->moment->particles->from[k];
            s->p[i] = s->role[i] != POISSON_UNKNOWN || p->row.density[k] < 0 ? 0
                      : eos_pressure(p->pressure->self,
                                     y[layout_at(&s->moment->layout, p->row.density[k]) + row]);
        }
}

static int find_pressure(struct mps *s, const double *y)
{
    const double e = s->key->compressibility * s->moment->plan->scales.rho0 / (s->h * s->h);
    struct operator_report report;
    int loose, joined;

    mps_number(s, s->number);
    if (!mps_is(s->key->source, "number-density"))
        mps_rate(s, s->rate);
    mps_roles(s);
    mps_source(s);
    TRY(poisson_assemble(&s->poisson, &s->near, s->role, mps_laplacian(s), s, e));
    loose = poisson_loose(&s->poisson, s->role, &joined);
    if (loose >= 0)
        return refuse_loose(s, loose, joined);
    guess(s, y);
    s->moment->counts.solves++;
    const int status = poisson_solve(&s->poisson, s->source, s->key->residual, s->p, &report);
    s->moment->counts.products += report.products;
    if (status != STATUS_DONE)
        return refuse_solve(s);
    for (int i = 0; i < s->near.n && mps_is(s->key->clamp, "on"); i++)
        s->p[i] = fmax(s->p[i], 0);
    for (int i = 0; i < s->near.n; i++)
        if (!(eos_density(s->moment->plan->pressure->self, s->p[i]) <= s->moment->density[1])
            && s->p[i] > 0)
            return refuse_pressure(s, i);
    return STATUS_DONE;
}

static void correct(struct mps *s)
{
    memcpy(s->was, s->near.x, (size_t)s->near.n * sizeof *s->was);
    mps_gradient(s);
    mps_apply(s, MPS_PRESSURE);
    if (mps_is(s->key->ds, "on")) {
        mps_stabilise(s);
        mps_apply(s, MPS_STABILISATION);
    }
}

int mps_step(struct mps *s, double t, double h, const double *y, const double *f, double *to)
{
    s->h = h;
    mps_begin(s);
    given_start(s->moment);
    list_forget(s->list);
    TRY(predict(s, t, y, f, to));
    TRY(look(s, t + h, to));
    if (mps_is(s->key->collisions, "on")) {
        mps_collide(s);
        mps_apply(s, MPS_COLLISIONS);
    }
    TRY(find_pressure(s, y));
    correct(s);
    mps_write(s, t, y, to);
    return STATUS_DONE;
}

/* --- the contract ------------------------------------------------------------------- */

static int create(struct moment *moment, void **out)
{
    struct mps *s;
    const int status = mps_create(moment, &s);

    *out = s;
    return status;
}

static void leave(void **self)
{
    struct mps *s = *self;

    mps_free(&s);
    *self = NULL;
}

static double length(void *self, double number, double t, const double *y, const double *f,
                     struct limit *limit)
{
    (void)f;
    return mps_length(self, number, t, y, limit);
}

static int step(void *self, double t, double h, const double *y, const double *f, double *to,
                double *rates)
{
    (void)rates;
    return mps_step(self, t, h, y, f, to);
}

const struct plan_solved solved_mps = {
    .name = "mps",
    .work = { "mps.pressure", "mps.collisions", "mps.stabilisation", "mps.viscosity" },
    .serves = mps_serves, .create = create, .free = leave, .memory = mps_memory,
    .length = length, .step = step,
};
