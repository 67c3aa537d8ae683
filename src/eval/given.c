/* given.c -- forces on solids in the last step, for methods that solve for a pressure. */
#include "eval/given.h"

#include "base/status.h"

#include <stdlib.h>
#include <string.h>

int given_make(struct moment *m)
{
    const size_t panels = (size_t)m->plan->book.panels,
                 all = (size_t)m->particles->objects + panels;

    given_free(&m->given);
    m->given = status_alloc(1, sizeof *m->given);
    if (!m->given)
        return STATUS_FAILED;
    m->given->force = status_alloc(all + 1, sizeof *m->given->force);
    m->given->turn = status_alloc(panels + 1, sizeof *m->given->turn);
    return m->given->force && m->given->turn ? STATUS_DONE : STATUS_FAILED;
}

void given_free(struct moment_given **given)
{
    if (!*given)
        return;
    free((*given)->force);
    free((*given)->turn);
    free(*given);
    *given = NULL;
}

void given_start(struct moment *m)
{
    const size_t panels = (size_t)m->plan->book.panels,
                 all = (size_t)m->particles->objects + panels;

    memcpy(m->given->force, m->force, all * sizeof *m->force);
    memcpy(m->given->turn, m->turn, panels * sizeof *m->turn);
    m->given->known = true;
}

static void add_impulse(struct moment *m, double h, int which, const double *impulse, double *book)
{
    for (int d = 0; d < DIM; d++) {
        m->given->force[which][d] += impulse[d] / h;
        book[m->plan->book.impulse + which * DIM + d] += impulse[d];
    }
}

static void add_panel(struct moment *m, double h, int panel, const double (*push)[DIM],
                      double *book)
{
    const struct plan_panel *p = &m->plan->book.panel[panel];
    double impulse[DIM] = { 0 }, turn[3] = { 0 };

    for (int k = 0; k < p->n; k++) {
        const int row = particles_row_of(m->particles, p->id[k]);
        for (int d = 0; d < DIM; d++)
            impulse[d] += push[p->id[k]][d];
        solids_turn(p->about, m->particles->x[row], push[p->id[k]], turn);
    }
    add_impulse(m, h, m->particles->objects + panel, impulse, book);
    for (int d = 0; d < 3; d++)
        m->given->turn[panel][d] += turn[d] / h;
}

void given_add(struct moment *m, double h, const double (*push)[DIM], double *book)
{
    const struct particles *all = m->particles;

    for (int i = 0; i < all->objects; i++) {
        const struct object *o = &all->object[i];
        double impulse[DIM] = { 0 };
        if (o->kind == KIND_FLUID)
            continue;
        for (int id = o->from; id < o->from + o->n; id++)
            for (int d = 0; d < DIM; d++)
                impulse[d] += push[id][d];
        add_impulse(m, h, i, impulse, book);
    }
    for (int i = 0; i < m->plan->book.panels; i++)
        add_panel(m, h, i, push, book);
}
