/* viscous.c -- a viscosity on the implicit side: what it needs, and its rates. */
#include "plan/viscous.h"

#include "base/status.h"
#include "plan/face.h"
#include "scene/scene.h"
#include "space/laws.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double *numbers(size_t n)
{
    return status_alloc(n + 1, sizeof(double));
}

/* On cache lines. */
static double *lines(size_t n)
{
    const size_t bytes = (n * sizeof(double) + 63) / 64 * 64 + 64;
    double *to = aligned_alloc(64, bytes);

    if (to)
        memset(to, 0, bytes);
    else
        status_fail(STATUS_FAILED, "no memory for %zu MB of work arrays", bytes >> 20);
    return to;
}

static int take_memory(struct plan *p, struct viscous *u)
{
    const size_t n = (size_t)p->particles->n, all = (size_t)u->unknowns;
    double **vector[] = { &u->v, &u->right, &u->x, &u->residual, &u->guess, &u->guess_image };

    u->slots = n + 1;
    u->velocity = lines(u->slots * COUPLE_STRIDE);
    u->job.diagonal = numbers(n);
    u->job.firm = numbers(n);
    u->apart = numbers(n * DIM);
    u->stage = numbers((size_t)plan_size(p));
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
        if (!(u->velocity = lines(u->slots * COUPLE_STRIDE)))
            return STATUS_FAILED;
    }
    return STATUS_DONE;
}

bool viscous_faces(const struct plan *p)
{
    return p->face && p->face->part == p->stiff;
}

int viscous_make(struct plan *p)
{
    const struct plan_part *part = p->stiff;
    struct viscous *u;

    if (!part)
        return STATUS_DONE;
    u = p->viscous = status_alloc(1, sizeof *u);
    if (!u)
        return STATUS_FAILED;
    u->part = part;
    u->table = p->implicit;
    u->tol = p->in.set.tol;
    u->job = (struct couple_job){
        .list = p->main.list, .acts = part->part->acts, .couple = part->part->couple,
        .self = part->self, .needs = part->part->rows & ~(unsigned)NEED_V,
        .kernel = p->kernel[part->part->kernel],
    };
    u->fluid = particles_count(p->particles, KIND_FLUID) * DIM;
    u->unknowns = u->fluid;
    for (int i = 0; i < p->bodies; i++) {
        if (!p->body[i].kind->unknowns)
            return status_fail(STATUS_BAD_SCENE, "%s: theory = \"elastica\" is not linear, but %s "
                               "with side = \"implicit\" and the beams are solved as one linear "
                               "system; set side = \"explicit\", or theory = \"linear\"",
                               p->body[i].path, part->path);
        u->unknowns += p->body[i].kind->unknowns(p->body[i].body);
    }
    return take_memory(p, u);
}

void viscous_free(struct plan *p)
{
    struct viscous *u = p->viscous;

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
    p->viscous = NULL;
}

void viscous_book(struct plan *p, struct plan_workspace *w, double *book)
{
    const struct plan_book *b = &p->book;

    plan_solids_sum(p, w);
    for (int i = 0; i < b->n; i++)
        book[i] = 0;
    book[b->work + p->viscous->part->slot] = w->power[p->viscous->part->slot];
    book[b->walls] = -p->wall_power;
    for (int o = 0; o < p->particles->objects; o++)
        for (int d = 0; d < DIM; d++)
            book[b->impulse + o * DIM + d] = p->force[o][d];
    for (int i = 0; i < p->bodies; i++)
        plan_skin_force(p, w, &p->body[i]);
}

/* What follows from forces and power of the law; a step starts here. */
static void spread_rates(struct plan *p, double t, const double *y, double *ydot)
{
    const double *m = p->particles->m;
    double *book = ydot + layout_at(&p->layout, p->book.row);
    double (*udot)[DIM] = (double (*)[DIM])(ydot + layout_at(&p->layout, p->row_u));
    struct plan_workspace *w = &p->main;

    for (int i = 0; i < particles_count(p->particles, KIND_FLUID); i++) {
        const int s = w->list->slot[i];
        for (int d = 0; d < DIM && s >= 0; d++)
            udot[i][d] = w->f[(size_t)s * DIM + (size_t)d] / m[i];
    }
    viscous_book(p, w, book);
    for (int i = 0; i < p->bodies; i++) {
        struct plan_body *b = &p->body[i];
        b->kind->yield(b->body, &p->layout, (const double (*)[DIM])b->force, ydot,
                       book + p->book.support + i * DIM);
    }
    viscous_begin(p, t, y);
}

int viscous_rates(struct plan *p, double t, const double *y, double *ydot)
{
    struct view v;

    plan_view_make(p, t, y, &v);
    TRY(plan_fields(p, &p->main, &v));
    TRY(plan_sum(p, &p->main, p->viscous->table, NULL, (struct sum_rates){ 0 }));
    spread_rates(p, t, y, ydot);
    return STATUS_DONE;
}

int viscous_sides(struct plan *p, double t, const double *y, double *explicit, double *implicit)
{
    struct plan_workspace *w = &p->main;
    int status;

    w->apart = p->viscous->apart;
    status = plan_rates(p, w, PLAN_EXPLICIT, t, y, explicit);
    w->apart = NULL;
    TRY(status);
    memset(implicit, 0, (size_t)plan_size(p) * sizeof *implicit);
    memcpy(w->f, p->viscous->apart, (size_t)p->particles->n * DIM * sizeof *w->f);
    w->power[p->viscous->part->slot] = w->power_apart;
    if (viscous_faces(p))
        face_power(p, w);
    spread_rates(p, t, y, implicit);
    return STATUS_DONE;
}
