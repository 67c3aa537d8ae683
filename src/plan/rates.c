/* rates.c -- the explicit side of the right-hand side: a short list of passes. */
#include "plan/inside.h"

#include "base/status.h"
#include "plan/catalogue.h"
#include "plan/face.h"
#include "plan/viscous.h"

#include <string.h>

enum { COPIED = 4096 }; /* numbers at a time */

int plan_sum(struct plan *p, struct plan_workspace *w, const struct pairs_table *table,
             double (*push)[DIM], struct sum_rates to)
{
    const bool faces = p->face && face_among(p, table);
    const struct sum_job job = {
        .list = w->list, .record = w->record, .table = table, .slots = p->slots,
        .later = p->later, .push = (const double (*)[DIM])push, .gamma = p->scales.gamma,
        .bulk = p->scales.rho0 * p->scales.c0 * p->scales.c0, .clamped = p->scales.clamped,
        .f = w->f, .drho = w->drho, .power = w->power, .rates = to,
        .apart = w->apart, .apart_slot = w->apart ? p->stiff->slot : 0,
    };

    if (p->face)
        p->face->power = 0;
    if (faces)
        TRY(face_find(p, w));
    if (faces && push)
        face_push(p, w, push);
    TRY(p->engine->sum->pairs(&job, &w->scratch));
    if (faces)
        face_add(p, w, job.push);
    return STATUS_DONE;
}

/* Forces and power of the explicit laws; with w->apart those of the implicit law, too,
 * each where it belongs. */
static int sum_laws(struct plan *p, struct plan_workspace *w, enum plan_which which,
                    double (*push)[DIM], struct sum_rates to)
{
    const struct pairs_table *table = which == PLAN_DENSITY                 ? p->rates
                                      : which == PLAN_VELOCITY              ? p->forces
                                      : which == PLAN_EXPLICIT && !w->apart ? p->explicit
                                                                            : p->table;

    if (p->particles->n == 0)
        return STATUS_DONE;
    TRY(plan_sum(p, w, table, push, to));
    if (w->apart) {
        w->power_apart = w->power[p->stiff->slot];
        w->power[p->stiff->slot] = 0;
    }
    if (w->apart && viscous_faces(p))
        p->face->power = 0; /* of the implicit side */
    return STATUS_DONE;
}

/* Rates of the fluid that sums over pairs write to ydot at once: where its viscosity acts
 * at faces, forces are not known before these have added theirs. */
static struct sum_rates rates_in(const struct plan *p, enum plan_which which, double *ydot)
{
    const int rho = p->density_row[KIND_FLUID];
    struct sum_rates to = { 0 };

    if (p->row_x < 0)
        return to;
    if (which != PLAN_DENSITY && !p->face)
        to.u = (double (*)[DIM])(ydot + layout_at(&p->layout, p->row_u));
    if (which != PLAN_VELOCITY && rho >= 0)
        to.rho = ydot + layout_at(&p->layout, rho);
    return to;
}

/* Who has left the domain is in no sum. */
static void stop_outsiders(const struct plan *p, const struct list *l, struct sum_rates to)
{
    const int n = particles_count(p->particles, KIND_FLUID);

    for (int i = 0; i < n && l->start[KIND_FLUID + 1] < n; i++) {
        if (l->slot[i] >= 0)
            continue;
        if (to.u)
            memset(to.u[i], 0, sizeof to.u[i]);
        if (to.rho)
            to.rho[i] = 0;
    }
}

/* x' = u. */
static void copy_velocities(const struct plan *p, const struct view *v, double *ydot)
{
    const int n = DIM * particles_count(v->p, KIND_FLUID);
    double *xdot = ydot + layout_at(&p->layout, p->row_x);

#pragma omp parallel for schedule(static) if (n > 4 * COPIED)
    for (int i = 0; i < n; i += COPIED)
        memcpy(xdot + i, v->u[KIND_FLUID] + i,
               (size_t)(n - i < COPIED ? n - i : COPIED) * sizeof *xdot);
}

/* u' = f/m from slots: one pass in the order of ydot, as scattered writes wait longer
 * than scattered reads. */
