/* rates.c -- the explicit side of the right-hand side: a short list of passes. */
#include "plan/inside.h"

#include "base/status.h"
#include "plan/face.h"
#include "plan/viscous.h"

#include <string.h>

enum { COPIED = 4096 }; /* numbers at a time */

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
    if (job->apart && viscous_faces(m->plan))
        m->face->power = 0; /* of the implicit side */
    return STATUS_DONE;
}

/* Rates of the fluid that sums over pairs write to ydot at once: where its viscosity acts
 * at faces, forces are not known before these have added theirs. */
static struct sum_rates rates_in(const struct moment *m, const struct ask *ask, double *ydot)
{
    const struct plan_rows *row = &m->plan->row;
    const int rho = row->density[KIND_FLUID];
    struct sum_rates to = { 0 };

    if (row->x < 0)
        return to;
    if (ask->rates != ASK_DENSITIES && !m->face)
        to.u = (double (*)[DIM])(ydot + layout_at(&m->layout, row->u));
    if (ask->rates != ASK_VELOCITIES && rho >= 0)
        to.rho = ydot + layout_at(&m->layout, rho);
    return to;
}

/* Particles outside the domain are excluded from all sums. */
static void stop_outsiders(const struct moment *m, struct sum_rates to)
{
    const struct list *l = m->list;
    const int n = particles_count(m->particles, KIND_FLUID);

    for (int i = 0; i < n && l->start[KIND_FLUID + 1] < n; i++) {
        if (l->slot[i] >= 0)
            continue;
        if (to.u)
            memset(to.u[i], 0, sizeof to.u[i]);
        if (to.rho)
            to.rho[i] = 0;
    }
}

static double (*velocity_rates(const struct moment *m, double *ydot))[DIM]
{
    return (double (*)[DIM])(ydot + layout_at(&m->layout, m->plan->row.u));
}

/* x' = u. */
static void copy_velocities(const struct moment *m, const struct view *v, double *ydot)
{
    const int n = DIM * particles_count(v->p, KIND_FLUID);
    double *xdot = ydot + layout_at(&m->layout, m->plan->row.x);

#pragma omp parallel for schedule(static) if (n > 4 * COPIED)
    for (int i = 0; i < n; i += COPIED)
        memcpy(xdot + i, v->u[KIND_FLUID] + i,
               (size_t)(n - i < COPIED ? n - i : COPIED) * sizeof *xdot);
}

/* u' = f/m from slots: one pass in the order of ydot, as scattered writes wait longer
 * than scattered reads. */
static void spread_forces(const struct moment *m, double *ydot)
{
    const struct list *l = m->list;
    const double *f = m->work->f;
    const int n = particles_count(m->particles, KIND_FLUID);
    double (*udot)[DIM] = velocity_rates(m, ydot);

#pragma omp parallel for schedule(static) if (n > 4096)
    for (int i = 0; i < n; i++) {
        const int s = l->slot[i]; /* -1: has left the domain */
        const double im = 1 / m->particles->m[i];
        for (int d = 0; d < DIM; d++)
            udot[i][d] = s < 0 ? 0 : f[(size_t)s * DIM + d] * im;
    }
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

    for (int i = 0; i < particles_count(v->p, KIND_FLUID); i++)
        for (int d = 0; d < DIM; d++)
            power -= v->p->m[i] * g[d] * m->work->drift[i][d];
    return power;
}

/* Rates of density of solids that have one of their own. */
static void spread_densities(const struct moment *m, double *ydot)
{
    const struct list *l = m->list;
    const struct plan_rows *row = &m->plan->row;
    const double *drho = m->work->drho;

    for (int k = KIND_FLUID + 1; k < KINDS; k++) {
        const int first = m->particles->from[k], n = particles_count(m->particles, k);
        double *rhodot;
        if (row->density[k] < 0)
            continue;
        rhodot = ydot + layout_at(&m->layout, row->density[k]);
#pragma omp parallel for schedule(static) if (n > 4096)
        for (int i = 0; i < n; i++)
            rhodot[i] = l->slot[first + i] < 0 ? 0 : drho[l->slot[first + i]];
    }
}

