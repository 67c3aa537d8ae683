/* viscous-gradients.c -- (BV1) by conjugate gradients, kept from some directions.
 *
 * What is left of momentum and of the work on the solution is nothing, however inexact
 * the solve: the directions "all fluid alike" and "the guess" are solved for exactly,
 * and every other direction is conjugate to them.  Hestenes, Stiefel, J. Res. Nat. Bur.
 * Standards 49 (1952) 409-436; Saad, Yeung, Erhel, Guyomarc'h, SIAM J. Sci. Comput. 21
 * (2000) 1909-1926. */
#include "plan/viscous.h"

#include "base/status.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    PRODUCTS = 1000, /* of one solve at most                                   */
    CLEAN = 8,       /* products until rounding is taken out of the residual   */
    BLOCK = 512
};

static const double exact = 0.01; /* of tol: the largest correction left         */

/* The same on any number of threads. */
static double dot(const struct viscous *u, const double *a, const double *b)
{
    const int blocks = (u->unknowns + BLOCK - 1) / BLOCK;
    double sum = 0;

#pragma omp parallel for schedule(static) if (blocks > 40)
    for (int k = 0; k < blocks; k++) {
        const int to = (k + 1) * BLOCK < u->unknowns ? (k + 1) * BLOCK : u->unknowns;
        double part = 0;
        for (int i = k * BLOCK; i < to; i++)
            part += a[i] * b[i];
        u->partial[k] = part;
    }
    for (int k = 0; k < blocks; k++)
        sum += u->partial[k];
    return sum;
}

/* --- directions -------------------------------------------------------------- */

/* A 1 of fluid in slot s: its mass, and what solids hold of it. */
static double drag_of(const struct plan *p, double gamma, int s)
{
    return p->particles->m[p->main.list->order[s]] + gamma * p->viscous->job.firm[s];
}

/* A 1 of bodies, and 1 . A 1, for all components the same. */
static void set_drag(struct plan *p, double gamma)
{
    struct viscous *u = p->viscous;
    const struct list *l = p->main.list;

    u->drag_all = 0;
    for (int s = 0; s < l->start[KIND_FLUID + 1]; s++)
        u->drag_all += drag_of(p, gamma, s);
    for (int d = 0; d < DIM; d++) {
        double *to = u->drag[d];
        memset(to, 0, (size_t)(u->unknowns - u->fluid) * sizeof *to);
        for (int i = 0; i < p->bodies; i++) {
            struct plan_body *b = &p->body[i];
            memset(b->force, 0, (size_t)b->skin * sizeof *b->force);
            for (int j = 0; j < b->skin; j++) {
                const int s = l->slot[p->particles->object[b->object].from + j];
                b->force[j][d] = s < 0 ? 0 : u->job.firm[s];
            }
            b->kind->pull(b->body, (const double (*)[DIM])b->force, -gamma, to);
            to += viscous_body(p, i);
        }
    }
}

/* (1 . A x)/(1 . A 1) of each component. */
static void along_drag(const struct plan *p, double gamma, const double *x, double mean[DIM])
{
    const struct viscous *u = p->viscous;
    const int n = p->main.list->start[KIND_FLUID + 1];

    memset(mean, 0, DIM * sizeof *mean);
    for (int s = 0; s < n; s++)
        for (int d = 0; d < DIM; d++)
            mean[d] += drag_of(p, gamma, s) * x[(size_t)s * DIM + (size_t)d];
    for (int d = 0; d < DIM; d++) {
        for (int i = u->fluid; i < u->unknowns; i++)
            mean[d] += u->drag[d][i - u->fluid] * x[i];
        mean[d] /= u->drag_all;
    }
}

/* Directions in which nothing may be left: all fluid alike (1, one for each component),
 * and the guess. Then the sum of residuals is 0, and so is their work on the solution,
 * which is a sum of these and of search directions: momentum and energy close to
 * rounding however inexact the solve.  w, the guess less its part along 1, and A w are
 * made with w . A w = 1 and 1 . A w = 0; w = 0 when nothing else moves. */
