/* rates.c -- the explicit side of the right-hand side: a short list of passes. */
#include "eval/inside.h"

#include "base/status.h"
#include "eval/face.h"

#include <string.h>

int rates_sum(struct moment *m, const struct rates_job *of)
{
    const struct plan *p = m->plan;
    const bool faces = m->face && face_among(p, of->table);
    struct workspace *w = m->work;
    const struct sum_job job = {
        .list = m->list, .record = w->record, .table = of->table, .slots = p->slots,
        .later = of->ahead, .push = (const double (*)[DIM])of->push,
        .moduli = of->table == p->table.velocities ? NULL : p->in.pressure->as.pressure->moduli,
        .eos = p->pressure ? p->pressure->self : p->in.pressure_self,
        .f = w->f, .drho = w->drho, .power = w->power, .rates = of->to,
        .apart = of->apart, .apart_slot = of->apart ? p->stiff->slot : 0,
    };

    if (m->face)
        m->face->power = 0;
    if (faces)
        TRY(face_find(m));
    if (faces && of->push)
        face_push(m, of->push);
    TRY(p->engine->sum->pairs(&job, &w->scratch));
    if (faces)
        face_add(m, of);
    return STATUS_DONE;
}

/* The laws that answer. */
static const struct pairs_table *table_of(const struct plan *p, const struct ask *ask)
{
    if (ask->rates == ASK_DENSITIES)
        return p->table.densities;
    if (ask->rates == ASK_VELOCITIES)
        return p->table.velocities;
    if (ask->without_pressure)
        return p->table.without_pressure;
    return ask->sides == ASK_EXPLICIT ? p->table.explicit : p->table.all;
}

/* Forces and power of these laws; with job->apart those of the implicit law each where
 * they belong. */
static int sum_laws(struct moment *m, const struct rates_job *job, double *power)
{
    const int stiff = job->apart ? m->plan->stiff->slot : 0;

    if (m->particles->n == 0)
        return STATUS_DONE;
    TRY(rates_sum(m, job));
    if (job->apart) {
        *power = m->work->power[stiff];
        m->work->power[stiff] = 0;
    }
    if (job->apart && plan_face_implicit(m->plan))
        m->face->power = 0; /* of the implicit side */
    return STATUS_DONE;
}

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

/* Skin forces bend the bodies. */
static void load_bodies(struct moment *m, double t, const double *y, double *ydot)
{
    for (int i = 0; i < m->plan->bodies; i++) {
        struct moment_body *b = &m->body[i];
        solids_skin(m, b);
        b->kind->load(b->body, b->work, &m->layout, t, y, (const double (*)[DIM])b->force, ydot,
                      &b->load);
    }
}

/* Momentum of the fluid if rates were velocities. */
static void add_momentum(const struct particles *all, double sign, const double (*udot)[DIM],
                         double *sum)
{
    for (int id = 0; id < particles_count(all, KIND_FLUID); id++) {
        const int i = particles_row(all, KIND_FLUID, id);
        for (int d = 0; d < DIM; d++)
            sum[d] += sign * all->m[i] * udot[i][d];
    }
}

/* Fields; what those that are not the weight pull with in all is booked. */
static void add_fields(struct moment *m, const struct view *v, double *ydot)
{
    double (*udot)[DIM] = spread_velocities(m, ydot);

    memset(m->pull, 0, sizeof m->pull);
    for (int i = 0; i < m->plan->parts; i++) {
        const struct plan_part *one = &m->plan->part[i];
        const struct part_force *force = one->part->as.force;
        if (!force)
            continue;
        if (!force->weight)
            add_momentum(v->p, -1, (const double (*)[DIM])udot, m->pull);
        force->accelerate(one->self, v, udot);
        if (!force->weight)
            add_momentum(v->p, 1, (const double (*)[DIM])udot, m->pull);
    }
}

/* All forces are known: what follows from them. */
static void push(struct moment *m, const struct view *v, const double *y, double *ydot)
{
    const struct plan *p = m->plan;

    if (p->row.x >= 0)
        add_fields(m, v, ydot);
    if (p->drifter) {
        add_drift(m, v, ydot);
        m->work->power[p->drifter->slot] = drift_power(m, v);
    }
    solids_sum(m);
    load_bodies(m, v->t, y, ydot);
    book_rates(p, &(struct book_powers){ m->work->power, m->wall_power, m->pull,
                                         (const double (*)[DIM])m->force, m->body },
               ydot + layout_at(&m->layout, p->book.row));
}

/* Of one half: what the other half has a rate of stands still. */
static void halve(struct moment *m, const struct ask *ask, const struct view *v, const double *y,
                  double *ydot)
{
    const struct plan_book *b = &m->plan->book;
    const long *from = m->layout.from;
    double *book = ydot + layout_at(&m->layout, b->row);

    if (ask->rates == ASK_VELOCITIES) {
        memset(ydot + from[LAYOUT_OTHER], 0,
               (size_t)(from[LAYOUT_CLASSES] - from[LAYOUT_OTHER]) * sizeof *ydot);
        push(m, v, y, ydot);
        memset(ydot, 0, (size_t)from[LAYOUT_VELOCITY] * sizeof *ydot);
        return;
    }
    memset(ydot, 0, (size_t)from[LAYOUT_OTHER] * sizeof *ydot);
    memset(book, 0, (size_t)b->n * sizeof *book);
    for (int i = 0; i < m->plan->slots; i++)
        book[b->work + i] = m->work->power[i];
}

/* What pushes the fluid besides pairs, where its rates will stand; NULL: nothing asks. */
static double (*pushes(struct moment *m, const struct ask *ask, const struct view *v,
                       double *ydot))[DIM]
{
    double (*udot)[DIM];

    if (ask->rates == ASK_DENSITIES || ask->ahead == 0 || m->plan->row.x < 0)
        return NULL;
    udot = spread_velocities(m, ydot);
    memset(udot, 0, (size_t)particles_count(v->p, KIND_FLUID) * sizeof *udot);
    add_fields(m, v, ydot);
    return udot;
}

int rates_eval(struct moment *m, const struct ask *ask, double t, const double *y, double *ydot,
               double *apart, double *power)
{
    struct rates_job job = { .table = table_of(m->plan, ask), .ahead = ask->ahead,
                             .apart = apart };
    struct view v;

    moment_view(m, t, y, &v);
    TRY(moment_fields(m, &v));
    job.push = pushes(m, ask, &v, ydot);
    job.to = spread_places(m, ask, ydot);
    TRY(sum_laws(m, &job, power));
    spread_rates(m, ask, &v, ydot);
    if (ask->rates)
        halve(m, ask, &v, y, ydot);
    else
        push(m, &v, y, ydot);
    return STATUS_DONE;
}
