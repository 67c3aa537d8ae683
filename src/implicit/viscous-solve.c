/* viscous-solve.c -- z - gamma f_I(t, z) = r for the velocities of fluid and bodies.
 *
 * Positions and densities of z are those of r, so that the forces of a viscosity are
 * linear in velocities, F_a = sum c_ab (v_b - v_a) + those of walls that move. Times
 * the masses, with the bodies' part (BE1),
 *
 *   m z - gamma F(z, S w) = m r                                               (BV1)
 *   (M + gamma D + gamma^2 K) w - gamma S^T F_skin(z, S w) = M r_w - gamma K r_q
 *
 * is symmetric and positive definite.  Of positions only skins' depend on z: they come
 * from a guess, which is mended when the solution moves them. */
#include "implicit/viscous.h"

#include "base/status.h"
#include "eval/face.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MENDINGS = 10 }; /* of the places of skins */

static const double stay = 0.01; /* of tol and hs: skins that moved less stand right */

/* y of the stage as far as v says it. */
static void set_stage(struct moment *m, double gamma, const double *r)
{
    struct viscous *u = viscous_of(m);
    const double *v = u->v;

    memcpy(u->stage, r, (size_t)moment_size(m) * sizeof *r);
    memcpy(u->stage + layout_at(&m->layout, m->plan->row.u), v, (size_t)u->fluid * sizeof *v);
    v += u->fluid;
    for (int i = 0; i < m->plan->bodies; i++) {
        m->body[i].kind->role.coupled->write(m->body[i].body, &m->layout, gamma, r, v, u->stage);
        v += viscous_body(m->plan, i);
    }
}

/* The matrix and the first residual, at the places of the stage. */
static int set_system(struct moment *m, double t, double gamma, const double *r)
{
    struct viscous *u = viscous_of(m);
    const struct list *l = m->list;
    const double *r_u = r + layout_at(&m->layout, m->plan->row.u);
    int at = u->fluid;
    struct view v;

    TRY(rates_fields(m, t, u->stage, &v));
    TRY(moment_agree(m, viscous_fit(u)));
    memset(u->x, 0, (size_t)u->fluid * sizeof *u->x);
    memset(u->right, 0, (size_t)u->fluid * sizeof *u->right);
    memset(u->residual, 0, (size_t)u->fluid * sizeof *u->residual);
    for (int s = 0; s < l->start[KIND_FLUID + 1]; s++)
        for (int d = 0; d < DIM; d++) {
            const size_t k = (size_t)s * DIM + (size_t)d, c = (size_t)l->order[s] * DIM + (size_t)d;
            u->x[k] = u->v[c];
            u->right[k] = m->particles->m[l->order[s]] * r_u[c];
        }
    for (int i = 0; i < m->plan->bodies; i++) {
        const struct moment_body *b = &m->body[i];
        b->kind->role.coupled->right(b->body, b->work, &m->layout, gamma, r, u->right + at);
        memcpy(u->x + at, u->v + at, (size_t)viscous_body(m->plan, i) * sizeof *u->x);
        at += viscous_body(m->plan, i);
    }
    TRY(viscous_assemble(m, gamma, u->x, u->guess_image));
    for (int i = 0; i < u->unknowns; i++)
        u->residual[i] = u->right[i] - u->guess_image[i];
    if (m->plan->moving_walls) /* A x without their pull */
        operator_apply(&u->operator.all, u->x, u->guess_image);
    return viscous_join(m, gamma);
}

/* Solution to the order of rows; what is in no list keeps r. */
static void take_solution(struct moment *m, const double *r)
{
    struct viscous *u = viscous_of(m);
    const struct list *l = m->list;

    memcpy(u->v, r + layout_at(&m->layout, m->plan->row.u), (size_t)u->fluid * sizeof *u->v);
    for (int s = 0; s < l->start[KIND_FLUID + 1]; s++)
        memcpy(u->v + (size_t)l->order[s] * DIM, u->x + (size_t)s * DIM, DIM * sizeof *u->v);
    memcpy(u->v + u->fluid, u->x + u->fluid, (size_t)(u->unknowns - u->fluid) * sizeof *u->v);
}

