/* sheet.c -- what is stored at a moment, and what the book says of it. */
#include "book/book.h"
#include "plan/solver.h"

#include <assert.h>
#include <math.h>

static_assert(BOOK_WORKS >= PLAN_PARTS + 1 + 2 * INPUT_BODIES + CONTACTS_COLUMNS
              + 1 + PLAN_SOLVED_WORKS, "all works fit");

/* Kinetic energy of the fluid [J] and its momentum [kg m/s]. */
static double fluid_motion(const struct view *v, double *momentum)
{
    const int n = particles_count(v->p, KIND_FLUID);
    const double *u = v->u[KIND_FLUID];
    double kinetic = 0;

    for (int id = 0; id < n; id++)
        for (int d = 0, i = particles_row(v->p, KIND_FLUID, id); d < DIM; d++) {
            kinetic += 0.5 * v->p->m[i] * u[i * DIM + d] * u[i * DIM + d];
            momentum[d] += v->p->m[i] * u[i * DIM + d];
        }
    return kinetic;
}

static void read_works(const struct plan *p, const double *book, struct book_sheet *s)
{
    for (int i = 0; i < p->parts; i++) {
        if (p->part[i].slot < 0)
            continue;
        if (part_conserves(p->part[i].part))
            s->pressure_defect += book[p->book.work + p->part[i].slot];
        else
            s->work[s->works++] = book[p->book.work + p->part[i].slot];
    }
    s->work[s->works++] = book[p->book.walls];
    for (int i = 0; i < p->bodies; i++) {
        s->work[s->works++] = book[p->book.damping + i];
        s->work[s->works++] = book[p->book.driven + i];
    }
    for (int i = 0; i < p->contacts.columns; i++)
        s->work[s->works++] = book[p->book.contacts + i];
    for (int i = p->book.dissipated; i < p->book.solved; i++)
        s->work[s->works++] = book[i];
    for (int i = 0; i < p->book.solved_works; i++)
        s->work[s->works++] = book[p->book.solved + i];
}

/* Momentum that came through walls, supports and gravity since the start. */
static void read_impulses(const struct plan *p, double t, const double *book, double mass,
                          struct book_sheet *s)
{
    for (int d = 0; d < DIM; d++) {
        double given = mass * p->scales.g[d] * t;
        if (p->book.contacts > p->book.pull)
            given += book[p->book.pull + d];
        for (int o = 0; o < p->particles->objects; o++)
            if (p->particles->object[o].kind != KIND_FLUID)
                given -= book[p->book.impulse + o * DIM + d];
        for (int i = 0; i < p->bodies; i++) {
            const struct plan_body *b = &p->body[i];
            given += book[p->book.support + i * DIM + d] + book[p->book.applied + i * DIM + d]
                   + b->kind->weight(b->body) * p->scales.g[d] * t;
            if (b->object >= 0)
                given += book[p->book.impulse + b->object * DIM + d];
        }
        s->momentum_given[d] = given;
    }
}

static void read_bodies(const struct plan *p, const struct layout *l,
                        const struct moment_body *body, const double *y, struct book_sheet *s)
{
    for (int i = 0; i < p->bodies; i++) {
        const struct moment_body *b = &body[i];
        double momentum[DIM] = { 0 };

        b->kind->energy(b->body, b->work, l, y, &s->energy);
        b->kind->momentum(b->body, b->work, l, y, momentum);
        for (int d = 0; d < DIM; d++)
            s->momentum[d] += momentum[d];
    }
}

void book_read(const struct plan *p, const struct layout *l, const struct moment_body *body,
               const struct view *v, const double *y, struct book_sheet *s)
{
    const double *book = y + layout_at(l, p->book.row);

    *s = (struct book_sheet){ .t = v->t };
    s->energy.kinetic = fluid_motion(v, s->momentum);
    for (int id = 0; id < particles_count(v->p, KIND_FLUID); id++)
        s->mass += v->p->m[particles_row(v->p, KIND_FLUID, id)];
    for (int i = 0; i < p->parts; i++)
        if (p->part[i].part->energy)
            p->part[i].part->energy(p->part[i].self, v, &s->energy);
    read_bodies(p, l, body, y, s);
    read_works(p, book, s);
    read_impulses(p, v->t, book, s->mass, s);
    s->total = s->energy.kinetic + s->energy.potential + s->energy.internal + s->energy.elastic;
}

double book_defect(const struct book_sheet *first, const struct book_sheet *now)
{
    double given = now->pressure_defect - first->pressure_defect;

    for (int i = 0; i < now->works; i++)
        given += now->work[i] - first->work[i];
    return now->total - first->total - given;
}

double book_momentum_defect(const struct book_sheet *first, const struct book_sheet *now)
{
    double worst = 0;

    for (int d = 0; d < DIM; d++)
        worst = fmax(worst, fabs(now->momentum[d] - first->momentum[d] - now->momentum_given[d]
                                 + first->momentum_given[d]));
    return worst;
}
