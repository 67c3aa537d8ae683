/* viscous-operator.c -- A of (BV1) times velocities, and about its inverse. */
#include "plan/viscous.h"

#include "base/status.h"
#include "plan/face.h"

#include <math.h>
#include <string.h>

int viscous_body(const struct plan *p, int i)
{
    return p->body[i].kind->unknowns(p->body[i].body);
}

/* Velocities of everybody by slot; of walls only when they are asked for. */
static void spread(struct plan *p, const double *x, bool walls)
{
    const struct particles *all = p->particles;
    const struct list *l = p->main.list;
    double (*to)[COUPLE_STRIDE] = (double (*)[COUPLE_STRIDE])p->viscous->velocity;
    const double *w = x + p->viscous->fluid;

    for (int s = 0; s < l->start[KIND_FLUID + 1]; s++)
        memcpy(to[s], x + (size_t)s * DIM, DIM * sizeof *x);
    for (int s = l->start[KIND_WALL]; s < l->start[KIND_WALL + 1]; s++)
        for (int d = 0; d < DIM; d++)
            to[s][d] = walls ? all->u[l->order[s]][d] : 0;
    for (int i = 0; i < p->bodies; i++) {
        struct plan_body *b = &p->body[i];
        b->kind->drift(b->body, w, b->force);
        for (int j = 0; j < b->skin; j++) {
            const int s = l->slot[all->object[b->object].from + j];
            if (s >= 0)
                memcpy(to[s], b->force[j], sizeof b->force[j]);
        }
        w += viscous_body(p, i);
    }
    for (int s = l->image[0]; s < l->listed; s++)
        memcpy(to[s], to[l->slot[l->order[s]]], sizeof to[s]);
    memset(to[l->listed], 0, sizeof to[0]);
}

void viscous_multiply(struct plan *p, unsigned kinds, const double *x, bool walls)
{
    const bool faces = viscous_faces(p);

    spread(p, x, walls);
    p->engine->couple->multiply(&p->viscous->job, faces ? kinds | KIND_STICKY : kinds,
                                p->viscous->velocity, p->main.f);
    if (faces)
        face_complete(p, &p->viscous->job, kinds, walls, p->main.f);
    p->counts.products += kinds & KIND_BIT(KIND_FLUID);
}

/* A x, of the forces in main.f. */
static void image_of(struct plan *p, double gamma, const double *x, double *to)
{
    const struct list *l = p->main.list;
    const double *m = p->particles->m, *f = p->main.f;
    const int n = l->start[KIND_FLUID + 1];
    int at = p->viscous->fluid;

#pragma omp parallel for schedule(static) if (n > 4096)
    for (int s = 0; s < n; s++)
        for (int k = s * DIM; k < (s + 1) * DIM; k++)
            to[k] = m[l->order[s]] * x[k] - gamma * f[k];
    for (int i = 0; i < p->bodies; i++) {
        struct plan_body *b = &p->body[i];
        b->kind->inertia(b->body, gamma, x + at, to + at);
        plan_skin_force(p, &p->main, b);
        b->kind->pull(b->body, (const double (*)[DIM])b->force, -gamma, to + at);
        at += viscous_body(p, i);
    }
}

void viscous_apply(struct plan *p, double gamma, const double *x, double *to)
{
    viscous_multiply(p, KIND_BIT(KIND_FLUID) | KIND_BIT(KIND_SKIN), x, false);
    image_of(p, gamma, x, to);
}

int viscous_assemble(struct plan *p, double gamma, const double *x, double *to)
{
    struct couple_job *const job = &p->viscous->job;

    spread(p, x, true);
    p->engine->couple->assemble(job, p->main.record, p->viscous->velocity, p->main.f);
    p->counts.passes++;
    if (viscous_faces(p)) {
        TRY(face_ready(p, job));
        face_complete(p, job, KIND_BIT(KIND_FLUID) | KIND_BIT(KIND_SKIN), true, p->main.f);
    }
    image_of(p, gamma, x, to);
    return STATUS_DONE;
}

int viscous_join(struct plan *p, double gamma)
{
    const struct viscous *u = p->viscous;

    for (int i = 0; i < p->bodies; i++) {
        struct plan_body *b = &p->body[i];
        double *c = b->force[0]; /* scratch of this length and more */
        for (int j = 0; j < b->skin; j++) {
            const int s = p->main.list->slot[p->particles->object[b->object].from + j];
            c[j] = s < 0 ? 0 : u->job.firm[s];
        }
        TRY(b->kind->join(b->body, gamma, c));
    }
    return STATUS_DONE;
}

double viscous_precondition(struct plan *p, double gamma, const double *residual, double *near)
{
    const struct viscous *u = p->viscous;
    const struct list *l = p->main.list;
    const int n = l->start[KIND_FLUID + 1];
    double most = 0;
    int at = u->fluid;

#pragma omp parallel for schedule(static) reduction(max : most) if (n > 4096)
    for (int s = 0; s < n; s++) {
        const double d = p->particles->m[l->order[s]] + gamma * u->job.diagonal[s];
        for (int k = s * DIM; k < (s + 1) * DIM; k++) {
            near[k] = residual[k] / d;
            most = fmax(most, fabs(near[k]));
        }
    }
    for (int i = 0; i < p->bodies; i++) {
        const struct plan_body *b = &p->body[i];
        const int size = viscous_body(p, i);
        memcpy(near + at, residual + at, (size_t)size * sizeof *near);
        b->kind->joined(b->body, near + at);
        most = fmax(most, b->kind->fastest(b->body, near + at));
        at += size;
    }
    return most / p->scales.speed;
}