static void set_directions(struct plan *p, double gamma)
{
    struct viscous *u = p->viscous;
    const struct list *l = p->main.list;
    double mean[DIM], norm;

    set_drag(p, gamma);
    memcpy(u->guess, u->x, (size_t)u->unknowns * sizeof *u->guess);
    memcpy(u->guess_image, u->image, (size_t)u->unknowns * sizeof *u->image);
    along_drag(p, gamma, u->guess, mean);
    for (int s = 0; s < l->start[KIND_FLUID + 1]; s++)
        for (int d = 0; d < DIM; d++) {
            const size_t k = (size_t)s * DIM + (size_t)d;
            u->guess[k] -= mean[d];
            u->guess_image[k] -= mean[d] * drag_of(p, gamma, s);
        }
    for (int d = 0; d < DIM; d++)
        for (int i = u->fluid; i < u->unknowns; i++)
            u->guess_image[i] -= mean[d] * u->drag[d][i - u->fluid];
    norm = dot(u, u->guess, u->guess_image);
    norm = norm > 1e-20 * fabs(dot(u, u->x, u->image)) ? 1 / sqrt(norm) : 0;
    for (int i = 0; i < u->unknowns; i++) {
        u->guess[i] *= norm;
        u->guess_image[i] *= norm;
    }
}

/* Takes what is left along these directions out of the residual, into x. */
static void project(struct plan *p, double gamma)
{
    struct viscous *u = p->viscous;
    const struct list *l = p->main.list;
    const int n = l->start[KIND_FLUID + 1];
    const double along = dot(u, u->guess, u->residual);
    double sum[DIM] = { 0 };

    for (int s = 0; s < n; s++)
        for (int d = 0; d < DIM; d++)
            sum[d] += u->residual[(size_t)s * DIM + (size_t)d] / u->drag_all;
    for (int i = 0; i < u->unknowns; i++) {
        u->x[i] += along * u->guess[i];
        u->residual[i] -= along * u->guess_image[i];
    }
    for (int s = 0; s < n; s++)
        for (int d = 0; d < DIM; d++) {
            const size_t k = (size_t)s * DIM + (size_t)d;
            u->x[k] += sum[d];
            u->residual[k] -= sum[d] * drag_of(p, gamma, s);
        }
    for (int d = 0; d < DIM; d++)
        for (int i = u->fluid; i < u->unknowns; i++)
            u->residual[i] -= sum[d] * u->drag[d][i - u->fluid];
}

/* search = near + again search, less what of it is along these directions. */
static void turn(struct plan *p, double gamma, double again)
{
    struct viscous *u = p->viscous;
    const int n = p->main.list->start[KIND_FLUID + 1];
    const double along = dot(u, u->guess_image, u->near);
    double mean[DIM];

    along_drag(p, gamma, u->near, mean);
#pragma omp parallel for schedule(static) if (n > 4096)
    for (int s = 0; s < n; s++)
        for (int d = 0; d < DIM; d++) {
            const size_t k = (size_t)s * DIM + (size_t)d;
            u->search[k] = u->near[k] + again * u->search[k] - along * u->guess[k] - mean[d];
        }
    for (int i = u->fluid; i < u->unknowns; i++)
        u->search[i] = u->near[i] + again * u->search[i] - along * u->guess[i];
}

/* --- the solve ---------------------------------------------------------------- */

static int refuse(struct plan *p, double t, double left, int products)
{
    snprintf(p->refusal, sizeof p->refusal, "%s, taken implicitly, found no velocities at "
             "t = %g s: after %d products the largest correction is still %.3g of its scale (tol "
             "%g)", p->viscous->part->path, t, products, left, p->viscous->tol);
    return STATUS_FAILED;
}

int viscous_iterate(struct plan *p, double t, double gamma)
{
    struct viscous *u = p->viscous;
    const double enough = exact * u->tol, floor = 1e-30 * fabs(dot(u, u->right, u->x));
    double left, rz, again = 0;

    set_directions(p, gamma);
    project(p, gamma);
    left = viscous_precondition(p, gamma);
    rz = dot(u, u->residual, u->near);
    for (int k = 0; !(left <= enough && isfinite(rz)) && !(rz <= floor); k++) {
        if (k == PRODUCTS || !isfinite(rz))
            return refuse(p, t, left, k);
        turn(p, gamma, again);
        viscous_apply(p, gamma, u->search, false, u->image);
        const double along = rz / dot(u, u->search, u->image), before = rz;
#pragma omp parallel for schedule(static) if (u->unknowns > 8192)
        for (int i = 0; i < u->unknowns; i++) {
            u->x[i] += along * u->search[i];
            u->residual[i] -= along * u->image[i];
        }
        if (k % CLEAN == CLEAN - 1)
            project(p, gamma);
        left = viscous_precondition(p, gamma);
        rz = dot(u, u->residual, u->near);
        again = rz / before;
    }
    return STATUS_DONE;
}
