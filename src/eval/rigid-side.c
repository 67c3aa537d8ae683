/* rigid-side.c -- contacts, and rigid bodies with these as a side of f by themselves: all but
 * what the fluid does to them. */
#include "eval/passes.h"

#include "base/status.h"

#include <string.h>

const char *moment_rigid_lacks(const struct plan *p)
{
    int rigid = 0;

    for (int i = 0; i < p->bodies; i++)
        rigid += plan_body_rigid(p, i);
    if (rigid < p->bodies)
        return "it steps rigid bodies apart from the water, and this scene has a beam: use imex3";
    if (rigid == 0)
        return "it steps rigid bodies apart from the water, and this scene has none: use cks43";
    if (p->in.fluids == 0)
        return "its steps follow the sound in the water, and this scene has no water: use cks43";
    if (p->contacts.columns > 2)
        return "uplift pushes at contacts with the forces of the water, which bodies do not know in "
               "steps of their own: use cks43, or leave out uplift";
    return NULL;
}

/* A row of a body, of what contacts remember, or of the book. */
static bool moves_with_bodies(const struct plan *p, const struct layout_row *r, int row)
{
    if (row == p->book.row || strncmp(r->name, "contacts.", strlen("contacts.")) == 0)
        return true;
    for (int i = 0; i < p->bodies; i++) {
        const size_t n = strlen(p->body[i].path);
        if (strncmp(r->name, p->body[i].path, n) == 0 && r->name[n] == '.')
            return true;
    }
    return false;
}

int moment_rigid_ranges(const struct moment *m, int most, long (*range)[2])
{
    int n = 0;

    for (int i = 0; i < m->layout.rows && n < most; i++) {
        const struct layout_row *r = &m->layout.row[i];
        if (!moves_with_bodies(m->plan, r, i))
            continue;
        range[n][0] = r->offset;
        range[n++][1] = r->offset + (long)r->n * r->components;
    }
    return n;
}

static int meet(struct moment *m, double t, const double *y, double *ydot)
{
    const struct plan_contacts *c = &m->plan->contacts;
    struct contacts_moment now;

    if (!c->kind)
        return STATUS_DONE;
    now = touching_now(m, t, y);
    now.ydot = ydot;
    TRY(c->kind->meet(c->self, &now, m->refusal, sizeof m->refusal));
    for (int i = 0; i < m->plan->bodies; i++)
        if (m->body[i].kind->role.solid)
            m->body[i].kind->role.solid->push(m->body[i].work, &m->meeting.body[i].push);
    return STATUS_DONE;
}

int passes_contacts(struct evaluation *e, const struct plan_field *of)
{
    (void)of;
    return meet(e->m, e->t, e->y, e->ydot);
}

int moment_rigid(struct moment *m, double t, const double *y, double *ydot)
{
    const struct plan *p = m->plan;
    double *book = ydot + layout_at(&m->layout, p->book.row);

    m->counts.rhs_implicit++;
    TRY(meet(m, t, y, ydot));
    memset(book, 0, (size_t)p->book.n * sizeof *book);
    for (int i = 0; i < p->bodies; i++) {
        const struct moment_body *b = &m->body[i];
        struct body_load load;
        b->kind->load(b->body, b->work, &m->layout, t, y, NULL, ydot, &load);
        book_add_load(p, i, 1, &load, book);
    }
    for (int i = 0; i < p->contacts.columns; i++)
        book[p->book.contacts + i] = m->meeting.power[i];
    return STATUS_DONE;
}
