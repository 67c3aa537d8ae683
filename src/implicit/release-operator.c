/* release-operator.c -- both sides of (R1): what drives the divergence, and what a pressure
 * does against it. */
#include "implicit/release-inside.h"

#include "base/status.h"

#include <string.h>

/* Images have what their originals have, the dummy nothing. */
static void complete(const struct release *r, int width, double *v)
{
    const struct list *l = r->m->list;

    for (int s = r->n; s < l->listed; s++)
        memcpy(v + (size_t)s * (size_t)width, v + (size_t)l->slot[l->order[s]] * (size_t)width,
               (size_t)width * sizeof *v);
    memset(v + (size_t)l->listed * (size_t)width, 0, (size_t)width * sizeof *v);
}

static void diverge(struct release *r, double *to)
{
    complete(r, NABLA_STRIDE, r->vector);
    r->nabla->divergence(&r->job, r->kinds, r->vector, to);
}

/* --- bodies ---------------------------------------------------------------------- */

static bool yields(const struct moment_body *b)
{
    return b->kind->role.coupled && b->skin > 0;
}

static int place(const struct moment *m, const struct moment_body *b, int j)
{
    return m->list->slot[particles_row_of(m->particles, m->particles->object[b->object].from + j)];
}

/* The skin moves with these modes, solved for by B = M + tau D + tau^2 K: those of the
 * body that are slower than sound yield by their mass, stiff ones hardly. */
static void move_skin(struct release *r, struct moment_body *b)
{
    double (*point)[DIM] = r->m->work->points;

    b->kind->role.coupled->joined(b->body, b->work, r->modes);
    b->kind->role.coupled->drift(b->body, r->modes, point);
    for (int j = 0; j < b->skin; j++) {
        const int s = place(r->m, b, j);
        if (s >= 0)
            memcpy(r->vector + (size_t)s * NABLA_STRIDE, point[j], sizeof point[j]);
    }
}

/* By the pressure's forces, in work->f. */
static void push_body(struct release *r, struct moment_body *b)
{
    memset(r->modes, 0, (size_t)b->kind->role.coupled->unknowns(b->body) * sizeof *r->modes);
    solids_skin(r->m, b);
    b->kind->role.coupled->pull(b->body, b->work, (const double (*)[DIM])b->force, 1, r->modes);
    move_skin(r, b);
}

/* By all other forces: M times the rates that they give.  Makes B ready. */
static int drive_body(struct release *r, struct moment_body *b)
{
    const struct body_coupled *c = b->kind->role.coupled;
    const int n = c->unknowns(b->body);
    double (*point)[DIM] = r->m->work->points;

    memset(point, 0, (size_t)b->skin * sizeof *point); /* nothing is joined but B */
    TRY(c->join(b->body, b->work, r->tau, point[0]));
    c->read(b->body, &r->m->layout, r->ydot, r->modes + n);
    c->inertia(b->body, b->work, 0, r->modes + n, r->modes);
    move_skin(r, b);
    return STATUS_DONE;
}

/* --- the operator ---------------------------------------------------------------- */

void release_multiply(struct release *r, const double *x, double *to)
{
    struct moment *m = r->m;
    const struct list *l = m->list;

    memcpy(r->scalar, x, (size_t)r->n * sizeof *x);
    complete(r, 1, r->scalar);
    r->nabla->gradient(&r->job, r->kinds & ~(KIND_BIT(KIND_WALL) | KIND_BIT(KIND_WALL_SLIP)),
                       r->scalar, m->work->f);
    wet_take(m);
    memset(r->vector, 0, (size_t)r->n * NABLA_STRIDE * sizeof *r->vector);
    for (int s = 0; s < r->fluid; s++)
        for (int d = 0; d < DIM; d++)
            r->vector[(size_t)s * NABLA_STRIDE + (size_t)d]
                = m->work->f[(size_t)s * DIM + (size_t)d] / m->particles->m[l->order[s]];
    for (int i = 0; i < m->plan->bodies; i++)
        if (yields(&m->body[i]))
            push_body(r, &m->body[i]);
    diverge(r, to);
}

void release_extend(struct release *r, double *x)
{
    const unsigned solids = r->kinds & KIND_SOLIDS;

    if (!solids)
        return;
    memcpy(r->scalar, x, (size_t)r->fluid * sizeof *x);
    memset(r->scalar + r->fluid, 0, (size_t)(r->n - r->fluid) * sizeof *x);
    complete(r, 1, r->scalar);
    r->nabla->squares(&r->beside, solids, r->scalar, x);
    for (int s = r->fluid; s < r->n; s++)
        x[s] = r->weight[s] > 0 ? x[s] / r->weight[s] : 0;
}

