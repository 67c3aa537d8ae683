/* sheet.c -- what is stored at a moment, and what the book says of it. */
#include "book/book.h"
#include "plan/solver.h"

#include <assert.h>
#include <math.h>

static_assert(BOOK_WORKS >= PLAN_PARTS + 1 + 2 * INPUT_BODIES + CONTACTS_COLUMNS
              + 1 + PLAN_SOLVED_WORKS, "all works fit");

/* What is added up over particles. */
struct sums {
    struct energy_sums energy;
    struct exact_sum mass, momentum[DIM];
};

/* Kinetic energy of the fluid and its momentum. */
static void add_motion(const struct view *v, struct sums *s)
{
    const double *u = v->u[KIND_FLUID];
    struct exact_terms mass = { .to = &s->mass }, kinetic = { .to = &s->energy.kinetic };
    struct exact_terms momentum[DIM];

    for (int d = 0; d < DIM; d++)
        momentum[d] = (struct exact_terms){ .to = &s->momentum[d] };
    for (int i = 0; i < particles_count(v->p, KIND_FLUID); i++) {
        const double m = v->p->m[i];
        double u2 = 0;
        if (!view_has(v, i))
            continue;
        for (int d = 0; d < DIM; d++) {
            u2 += u[(size_t)i * DIM + d] * u[(size_t)i * DIM + d];
            exact_terms_add(&momentum[d], m * u[(size_t)i * DIM + d]);
        }
        exact_terms_add(&kinetic, 0.5 * m * u2);
        exact_terms_add(&mass, m);
    }
    exact_terms_end(&mass);
    exact_terms_end(&kinetic);
    for (int d = 0; d < DIM; d++)
        exact_terms_end(&momentum[d]);
}

/* Each rank has added up its own. */
static void share(struct sums *s)
{
    struct exact_sum *of[4 + DIM] = { &s->energy.kinetic, &s->energy.potential, &s->energy.internal,
                                      &s->mass };

    for (int d = 0; d < DIM; d++)
        of[4 + d] = &s->momentum[d];
    exact_sum_share(4 + DIM, of);
}

static void read_sums(const struct plan *p, const struct view *v, struct book_sheet *to)
{
    struct sums s = { 0 };

    add_motion(v, &s);
    for (int i = 0; i < p->parts; i++)
        if (p->part[i].part->energy)
            p->part[i].part->energy(p->part[i].self, v, &s.energy);
    if (v->mine)
        share(&s);
    to->energy.kinetic = exact_sum_value(&s.energy.kinetic);
    to->energy.potential = exact_sum_value(&s.energy.potential);
    to->energy.internal = exact_sum_value(&s.energy.internal);
    to->mass = exact_sum_value(&s.mass);
    for (int d = 0; d < DIM; d++)
        to->momentum[d] = exact_sum_value(&s.momentum[d]);
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
    read_sums(p, v, s);
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
