/* book.c -- mass, momentum and energy by name: quadratures that ride in y, and
 * what is stored at a moment. */
#include "plan/inside.h"

#include "base/status.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static_assert(PLAN_WORKS >= PLAN_PARTS + 1 + 2 * INPUT_BODIES, "all works fit");

/* Is there a field beside the weight? */
static bool pulls(const struct plan *p)
{
    for (int i = 0; i < p->parts; i++)
        if (p->part[i].part->as.force && !p->part[i].part->as.force->weight)
            return true;
    return false;
}

int plan_book_rows(struct plan *p)
{
    struct plan_book *b = &p->book;

    b->work = 0;
    b->walls = b->work + p->slots;
    b->damping = b->walls + 1;
    b->driven = b->damping + p->bodies;
    b->impulse = b->driven + p->bodies;
    b->support = b->impulse + p->particles->objects * DIM;
    b->applied = b->support + p->bodies * DIM;
    b->pull = b->applied + p->bodies * DIM;
    b->n = b->pull + (pulls(p) ? DIM : 0);
    b->row = layout_add(&p->layout, LAYOUT_OTHER, "book", "J", b->n, 1, 0);
    return b->row < 0 ? STATUS_FAILED : STATUS_DONE;
}

void book_rates(const struct moment *m, double *ydot)
{
    const struct plan *p = m->plan;
    double *book = ydot + layout_at(&m->layout, p->book.row);

    memset(book, 0, p->book.n * sizeof *book);
    for (int i = 0; i < p->slots; i++)
        book[p->book.work + i] = m->work->power[i];
    book[p->book.walls] = -m->wall_power;
    for (int i = 0; i < p->bodies; i++) {
        const struct body_load *load = &m->body[i].load;
        book[p->book.damping + i] = load->damping;
        book[p->book.driven + i] = load->driven;
        for (int d = 0; d < DIM; d++) {
            book[p->book.support + i * DIM + d] = load->support[d];
            book[p->book.applied + i * DIM + d] = load->applied[d];
        }
    }
    for (int i = p->book.pull; i < p->book.n; i++)
        book[i] = m->pull[i - p->book.pull];
    for (int o = 0; o < m->particles->objects; o++)
        for (int d = 0; d < DIM; d++)
            book[p->book.impulse + o * DIM + d] = m->force[o][d];
}

void moment_body_book(struct moment *m, double t, const double *y, double share, double *ydot)
{
    const struct plan *p = m->plan;
    double *book = ydot + layout_at(&m->layout, p->book.row);

    for (int i = 0; i < p->bodies; i++) {
        const struct moment_body *b = &m->body[i];
        struct body_load load;

        if (!plan_body_stiff(p, i)) /* moved by the right-hand sides themselves */
            continue;
        b->kind->load(b->body, b->work, &m->layout, t, y, (const double (*)[DIM])b->force,
                      m->work->rates, &load);
        book[p->book.damping + i] += share * load.damping;
        book[p->book.driven + i] += share * load.driven;
        for (int d = 0; d < DIM; d++) {
            book[p->book.support + i * DIM + d] += share * load.support[d];
            book[p->book.applied + i * DIM + d] += share * load.applied[d];
        }
    }
}

/* Kinetic energy of the fluid [J] and its momentum [kg m/s]. */
static double fluid_motion(const struct view *v, double *momentum)
{
    const int n = particles_count(v->p, KIND_FLUID);
    const double *u = v->u[KIND_FLUID];
    double kinetic = 0;

    for (int i = 0; i < n; i++)
        for (int d = 0; d < DIM; d++) {
            kinetic += 0.5 * v->p->m[i] * u[i * DIM + d] * u[i * DIM + d];
            momentum[d] += v->p->m[i] * u[i * DIM + d];
        }
    return kinetic;
}

static void read_works(const struct plan *p, const double *book, struct plan_sheet *s)
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
}

/* Momentum that came through walls, supports and gravity since the start. */
static void read_impulses(const struct plan *p, double t, const double *book, double mass,
                          struct plan_sheet *s)
{
    for (int d = 0; d < DIM; d++) {
        double given = mass * p->scales.g[d] * t;
        if (p->book.n > p->book.pull)
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

int plan_work_names(const struct plan *p, char (*name)[80])
{
    int n = 0;

    for (int i = 0; i < p->parts; i++)
        if (p->part[i].slot >= 0 && !part_conserves(p->part[i].part))
            snprintf(name[n++], 80, "%s", p->part[i].part->name);
    snprintf(name[n++], 80, "walls");
    for (int i = 0; i < p->bodies; i++) {
        snprintf(name[n++], 80, "%.60s.damping", p->body[i].name);
        snprintf(name[n++], 80, "%.60s.load", p->body[i].name);
    }
    return n;
}

void observe_sheet(struct moment *m, double t, const double *y, struct plan_sheet *s)
{
    const struct plan *p = m->plan;
    const double *book = y + layout_at(&m->layout, p->book.row);
    struct view v;

    observe_view(m, t, y, &v);
    *s = (struct plan_sheet){ .t = t };
    s->energy.kinetic = fluid_motion(&v, s->momentum);
    for (int i = 0; i < particles_count(v.p, KIND_FLUID); i++)
        s->mass += v.p->m[i];
    for (int i = 0; i < p->parts; i++)
        if (p->part[i].part->energy)
            p->part[i].part->energy(p->part[i].self, &v, &s->energy);
    for (int i = 0; i < p->bodies; i++) {
        double momentum[DIM] = {0};
        const struct moment_body *b = &m->body[i];
        b->kind->energy(b->body, b->work, &m->layout, y, &s->energy);
        b->kind->momentum(b->body, b->work, &m->layout, y, momentum);
        for (int d = 0; d < DIM; d++)
            s->momentum[d] += momentum[d];
    }
    read_works(p, book, s);
    read_impulses(p, t, book, s->mass, s);
    s->total = s->energy.kinetic + s->energy.potential + s->energy.internal + s->energy.elastic;
}