static void spread_forces(const struct plan *p, const struct plan_workspace *w, double *ydot)
{
    const struct list *l = w->list;
    const int n = particles_count(p->particles, KIND_FLUID);
    double (*udot)[DIM] = (double (*)[DIM])(ydot + layout_at(&p->layout, p->row_u));

#pragma omp parallel for schedule(static) if (n > 4096)
    for (int i = 0; i < n; i++) {
        const int s = l->slot[i]; /* -1: has left the domain */
        const double im = 1 / p->particles->m[i];
        for (int d = 0; d < DIM; d++)
            udot[i][d] = s < 0 ? 0 : w->f[(size_t)s * DIM + d] * im;
    }
}

/* Positions move with more than the velocity. */
static void add_drift(const struct plan *p, const struct view *v, double *ydot)
{
    double (*xdot)[DIM] = (double (*)[DIM])(ydot + layout_at(&p->layout, p->row_x));

    for (int i = 0; i < particles_count(v->p, KIND_FLUID); i++)
        for (int d = 0; d < DIM; d++)
            xdot[i][d] += p->drift[i][d];
}

/* What a drift against the weight gives [W]. */
static double drift_power(const struct plan *p, const struct view *v)
{
    double power = 0;

    for (int i = 0; i < particles_count(v->p, KIND_FLUID); i++)
        for (int d = 0; d < DIM; d++)
            power -= v->p->m[i] * p->scales.g[d] * p->drift[i][d];
    return power;
}

/* Rates of density of solids that have one of their own. */
static void spread_densities(const struct plan *p, const struct plan_workspace *w, double *ydot)
{
    const struct list *l = w->list;

    for (int k = KIND_FLUID + 1; k < KINDS; k++) {
        const int first = p->particles->from[k], n = particles_count(p->particles, k);
        double *rhodot;
        if (p->density_row[k] < 0)
            continue;
        rhodot = ydot + layout_at(&p->layout, p->density_row[k]);
#pragma omp parallel for schedule(static) if (n > 4096)
        for (int i = 0; i < n; i++)
            rhodot[i] = l->slot[first + i] < 0 ? 0 : w->drho[l->slot[first + i]];
    }
}

/* What the fluid's forces do on a wall that moves [W]. */
static double power_of(const struct plan *p, const struct plan_workspace *w,
                       const struct object *o)
{
    double power = 0;

    for (int c = o->from; c < o->from + o->n; c++) {
        const int s = w->list->slot[c];
        for (int d = 0; d < DIM && s >= 0; d++)
            power += w->f[(size_t)s * DIM + d] * p->particles->u[c][d];
    }
    return power;
}

void plan_solids_sum(struct plan *p, const struct plan_workspace *w)
{
    const struct particles *all = p->particles;

    memset(p->force, 0, all->objects * sizeof *p->force);
    p->wall_power = 0;
    for (int c = all->from[KIND_WALL]; c < all->n; c++) {
        const int s = w->list->slot[c];
        double *sum = p->force[all->object_of[c]];
        if (s < 0)
            continue;
        for (int d = 0; d < DIM; d++)
            sum[d] += w->f[(size_t)s * DIM + d];
    }
    for (int i = 0; i < p->walls; i++)
        if (p->wall[i].moves)
            p->wall_power += power_of(p, w, &all->object[p->wall[i].object]);
    if (p->face)
        p->wall_power += p->face->power;
}

void plan_skin_force(const struct plan *p, const struct plan_workspace *w, struct plan_body *b)
{
    for (int j = 0; j < b->skin; j++) {
        const int s = w->list->slot[p->particles->object[b->object].from + j];
        for (int d = 0; d < DIM; d++)
            b->force[j][d] = s < 0 ? 0 : w->f[(size_t)s * DIM + d];
    }
}

