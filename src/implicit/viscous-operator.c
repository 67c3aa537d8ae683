/* viscous-operator.c -- A of (BV1) as an operator, and about its inverse. */
#include "implicit/viscous.h"

#include "base/status.h"
#include "base/threads.h"
#include "eval/face.h"

#include <string.h>

enum { WORTH_THREADS = 4096 };

int viscous_body(const struct plan *p, int i)
{
    return p->body[i].kind->role.coupled->unknowns(p->body[i].body);
}

/* Velocities of all particles by place; of walls only when they are asked for. */
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
        b->kind->role.coupled->drift(b->body, w, point);
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
    if (m->plan->bodies > 0)
        wet_take(m);
    m->counts.products += kinds & KIND_BIT(KIND_FLUID);
}

/* Rows of this thread. */
static void fluid_part(const struct moment *m, double gamma, const double *x, double *to)
{
    const struct list *l = m->list;
    const struct threads_part part = threads_part(l->start[KIND_FLUID + 1]);
    const double *mass = m->particles->m, *f = m->work->f;

    for (int s = part.from; s < part.to; s++)
        for (int k = s * DIM; k < (s + 1) * DIM; k++)
            to[k] = mass[l->order[s]] * x[k] - gamma * f[k];
}

/* Rows of the fluid, m x - gamma F, of the forces in work->f.  What is in no list is 1 x. */
static void fluid_rows(const struct moment *m, double gamma, const double *x, double *to)
{
    const int n = m->list->start[KIND_FLUID + 1], fluid = viscous_of(m)->fluid;

    THREADS(n > WORTH_THREADS, fluid_part(m, gamma, x, to));
    memcpy(to + n * DIM, x + n * DIM, (size_t)(fluid - n * DIM) * sizeof *to);
}

static void on_fluid(void *self, const double *x, double *to)
{
    const struct viscous_block *at = self;

    viscous_multiply(at->moment, KIND_BIT(KIND_FLUID) | KIND_BIT(KIND_SKIN), x, false);
    fluid_rows(at->moment, at->gamma, x, to);
}

/* Rows of a body, of its unknowns and the forces in work->f. */
static void on_body(void *self, const double *v, double *to)
{
    const struct viscous_block *at = self;
    struct moment_body *b = &at->moment->body[at->body];

    b->kind->role.coupled->inertia(b->body, b->work, at->gamma, v, to);
    solids_skin(at->moment, b);
    b->kind->role.coupled->pull(b->body, b->work, (const double (*)[DIM])b->force, -at->gamma, to);
}

static void on_body_solve(void *self, double *v)
{
    const struct viscous_block *at = self;
    const struct moment_body *b = &at->moment->body[at->body];

    b->kind->role.coupled->joined(b->body, b->work, v);
}

static double on_body_largest(void *self, const double *v)
{
    const struct viscous_block *at = self;
    const struct moment_body *b = &at->moment->body[at->body];

    return b->kind->role.coupled->fastest(b->body, v);
}

static void set_operator(struct moment *m, double gamma)
{
    struct viscous *u = viscous_of(m);
    const struct list *l = m->list;
    struct viscous_block *block = u->operator.block;
    double *diagonal = u->operator.diagonal;
    const int n = l->start[KIND_FLUID + 1];

    for (int s = 0; s < n; s++)
        diagonal[s] = m->particles->m[l->order[s]] + gamma * u->job.diagonal[s];
    for (int s = n; s < u->fluid / DIM; s++)
        diagonal[s] = 1;
    for (int i = -1; i < m->plan->bodies; i++)
        block[i + 1] = (struct viscous_block){ .moment = m, .gamma = gamma, .body = i };
    for (int i = 0; i < m->plan->bodies; i++)
        u->operator.body[i] = (struct operator_body){
            .self = &block[i + 1], .n = viscous_body(m->plan, i), .apply = on_body,
            .solve = on_body_solve, .largest = on_body_largest,
        };
    u->operator.all = (struct operator){
        .self = &block[0], .n = u->fluid, .width = DIM, .diagonal = diagonal,
        .bodies = m->plan->bodies, .body = u->operator.body, .apply = on_fluid,
    };
}

int viscous_assemble(struct moment *m, double gamma, const double *x, double *to)
{
    struct viscous *u = viscous_of(m);
    struct couple_job *const job = &u->job;

    spread(m, x, true);
    m->plan->engine->couple->assemble(job, m->work->record, u->velocity, m->work->f);
    m->counts.passes++;
    if (plan_face_implicit(m->plan)) {
        TRY(face_ready(m, job));
        face_complete(m, job, KIND_BIT(KIND_FLUID) | KIND_BIT(KIND_SKIN), true, m->work->f);
    }
    if (m->plan->bodies > 0)
        wet_take(m);
    set_operator(m, gamma);
    fluid_rows(m, gamma, x, to);
    for (int i = 0, at = u->fluid; i < m->plan->bodies; at += u->operator.body[i++].n)
        on_body(&u->operator.block[i + 1], x + at, to + at);
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
        TRY(b->kind->role.coupled->join(b->body, b->work, gamma, c));
    }
    return STATUS_DONE;
}
