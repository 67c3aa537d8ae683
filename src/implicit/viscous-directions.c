/* viscous-directions.c -- directions of (BV1) in which nothing may be left: all fluid
 * alike (1, one for each component), and the guess.
 *
 * Then the sum of residuals is 0, and so is their work on the solution, which is a sum
 * of these and of directions conjugate to them: momentum and energy close to rounding
 * however inexact the solve.  Saad, Yeung, Erhel, Guyomarc'h, SIAM J. Sci. Comput. 21
 * (2000) 1909-1926. */
#include "implicit/viscous.h"

#include <math.h>
#include <string.h>

static double dot(const struct viscous *u, const double *a, const double *b)
{
    return vector_dot(u->unknowns, a, b, u->partial);
}

/* A 1 of fluid in place s: its mass, and what solids hold of it. */
static double drag_of(const struct moment *m, double gamma, int s)
{
    return m->particles->m[m->list->order[s]] + gamma * viscous_of(m)->job.firm[s];
}

/* A 1 of bodies, and 1 . A 1, for all components the same. */
static void set_drag(struct moment *m, double gamma)
{
    struct viscous *u = viscous_of(m);
    const struct list *l = m->list;
    double (*at)[DIM] = m->work->points;

    u->drag_all = 0;
    for (int s = 0; s < l->start[KIND_FLUID + 1]; s++)
        u->drag_all += drag_of(m, gamma, s);
    for (int d = 0; d < DIM; d++) {
        double *to = u->drag[d];
        memset(to, 0, (size_t)(u->unknowns - u->fluid) * sizeof *to);
        for (int i = 0; i < m->plan->bodies; i++) {
            struct moment_body *b = &m->body[i];
            memset(at, 0, (size_t)b->skin * sizeof *at);
            for (int j = 0; j < b->skin; j++) {
                const int s = viscous_place(m, b, j);
                at[j][d] = s < 0 ? 0 : u->job.firm[s];
            }
            b->kind->role.coupled->pull(b->body, b->work, (const double (*)[DIM])at, -gamma, to);
            to += viscous_body(m->plan, i);
        }
    }
}

/* (1 . A x)/(1 . A 1) of each component. */
static void along_drag(const struct moment *m, double gamma, const double *x, double mean[DIM])
{
    const struct viscous *u = viscous_of(m);
    const int n = m->list->start[KIND_FLUID + 1];

    memset(mean, 0, DIM * sizeof *mean);
    for (int s = 0; s < n; s++)
        for (int d = 0; d < DIM; d++)
            mean[d] += drag_of(m, gamma, s) * x[(size_t)s * DIM + (size_t)d];
    for (int d = 0; d < DIM; d++) {
        for (int i = u->fluid; i < u->unknowns; i++)
            mean[d] += u->drag[d][i - u->fluid] * x[i];
        mean[d] /= u->drag_all;
    }
}

/* w, the guess less its part along 1, and A w are made with w . A w = 1 and 1 . A w = 0;
 * w = 0 when nothing else moves. */
void viscous_directions_set(struct moment *m, double gamma)
{
    struct viscous *u = viscous_of(m);
    const struct list *l = m->list;
    double mean[DIM], norm, whole;

    set_drag(m, gamma);
    memcpy(u->guess, u->x, (size_t)u->unknowns * sizeof *u->guess);
    whole = dot(u, u->guess, u->guess_image);
    along_drag(m, gamma, u->guess, mean);
    for (int s = 0; s < l->start[KIND_FLUID + 1]; s++)
        for (int d = 0; d < DIM; d++) {
            const size_t k = (size_t)s * DIM + (size_t)d;
            u->guess[k] -= mean[d];
            u->guess_image[k] -= mean[d] * drag_of(m, gamma, s);
        }
    for (int d = 0; d < DIM; d++)
        for (int i = u->fluid; i < u->unknowns; i++)
            u->guess_image[i] -= mean[d] * u->drag[d][i - u->fluid];
    norm = dot(u, u->guess, u->guess_image);
    norm = norm > 1e-20 * fabs(whole) ? 1 / sqrt(norm) : 0;
    for (int i = 0; i < u->unknowns; i++) {
        u->guess[i] *= norm;
        u->guess_image[i] *= norm;
    }
}

struct viscous_along viscous_directions_clear(struct moment *m, double gamma, double *residual)
{
    const struct viscous *u = viscous_of(m);
    const int n = m->list->start[KIND_FLUID + 1];
    struct viscous_along along = { .guess = dot(u, u->guess, residual) };

    for (int s = 0; s < n; s++)
        for (int d = 0; d < DIM; d++)
            along.all[d] += residual[(size_t)s * DIM + (size_t)d];
    for (int d = 0; d < DIM; d++)
        along.all[d] /= u->drag_all;
    for (int i = 0; i < u->unknowns; i++)
        residual[i] -= along.guess * u->guess_image[i];
    for (int s = 0; s < n; s++)
        for (int d = 0; d < DIM; d++)
            residual[(size_t)s * DIM + (size_t)d] -= along.all[d] * drag_of(m, gamma, s);
    for (int d = 0; d < DIM; d++)
        for (int i = u->fluid; i < u->unknowns; i++)
            residual[i] -= along.all[d] * u->drag[d][i - u->fluid];
    return along;
}

void viscous_directions_add(const struct viscous *u, const struct viscous_along *along, double *x)
{
    for (int i = 0; i < u->unknowns; i++)
        x[i] += along->guess * u->guess[i];
    for (int i = 0; i < u->fluid; i++)
        x[i] += along->all[i % DIM];
}

void viscous_directions_leave(struct moment *m, double gamma, double *v)
{
    const struct viscous *u = viscous_of(m);
    const int n = m->list->start[KIND_FLUID + 1];
    const double along = dot(u, u->guess_image, v);
    double mean[DIM];

    along_drag(m, gamma, v, mean);
#pragma omp parallel for schedule(static) if (n > 4096)
    for (int s = 0; s < n; s++)
        for (int d = 0; d < DIM; d++) {
            const size_t k = (size_t)s * DIM + (size_t)d;
            v[k] -= along * u->guess[k] + mean[d];
        }
    for (int i = u->fluid; i < u->unknowns; i++)
        v[i] -= along * u->guess[i];
}