void release_gather(struct release *r, double *x)
{
    double *back = r->m->work->f;

    if (!(r->kinds & KIND_SOLIDS))
        return;
    memset(r->scalar, 0, (size_t)r->fluid * sizeof *x);
    for (int s = r->fluid; s < r->n; s++)
        r->scalar[s] = r->weight[s] > 0 ? x[s] / r->weight[s] : 0;
    complete(r, 1, r->scalar);
    r->nabla->squares(&r->beside, KIND_BIT(KIND_FLUID), r->scalar, back);
    for (int s = 0; s < r->fluid; s++)
        x[s] += back[s];
}

/* (E/tau^2 + A) x, and E/tau^2 alone where the fluid parts. */
static void apply(void *self, const double *x, double *to)
{
    struct release *r = self;

    for (int s = 0; s < r->fluid; s++)
        r->solve.scratch[s] = r->parts[s] ? 0 : x[s];
    release_extend(r, r->solve.scratch);
    release_multiply(r, r->solve.scratch, r->solve.image);
    release_gather(r, r->solve.image);
    for (int s = 0; s < r->fluid; s++)
        to[s] = r->still[s] * x[s] + (r->parts[s] ? 0 : r->solve.image[s]);
}

/* What solids weigh the fluid around them with, in all. */
static void set_weights(struct release *r)
{
    for (int s = 0; s < r->n; s++)
        r->scalar[s] = s < r->fluid;
    complete(r, 1, r->scalar);
    r->nabla->squares(&r->beside, r->kinds, r->scalar, r->weight);
}

/* The diagonal of (E/tau^2 + A), without what bodies add. */
static void set_diagonal(struct release *r)
{
    const struct list *l = r->m->list;
    double *ones = r->scalar, *squares = r->solve.scratch, *sum = r->m->work->f;

    for (int s = 0; s < r->n; s++)
        ones[s] = 0.5;
    complete(r, 1, ones);
    r->nabla->gradient(&r->job, r->kinds, ones, sum);
    for (int s = 0; s < r->n; s++)
        ones[s] = s < r->fluid ? 1 / r->m->particles->m[l->order[s]] : 0;
    complete(r, 1, ones);
    r->nabla->squares(&r->job, r->kinds, ones, squares);
    for (int s = 0; s < r->fluid; s++) {
        double square = 0;
        for (int d = 0; d < DIM; d++)
            square += sum[(size_t)s * DIM + (size_t)d] * sum[(size_t)s * DIM + (size_t)d];
        r->diagonal[s] = r->still[s] + ones[s] * square + squares[s];
    }
}

static void set_operator(struct release *r)
{
    const struct list *l = r->m->list;
    const double e = r->eos->rho0 / (r->eos->c0 * r->tau);

    for (int s = 0; s < r->fluid; s++)
        r->still[s] = r->m->particles->m[l->order[s]] * e * e;
    set_weights(r);
    set_diagonal(r);
    r->solve.operator = (struct operator){ .self = r, .n = r->fluid, .width = 1,
                                           .diagonal = r->diagonal, .apply = apply };
}

/* --- what drives it -------------------------------------------------------------- */

/* Accelerations of the particles of kind k by all but the pressure. */
static void drive_kind(struct release *r, int k)
{
    const struct particles *all = r->m->particles;
    const struct list *l = r->m->list;
    const double *udot = r->ydot + layout_at(&r->m->layout, r->m->plan->row.u);

    for (int s = l->start[k]; s < l->start[k + 1]; s++) {
        const int c = l->order[s];
        double *to = r->vector + (size_t)s * NABLA_STRIDE;
        if (k == KIND_FLUID)
            memcpy(to, udot + (size_t)c * DIM, DIM * sizeof *to);
        else if (k == KIND_WALL || k == KIND_WALL_SLIP)
            object_acceleration(&all->object[all->object_of[c]], all->x[c], to);
    }
}

static int drive_bodies(struct release *r)
{
    const struct moment *m = r->m;

    for (int i = 0; i < m->plan->bodies; i++)
        if (yields(&m->body[i]))
            TRY(drive_body(r, &m->body[i]));
    return STATUS_DONE;
}

int release_assemble(struct release *r, const double *y)
{
    struct moment *m = r->m;
    const struct ask others = { .sides = ASK_EXPLICIT | ASK_IMPLICIT, .without_pressure = true };

    if (moment_eval(m, others, 0, y, r->ydot) != STATUS_DONE)
        return status_fail(STATUS_FAILED, "the start: %s", moment_refusal(m));
    memset(r->vector, 0, (size_t)r->n * NABLA_STRIDE * sizeof *r->vector);
    for (int k = 0; k < KINDS; k++)
        drive_kind(r, k);
    TRY(moment_agree(m, drive_bodies(r)));
    diverge(r, r->drive);
    set_operator(r);
    return STATUS_DONE;
}
