/* viscous-operator.c -- A of (BV1) times velocities, and about its inverse. */
#include "implicit/viscous.h"

#include "base/status.h"
#include "eval/face.h"

#include <math.h>
#include <string.h>

int viscous_body(const struct plan *p, int i)
{
    return p->body[i].kind->coupled->unknowns(p->body[i].body);
}

/* Velocities of everybody by slot; of walls only when they are asked for. */
static void spread(struct moment *m, const double *x, bool walls)
{
    const struct particles *all = m->particles;
    const struct list *l = m->list;
    double (*to)[COUPLE_STRIDE] = (double (*)[COUPLE_STRIDE])viscous_of(m)->velocity;
    double (*point)[DIM] = m->work->points;
    const double *w = x + viscous_of(m)->fluid;

    for (int s = 0; s < l->start[KIND_FLUID + 1]; s++)
        memcpy(to[s], x + (size_t)s * DIM, DIM * sizeof *x);
    for (int s = l->start[KIND_WALL]; s < l->start[KIND_WALL + 1]; s++)
        for (int d = 0; d < DIM; d++)
            to[s][d] = walls ? all->u[l->order[s]][d] : 0;
    for (int i = 0; i < m->plan->bodies; i++) {
        struct moment_body *b = &m->body[i];
        b->kind->coupled->drift(b->body, w, point);
        for (int j = 0; j < b->skin; j++) {
            const int s = viscous_place(m, b, j);
            if (s >= 0)
                memcpy(to[s], point[j], sizeof point[j]);
        }
        w += viscous_body(m->plan, i);
    }
    for (int s = l->image[0]; s < l->listed; s++)
        memcpy(to[s], to[l->slot[l->order[s]]], sizeof to[s]);
    memset(to[l->listed], 0, sizeof to[0]);
}

void viscous_multiply(struct moment *m, unsigned kinds, const double *x, bool walls)
{
    const bool faces = plan_face_implicit(m->plan);

    spread(m, x, walls);
    m->plan->engine->couple->multiply(&viscous_of(m)->job, faces ? kinds | KIND_STICKY : kinds,
                                viscous_of(m)->velocity, m->work->f);
    if (faces)
        face_complete(m, &viscous_of(m)->job, kinds, walls, m->work->f);
    m->counts.products += kinds & KIND_BIT(KIND_FLUID);
}

/* A x, of the forces in work->f. */
static void image_of(struct moment *m, double gamma, const double *x, double *to)
{
    const struct list *l = m->list;
    const double *mass = m->particles->m, *f = m->work->f;
    const int n = l->start[KIND_FLUID + 1];
    int at = viscous_of(m)->fluid;

#pragma omp parallel for schedule(static) if (n > 4096)
    for (int s = 0; s < n; s++)
        for (int k = s * DIM; k < (s + 1) * DIM; k++)
            to[k] = mass[l->order[s]] * x[k] - gamma * f[k];
    for (int i = 0; i < m->plan->bodies; i++) {
        struct moment_body *b = &m->body[i];
        b->kind->coupled->inertia(b->body, b->work, gamma, x + at, to + at);
        solids_skin(m, b);
        b->kind->coupled->pull(b->body, b->work, (const double (*)[DIM])b->force, -gamma, to + at);
        at += viscous_body(m->plan, i);
    }
}

void viscous_apply(struct moment *m, double gamma, const double *x, double *to)
{
    viscous_multiply(m, KIND_BIT(KIND_FLUID) | KIND_BIT(KIND_SKIN), x, false);
    image_of(m, gamma, x, to);
}

int viscous_assemble(struct moment *m, double gamma, const double *x, double *to)
{
    struct couple_job *const job = &viscous_of(m)->job;

    spread(m, x, true);
    m->plan->engine->couple->assemble(job, m->work->record, viscous_of(m)->velocity, m->work->f);
    m->counts.passes++;
    if (plan_face_implicit(m->plan)) {
        TRY(face_ready(m, job));
        face_complete(m, job, KIND_BIT(KIND_FLUID) | KIND_BIT(KIND_SKIN), true, m->work->f);
    }
    image_of(m, gamma, x, to);
    return STATUS_DONE;
}

int viscous_join(struct moment *m, double gamma)
{
    const struct viscous *u = viscous_of(m);

    for (int i = 0; i < m->plan->bodies; i++) {
        struct moment_body *b = &m->body[i];
        double *c = m->work->points[0]; /* scratch of this length and more */
        for (int j = 0; j < b->skin; j++) {
            const int s = viscous_place(m, b, j);
            c[j] = s < 0 ? 0 : u->job.firm[s];
        }
        TRY(b->kind->coupled->join(b->body, b->work, gamma, c));
    }
    return STATUS_DONE;
}

double viscous_precondition(struct moment *m, double gamma, const double *residual, double *near)
{
    const struct viscous *u = viscous_of(m);
    const struct list *l = m->list;
    const int n = l->start[KIND_FLUID + 1];
    double most = 0;
    int at = u->fluid;

#pragma omp parallel for schedule(static) reduction(max : most) if (n > 4096)
    for (int s = 0; s < n; s++) {
        const double d = m->particles->m[l->order[s]] + gamma * u->job.diagonal[s];
        for (int k = s * DIM; k < (s + 1) * DIM; k++) {
            near[k] = residual[k] / d;
            most = fmax(most, fabs(near[k]));
        }
    }
    for (int i = 0; i < m->plan->bodies; i++) {
        const struct moment_body *b = &m->body[i];
        const int size = viscous_body(m->plan, i);
        memcpy(near + at, residual + at, (size_t)size * sizeof *near);
        b->kind->coupled->joined(b->body, b->work, near + at);
        most = fmax(most, b->kind->coupled->fastest(b->body, near + at));
        at += size;
    }
    return most / m->plan->scales.speed;
}