/* What the fluid's forces do on a wall that moves [W]. */
static double power_of(const struct moment *m, const struct object *o)
{
    double power = 0;

    for (int c = o->from; c < o->from + o->n; c++) {
        const int s = m->list->slot[c];
        for (int d = 0; d < DIM && s >= 0; d++)
            power += m->work->f[(size_t)s * DIM + d] * m->particles->u[c][d];
    }
    return power;
}

void rates_of_solids(struct moment *m)
{
    const struct particles *all = m->particles;
    const struct plan *p = m->plan;

    memset(m->force, 0, all->objects * sizeof *m->force);
    m->wall_power = 0;
    for (int c = all->from[KIND_WALL]; c < all->n; c++) {
        const int s = m->list->slot[c];
        double *sum = m->force[all->object_of[c]];
        if (s < 0)
            continue;
        for (int d = 0; d < DIM; d++)
            sum[d] += m->work->f[(size_t)s * DIM + d];
    }
    for (int i = 0; i < p->walls; i++)
        if (p->wall[i].moves)
            m->wall_power += power_of(m, &all->object[p->wall[i].object]);
    if (m->face)
        m->wall_power += m->face->power;
}

void rates_of_skin(const struct moment *m, struct moment_body *b)
{
    for (int j = 0; j < b->skin; j++) {
        const int s = m->list->slot[m->particles->object[b->object].from + j];
        for (int d = 0; d < DIM; d++)
            b->force[j][d] = s < 0 ? 0 : m->work->f[(size_t)s * DIM + d];
    }
}

/* Skin forces bend the bodies. */
static void load_bodies(struct moment *m, double t, const double *y, double *ydot)
{
    for (int i = 0; i < m->plan->bodies; i++) {
        struct moment_body *b = &m->body[i];
        rates_of_skin(m, b);
        b->kind->load(b->body, b->work, &m->layout, t, y, (const double (*)[DIM])b->force, ydot,
                      &b->load);
    }
}

/* Momentum of the fluid if rates were velocities. */
static void add_momentum(const struct particles *all, double sign, const double (*udot)[DIM],
                         double *sum)
{
    for (int i = 0; i < particles_count(all, KIND_FLUID); i++)
        for (int d = 0; d < DIM; d++)
            sum[d] += sign * all->m[i] * udot[i][d];
}

/* Fields; what those that are not the weight pull with in all is booked. */
static void add_fields(struct moment *m, const struct view *v, double *ydot)
{
    double (*udot)[DIM] = velocity_rates(m, ydot);

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

static bool is_half(const struct ask *ask)
{
    return ask->rates != 0;
}

/* Rates of everything but bodies, fields and the book. */
static void spread(const struct moment *m, const struct ask *ask, const struct view *v,
                   double *ydot)
{
    if (m->plan->row.x < 0)
        return;
    stop_outsiders(m, rates_in(m, ask, ydot));
    if (!is_half(ask)) /* halves move nothing */
        copy_velocities(m, v, ydot);
    if (ask->rates != ASK_DENSITIES && m->face)
        spread_forces(m, ydot);
    if (ask->rates != ASK_VELOCITIES)
        spread_densities(m, ydot);
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
    rates_of_solids(m);
    load_bodies(m, v->t, y, ydot);
    book_rates(m, ydot);
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
    udot = velocity_rates(m, ydot);
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
    job.to = rates_in(m, ask, ydot);
    TRY(sum_laws(m, &job, power));
    spread(m, ask, &v, ydot);
    if (is_half(ask))
        halve(m, ask, &v, y, ydot);
    else
        push(m, &v, y, ydot);
    return STATUS_DONE;
}