/* How far skins stand from where the solution has them [m]. */
static double moved(struct moment *m, double t)
{
    const struct particles *all = m->particles;
    double most = 0;

    for (int i = 0; i < m->plan->bodies; i++) {
        const struct moment_body *b = &m->body[i];
        if (b->skin == 0)
            continue;
        const int from = all->object[b->object].from;
        double (*x)[DIM] = m->work->points;
        b->kind->move(b->body, b->work, &m->layout, t, viscous_of(m)->stage, x, m->work->speeds);
        for (int j = 0; j < b->skin; j++)
            for (int d = 0; d < DIM; d++)
                most = fmax(most, fabs(x[j][d] - all->x[particles_row_of(all, from + j)][d]));
    }
    return most;
}

/* Of the forces at the solution [W]: those on the fluid are known from the residual,
 * F = (m z - m r + residual)/gamma; those on solids are asked for. */
static double power(struct moment *m, double gamma)
{
    const struct viscous *u = viscous_of(m);
    const struct list *l = m->list;
    const int n = l->start[KIND_FLUID + 1];
    double sum = 0;

    viscous_multiply(m, KIND_SOLIDS, u->x, true);
    for (int s = 0; s < n; s++)
        for (int k = s * DIM; k < (s + 1) * DIM; k++)
            sum += u->x[k] * (m->particles->m[l->order[s]] * u->x[k] - u->right[k]
                              + u->residual[k]) / gamma;
    for (int s = n; s < l->start[KINDS]; s++)
        for (int d = 0; d < DIM && u->job.diagonal[s] > 0; d++)
            sum += u->velocity[(size_t)s * COUPLE_STRIDE + (size_t)d]
                   * m->work->f[(size_t)s * DIM + (size_t)d];
    if (plan_face_implicit(m->plan))
        sum += face_power(m);
    return sum;
}

/* Forces and power at the solution, and what they do to z. */
static void finish(struct moment *m, double gamma, const double *r, double *z)
{
    struct viscous *u = viscous_of(m);
    const long book = layout_at(&m->layout, m->plan->book.row);
    double *rates = u->stage + book;
    int at = u->fluid;

    m->work->power[u->part->slot] = power(m, gamma);
    viscous_book(m, rates);
    memcpy(z + layout_at(&m->layout, m->plan->row.u), u->v, (size_t)u->fluid * sizeof *z);
    for (int i = 0; i < m->plan->bodies; i++) {
        struct moment_body *b = &m->body[i];
        b->kind->role.coupled->write(b->body, &m->layout, gamma, r, u->v + at, z);
        b->kind->role.coupled->settle(b->body, b->work, &m->layout, gamma, r, z,
                                 (const double (*)[DIM])b->force,
                                 rates + m->plan->book.support + i * DIM);
        at += viscous_body(m->plan, i);
    }
    for (int k = 0; k < m->plan->book.n; k++)
        z[book + k] = r[book + k] + gamma * rates[k];
}

static int refuse_skins(struct moment *m, double t, double off)
{
    snprintf(m->refusal, sizeof m->refusal, "%s, taken implicitly, found no place for the skin of "
             "a body at t = %g s: after %d solves it still moves by %.3g m",
             viscous_of(m)->part->path, t, MENDINGS, off);
    return STATUS_FAILED;
}

int viscous_solve(struct moment *m, double t, double gamma, const double *r, double *z)
{
    struct viscous *u = viscous_of(m);
    const double near = fmax(stay * u->tol, 1e-11) * m->plan->scales.hs;
    double off = HUGE_VAL;

    viscous_guess(m, t, z, u->v);
    for (int k = 0; off > near; k++) {
        if (k == MENDINGS)
            return refuse_skins(m, t, off);
        set_stage(m, gamma, r);
        TRY(set_system(m, t, gamma, r));
        TRY(viscous_iterate(m, t, gamma));
        take_solution(m, r);
        set_stage(m, gamma, r);
        off = moved(m, t);
    }
    finish(m, gamma, r, z);
    viscous_keep(u, t, u->v);
    return STATUS_DONE;
}
