/* viscous.c -- a viscosity on the implicit side: what it works in, and its book. */
#include "implicit/viscous.h"

#include "base/status.h"
#include "space/laws.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double *numbers(size_t n)
{
    return status_alloc(n + 1, sizeof(double));
}

static int take_memory(const struct moment *m, struct viscous *u)
{
    const size_t n = (size_t)m->particles->n, all = (size_t)u->unknowns;
    double **vector[] = { &u->v, &u->right, &u->x, &u->residual, &u->guess, &u->guess_image };

    u->slots = n + 1;
    u->velocity = workspace_lines(u->slots * COUPLE_STRIDE);
    u->job.diagonal = numbers(n);
    u->job.firm = numbers(n);
    u->apart = numbers(n * DIM);
    u->stage = numbers((size_t)moment_size(m));
    u->partial = numbers(all / 1024);
    u->operator.diagonal = numbers((size_t)u->fluid / DIM);
    u->operator.block = status_alloc((size_t)m->plan->bodies + 1, sizeof *u->operator.block);
    u->operator.body = status_alloc((size_t)m->plan->bodies + 1, sizeof *u->operator.body);
    for (int d = 0; d < DIM; d++)
        if (!(u->drag[d] = numbers(all - (size_t)u->fluid)))
            return STATUS_FAILED;
    if (!u->velocity || !u->job.diagonal || !u->job.firm || !u->apart || !u->stage || !u->partial
        || !u->operator.diagonal || !u->operator.block || !u->operator.body)
        return STATUS_FAILED;
    for (size_t i = 0; i < sizeof vector / sizeof vector[0]; i++)
        if (!(*vector[i] = numbers(all)))
            return STATUS_FAILED;
    for (int i = 0; i < VISCOUS_STARTS + VISCOUS_STAGES; i++) {
        struct viscous_past *to = i < VISCOUS_STARTS ? &u->known.start[i]
                                                     : &u->known.past[i - VISCOUS_STARTS];
        if (!(to->v = numbers(all)))
            return STATUS_FAILED;
    }
    return operator_solver_create(u->unknowns, VISCOUS_PRODUCTS, &u->solver);
}

int viscous_fit(struct viscous *u)
{
    const struct list *l = u->job.list;
    const size_t want = (size_t)l->rows_before[l->groups] * (size_t)l->lanes;
    const size_t slots = (size_t)l->listed + 1;

    if (want > u->room) {
        double *c = realloc(u->job.c, (want + want / 4) * sizeof *c);
        if (!c)
            return status_starved("the coefficients of %s cannot be kept", u->part->path);
        u->job.c = c;
        u->room = want + want / 4;
    }
    if (slots > u->slots) {
        free(u->velocity);
        u->slots = slots + slots / 8;
        if (!(u->velocity = workspace_lines(u->slots * COUPLE_STRIDE)))
            return STATUS_FAILED;
    }
    return STATUS_DONE;
}

int viscous_create(struct moment *m, void **out)
{
    const struct plan *p = m->plan;
    const struct plan_part *part = p->stiff;
    struct viscous *u = *out = status_alloc(1, sizeof *u);

    if (!u)
        return STATUS_FAILED;
    u->part = part;
    u->tol = p->in.set.tol;
    u->job = (struct couple_job){
        .list = m->own, .acts = part->part->as.law->acts,
        .couple = part->part->as.operator->couple, .self = part->self,
        .needs = part->part->as.law->rows & ~(unsigned)NEED_V,
        .kernel = p->kernel[part->part->as.law->kernel],
    };
    u->fluid = particles_count(p->particles, KIND_FLUID) * DIM;
    u->unknowns = u->fluid;
    for (int i = 0; i < p->bodies; i++)
        u->unknowns += viscous_body(p, i);
    return take_memory(m, u);
}

void viscous_free(void **self)
{
    struct viscous *u = *self;

    if (!u)
        return;
    for (int i = 0; i < VISCOUS_STARTS; i++)
        free(u->known.start[i].v);
    for (int i = 0; i < VISCOUS_STAGES; i++)
        free(u->known.past[i].v);
    double *const memory[] = { u->job.c, u->job.diagonal, u->job.firm, u->apart, u->velocity,
                               u->stage, u->partial, u->v, u->right, u->x, u->residual, u->guess,
                               u->guess_image, u->operator.diagonal };
    for (size_t i = 0; i < sizeof memory / sizeof memory[0]; i++)
        free(memory[i]);
    for (int d = 0; d < DIM; d++)
        free(u->drag[d]);
    free(u->operator.block);
    free(u->operator.body);
    operator_solver_free(&u->solver);
    free(u);
    *self = NULL;
}

void viscous_book(struct moment *m, double *book)
{
    const struct plan_book *b = &m->plan->book;
    const int slot = viscous_of(m)->part->slot;

    wet_take(m);
    solids_sum(m);
    for (int i = 0; i < b->n; i++)
        book[i] = 0;
    book[b->work + slot] = m->work->power[slot];
    book[b->walls] = -m->wall_power;
    for (int o = 0; o < m->particles->objects + m->plan->book.panels; o++)
        for (int d = 0; d < DIM; d++)
            book[b->impulse + o * DIM + d] = m->force[o][d];
    for (int i = 0; i < m->plan->bodies; i++)
        solids_skin(m, &m->body[i]);
}
