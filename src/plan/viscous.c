/* viscous.c -- a viscosity on the implicit side: what it needs, and its rates. */
#include "plan/viscous.h"

#include "base/status.h"
#include "plan/face.h"
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
    u->partial = numbers(all);
    for (int d = 0; d < DIM; d++)
        if (!(u->drag[d] = numbers(all - (size_t)u->fluid)))
            return STATUS_FAILED;
    if (!u->velocity || !u->job.diagonal || !u->job.firm || !u->apart || !u->stage || !u->partial)
        return STATUS_FAILED;
    for (size_t i = 0; i < sizeof vector / sizeof vector[0]; i++)
        if (!(*vector[i] = numbers(all)))
            return STATUS_FAILED;
    for (int i = 0; i < VISCOUS_STARTS + VISCOUS_STAGES; i++) {
        struct viscous_past *to = i < VISCOUS_STARTS ? &u->start[i] : &u->past[i - VISCOUS_STARTS];
        if (!(to->v = numbers(all)))
            return STATUS_FAILED;
    }
    return viscous_gradients_make(u);
}

int viscous_fit(struct viscous *u)
{
    const struct list *l = u->job.list;
    const size_t want = (size_t)l->rows_before[l->groups] * (size_t)l->lanes;
    const size_t slots = (size_t)l->listed + 1;

    if (want > u->room) {
        double *c = realloc(u->job.c, (want + want / 4) * sizeof *c);
        if (!c)
            return status_fail(STATUS_FAILED, "no memory for the coefficients of %s",
                               u->part->path);
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

bool viscous_faces(const struct plan *p)
{
    return p->face && p->face->part == p->stiff;
}

int viscous_agree(const struct plan *p)
{
    for (int i = 0; i < p->bodies && p->stiff; i++)
        if (!p->body[i].kind->coupled)
            return status_fail(STATUS_BAD_SCENE, "%s: theory = \"elastica\" is not linear, but %s "
                               "with side = \"implicit\" and the beams are solved as one linear "
                               "system; set side = \"explicit\", or theory = \"linear\"",
                               p->body[i].path, p->stiff->path);
    return STATUS_DONE;
}

int viscous_create(struct moment *m)
{
    const struct plan *p = m->plan;
    const struct plan_part *part = p->stiff;
    struct viscous *u;

    if (!part)
        return STATUS_DONE;
    u = m->viscous = status_alloc(1, sizeof *u);
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

void viscous_free(struct viscous **viscous)
{
    struct viscous *u = *viscous;

    if (!u)
        return;
    for (int i = 0; i < VISCOUS_STARTS; i++)
        free(u->start[i].v);
    for (int i = 0; i < VISCOUS_STAGES; i++)
        free(u->past[i].v);
    double *const memory[] = { u->job.c, u->job.diagonal, u->job.firm, u->apart, u->velocity,
                               u->stage, u->partial, u->v, u->right, u->x, u->residual, u->guess,
                               u->guess_image };
    for (size_t i = 0; i < sizeof memory / sizeof memory[0]; i++)
        free(memory[i]);
    for (int d = 0; d < DIM; d++)
        free(u->drag[d]);
    viscous_gradients_free(u);
    free(u);
    *viscous = NULL;
}

void viscous_book(struct moment *m, double *book)
{
    const struct plan_book *b = &m->plan->book;
    const int slot = m->viscous->part->slot;

    rates_of_solids(m);
    for (int i = 0; i < b->n; i++)
        book[i] = 0;
    book[b->work + slot] = m->work->power[slot];
    book[b->walls] = -m->wall_power;
    for (int o = 0; o < m->particles->objects; o++)
        for (int d = 0; d < DIM; d++)
            book[b->impulse + o * DIM + d] = m->force[o][d];
    for (int i = 0; i < m->plan->bodies; i++)
        rates_of_skin(m, &m->body[i]);
}

/* What follows from forces and power of the law; a step starts here. */
static void spread_rates(struct moment *m, double t, const double *y, double *ydot)
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
        b->kind->coupled->yield(b->body, b->work, &m->layout, (const double (*)[DIM])b->force,
                                ydot, book + p->book.support + i * DIM);
    }
    viscous_begin(m, t, y);
}

int viscous_rates(struct moment *m, double t, const double *y, double *ydot)
{
    const struct rates_job job = { .table = m->plan->table.implicit };
    struct view v;

    moment_view(m, t, y, &v);
    TRY(moment_fields(m, &v));
    TRY(rates_sum(m, &job));
    spread_rates(m, t, y, ydot);
    return STATUS_DONE;
}

int viscous_sides(struct moment *m, double t, const double *y, double *explicit, double *implicit)
{
    const struct ask ask = { .sides = ASK_EXPLICIT | ASK_IMPLICIT };
    const struct viscous *u = m->viscous;
    struct workspace *w = m->work;
    double power = 0;

    TRY(rates_eval(m, &ask, t, y, explicit, u->apart, &power));
    memset(implicit, 0, (size_t)moment_size(m) * sizeof *implicit);
    memcpy(w->f, u->apart, (size_t)m->particles->n * DIM * sizeof *w->f);
    w->power[u->part->slot] = power;
    if (viscous_faces(m->plan))
        face_power(m);
    spread_rates(m, t, y, implicit);
    return STATUS_DONE;
}
