/* push.c -- what follows from forces: drift, solids and bodies, the book. */
#include "eval/share.h"

#include "base/status.h"

#include <string.h>

/* --- the fluid ------------------------------------------------------------------- */

/* Positions move with more than the velocity. */
static void add_drift(const struct moment *m, const struct view *v, double *ydot)
{
    double (*xdot)[DIM] = (double (*)[DIM])(ydot + layout_at(&m->layout, m->plan->row.x));

    for (int i = 0; i < particles_count(v->p, KIND_FLUID); i++)
        for (int d = 0; d < DIM; d++)
            xdot[i][d] += m->work->drift[i][d];
}

/* What a drift against the weight gives [W]. */
static double drift_power(const struct moment *m, const struct view *v)
{
    const double *g = m->plan->scales.g;
    double power = 0;

    for (int id = 0; id < particles_count(v->p, KIND_FLUID); id++) {
        const int i = particles_row(v->p, KIND_FLUID, id);
        for (int d = 0; d < DIM; d++)
            power -= v->p->m[i] * g[d] * m->work->drift[i][d];
    }
    return power;
}

int passes_drift(struct evaluation *e, const struct plan_field *of)
{
    (void)of;
    add_drift(e->m, &e->view, e->ydot);
    e->m->work->power[e->m->plan->drifter->slot] = drift_power(e->m, &e->view);
    return STATUS_DONE;
}

/* --- solids and bodies ------------------------------------------------------------ */

int passes_solid_pairs(struct evaluation *e, const struct plan_field *of)
{
    (void)of;
    wet_take(e->m);
    if (e->m->share && !e->m->share->full)
        share_forces(e);
    return STATUS_DONE;
}

int passes_solids(struct evaluation *e, const struct plan_field *of)
{
    (void)of;
    solids_sum(e->m);
    return STATUS_DONE;
}

int passes_skins(struct evaluation *e, const struct plan_field *of)
{
    (void)of;
    for (int i = 0; i < e->m->plan->bodies; i++)
        solids_skin(e->m, &e->m->body[i]);
    return STATUS_DONE;
}

int passes_load(struct evaluation *e, const struct plan_field *of)
{
    (void)of;
    for (int i = 0; i < e->m->plan->bodies; i++)
        touching_load(e->m, i, e->t, e->y, e->ydot, &e->m->body[i].load);
    return STATUS_DONE;
}

/* --- the book --------------------------------------------------------------------- */

int passes_book(struct evaluation *e, const struct plan_field *of)
{
    const struct moment *m = e->m;
    const struct book_powers powers = {
        .work = m->work->power, .walls = m->wall_power, .pull = m->pull,
        .force = (const double (*)[DIM])m->force, .body = m->body, .contacts = m->meeting.power,
        .dissipated = m->work->power + m->plan->slots,
    };

    (void)of;
    book_rates(m->plan, &powers, e->ydot + layout_at(&m->layout, m->plan->book.row));
    return STATUS_DONE;
}

int passes_half_book(struct evaluation *e, const struct plan_field *of)
{
    const struct plan_book *b = &e->m->plan->book;
    double *book = e->ydot + layout_at(&e->m->layout, b->row);

    (void)of;
    memset(book, 0, (size_t)b->n * sizeof *book);
    for (int i = 0; i < e->m->plan->slots; i++)
        book[b->work + i] = e->m->work->power[i];
    return STATUS_DONE;
}
