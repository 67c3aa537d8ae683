/* viscous-kind.c -- a viscosity on the implicit side: what it goes with, and its rates. */
#include "implicit/viscous.h"

#include "base/status.h"
#include "eval/face.h"
#include "plan/solver.h"

#include <string.h>

static int agree(const struct plan *p)
{
    for (int i = 0; i < p->bodies && p->stiff; i++)
        if (!p->body[i].kind->role.coupled)
            return status_fail(STATUS_BAD_SCENE, "%s: a body of kind \"%s\" cannot be solved for "
                               "in one linear system with %s, which has side = \"implicit\"; set "
                               "side = \"explicit\", or take a beam with theory = \"linear\"",
                               p->body[i].path, p->body[i].kind->identity.name, p->stiff->path);
    return STATUS_DONE;
}

/* What follows from forces and power of the law; a step starts here. */
static void answer(struct moment *m, double t, const double *y, double *ydot)
{
    const double *mass = m->particles->m, *f = m->work->f;
    const struct plan *p = m->plan;
    double *book = ydot + layout_at(&m->layout, p->book.row);
    double (*udot)[DIM] = (double (*)[DIM])(ydot + layout_at(&m->layout, p->row.u));

    for (int i = 0; i < particles_count(m->particles, KIND_FLUID); i++) {
        const int s = m->list->slot[i];
        for (int d = 0; d < DIM && s >= 0; d++)
            udot[i][d] = f[(size_t)s * DIM + (size_t)d] / mass[i];
    }
    viscous_book(m, book);
    for (int i = 0; i < p->bodies; i++) {
        struct moment_body *b = &m->body[i];
        b->kind->role.coupled->yield(b->body, b->work, &m->layout, (const double (*)[DIM])b->force,
                                ydot, book + p->book.support + i * DIM);
    }
    viscous_begin(m, t, y);
}

static int rates(struct moment *m, double t, const double *y, double *ydot)
{
    TRY(rates_eval(m, &ASK_IMPLICIT_SIDE, t, y, ydot, NULL, NULL));
    answer(m, t, y, ydot);
    return STATUS_DONE;
}

static int sides(struct moment *m, double t, const double *y, double *explicit, double *implicit)
{
    const struct ask ask = { .sides = ASK_EXPLICIT | ASK_IMPLICIT };
    const struct viscous *u = viscous_of(m);
    struct workspace *w = m->work;
    double power = 0;

    TRY(rates_eval(m, &ask, t, y, explicit, u->apart, &power));
    memset(implicit, 0, (size_t)moment_size(m) * sizeof *implicit);
    memcpy(w->f, u->apart, (size_t)m->particles->n * DIM * sizeof *w->f);
    w->power[u->part->slot] = power;
    if (plan_face_implicit(m->plan))
        face_power(m);
    answer(m, t, y, implicit);
    return STATUS_DONE;
}

static void exact(void *self, double tol)
{
    struct viscous *u = self;

    u->tol = tol;
}

const struct plan_solver implicit_viscous = {
    .vectors = VISCOUS_VECTORS, .agree = agree, .create = viscous_create, .free = viscous_free,
    .forget = viscous_forget, .rates = rates, .sides = sides, .solve = viscous_solve,
    .exact = exact, .rearrange = viscous_rearrange,
};