/* Skin forces bend the bodies. */
static void load_bodies(struct plan *p, const struct plan_workspace *w, double t,
                        const double *y, double *ydot)
{
    for (int i = 0; i < p->bodies; i++) {
        struct plan_body *b = &p->body[i];
        plan_skin_force(p, w, b);
        b->kind->load(b->body, &p->layout, t, y, (const double (*)[DIM])b->force, ydot, &b->load);
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
static void add_fields(struct plan *p, const struct view *v, double *ydot)
{
    double (*udot)[DIM] = (double (*)[DIM])(ydot + layout_at(&p->layout, p->row_u));

    memset(p->pull, 0, sizeof p->pull);
    for (int i = 0; i < p->parts; i++) {
        const struct part *part = p->part[i].part;
        if (!part->field)
            continue;
        if (!catalogue_implied(part))
            add_momentum(v->p, -1, (const double (*)[DIM])udot, p->pull);
        part->field(p->part[i].self, v, udot);
        if (!catalogue_implied(part))
            add_momentum(v->p, 1, (const double (*)[DIM])udot, p->pull);
    }
}

/* Rates of everything but bodies, fields and the book. */
static void spread(const struct plan *p, const struct plan_workspace *w, enum plan_which which,
                   const struct view *v, double *ydot)
{
    if (p->row_x < 0)
        return;
    stop_outsiders(p, w->list, rates_in(p, which, ydot));
    if (!(which & (PLAN_DENSITY | PLAN_VELOCITY))) /* halves move nobody */
        copy_velocities(p, v, ydot);
    if (which != PLAN_DENSITY && p->face)
        spread_forces(p, w, ydot);
    if (which != PLAN_VELOCITY)
        spread_densities(p, w, ydot);
}

/* Forces on everybody are known: what follows from them. */
static void push(struct plan *p, struct plan_workspace *w, const struct view *v, const double *y,
                 double *ydot)
{
    if (p->row_x >= 0)
        add_fields(p, v, ydot);
    if (p->drifter) {
        add_drift(p, v, ydot);
        w->power[p->drifter->slot] = drift_power(p, v);
    }
    plan_solids_sum(p, w);
    load_bodies(p, w, v->t, y, ydot);
    plan_book_rates(p, w, ydot);
}

/* Of one half: what the other half has a rate of stands still. */
static void halve(struct plan *p, struct plan_workspace *w, enum plan_which which,
                  const struct view *v, const double *y, double *ydot)
{
    const long *from = p->layout.from;
    double *book = ydot + layout_at(&p->layout, p->book.row);

    memset(ydot, 0, (size_t)from[LAYOUT_VELOCITY] * sizeof *ydot);
    if (which == PLAN_VELOCITY) {
        memset(ydot + from[LAYOUT_OTHER], 0,
               (size_t)(from[LAYOUT_CLASSES] - from[LAYOUT_OTHER]) * sizeof *ydot);
        push(p, w, v, y, ydot);
        return;
    }
    memset(ydot + from[LAYOUT_VELOCITY], 0,
           (size_t)(from[LAYOUT_OTHER] - from[LAYOUT_VELOCITY]) * sizeof *ydot);
    memset(book, 0, (size_t)p->book.n * sizeof *book);
    for (int i = 0; i < p->slots; i++)
        book[p->book.work + i] = w->power[i];
}

/* What pushes the fluid besides pairs, where its rates will stand; NULL: nobody asks. */
static double (*pushes(struct plan *p, enum plan_which which, const struct view *v,
                       double *ydot))[DIM]
{
    double (*udot)[DIM];

    if (which == PLAN_DENSITY || p->later == 0 || p->row_x < 0)
        return NULL;
    udot = (double (*)[DIM])(ydot + layout_at(&p->layout, p->row_u));
    memset(udot, 0, (size_t)particles_count(v->p, KIND_FLUID) * sizeof *udot);
    add_fields(p, v, ydot);
    return udot;
}

int plan_rates(struct plan *p, struct plan_workspace *w, enum plan_which which, double t,
               const double *y, double *ydot)
{
    struct view v;

    plan_view_make(p, t, y, &v);
    TRY(plan_fields(p, w, &v));
    TRY(sum_laws(p, w, which, pushes(p, which, &v, ydot), rates_in(p, which, ydot)));
    spread(p, w, which, &v, ydot);
    if (which & (PLAN_DENSITY | PLAN_VELOCITY))
        halve(p, w, which, &v, y, ydot);
    else
        push(p, w, &v, y, ydot);
    return STATUS_DONE;
}
