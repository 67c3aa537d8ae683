/* spread.c -- from the order of the pair list to that of y: rates of particles. */
#include "eval/inside.h"

#include "base/threads.h"
#include "base/waiting.h"

#include <string.h>

/* Rates of the fluid that sums over pairs write to ydot at once: where its viscosity acts
 * at faces, forces are not known before these have added theirs. */
struct sum_rates spread_places(const struct moment *m, const struct ask *ask, double *ydot)
{
    const struct plan_rows *row = &m->plan->row;
    const int rho = row->density[KIND_FLUID];
    struct sum_rates to = { .rows = moment_rows_of(m, KIND_FLUID) };

    if (row->x < 0)
        return to;
    if (ask->rates != ASK_DENSITIES && !m->face)
        to.u = (double (*)[DIM])(ydot + layout_at(&m->layout, row->u));
    if (ask->rates != ASK_VELOCITIES && rho >= 0)
        to.rho = ydot + layout_at(&m->layout, rho);
    return to;
}

/* Particles outside the domain are excluded from all sums. */
void spread_stop(const struct moment *m, struct sum_rates to)
{
    const struct list *l = m->list;
    const int n = l->whole ? l->whole->from[KIND_FLUID + 1] : particles_count(m->particles, KIND_FLUID);

    for (int i = 0; i < to.rows && l->start[KIND_FLUID + 1] < n; i++) {
        if (l->slot[i] >= 0)
            continue;
        if (to.u)
            memset(to.u[i], 0, sizeof to.u[i]);
        if (to.rho)
            to.rho[i] = 0;
    }
}

double (*spread_velocities(const struct moment *m, double *ydot))[DIM]
{
    return (double (*)[DIM])(ydot + layout_at(&m->layout, m->plan->row.u));
}

/* x' = u. */
static void copy_velocities(const struct moment *m, const struct view *v, double *ydot)
{
    const struct threads_part part = threads_part(DIM * moment_rows_of(m, KIND_FLUID));

    memcpy(ydot + layout_at(&m->layout, m->plan->row.x) + part.from,
           v->u[KIND_FLUID] + part.from, (size_t)(part.to - part.from) * sizeof *ydot);
}

/* u' = f/m from places: one pass in the order of ydot, as scattered writes wait longer
 * than scattered reads. */
static void spread_forces(const struct moment *m, double *ydot)
{
    const struct list *l = m->list;
    const double *f = m->work->f;
    const struct threads_part part = threads_part(particles_count(m->particles, KIND_FLUID));
    double (*udot)[DIM] = spread_velocities(m, ydot);

    for (int i = part.from; i < part.to; i++) {
        const int s = l->slot[i]; /* -1: has left the domain */
        const double im = 1 / m->particles->m[i];
        for (int d = 0; d < DIM; d++)
            udot[i][d] = s < 0 ? 0 : f[(size_t)s * DIM + d] * im;
    }
}

/* Rates of density of solids that have one of their own. */
static void spread_densities(const struct moment *m, double *ydot)
{
    const struct list *l = m->list;
    const struct plan_rows *row = &m->plan->row;
    const double *drho = m->work->drho;

    for (int k = KIND_FLUID + 1; k < KINDS; k++) {
        const struct threads_part part = threads_part(moment_rows_of(m, (enum kind)k));
        const int *slot = l->slot + m->particles->from[k];
        double *rhodot;
        if (row->density[k] < 0)
            continue;
        rhodot = ydot + layout_at(&m->layout, row->density[k]);
        for (int i = part.from; i < part.to; i++)
            rhodot[i] = slot[i] < 0 ? 0 : drho[slot[i]];
    }
}

void spread_accelerations(const struct moment *m, double *ydot)
{
    const struct ask ask = { .rates = ASK_VELOCITIES };

    spread_stop(m, spread_places(m, &ask, ydot));
    if (m->face)
        THREADS(waiting_repays(particles_count(m->particles, KIND_FLUID)),
                spread_forces(m, ydot));
}

/* Halves move nothing. */
void spread_part(const struct moment *m, const struct ask *ask, const struct view *v, double *ydot)
{
    if (ask->rates == 0)
        copy_velocities(m, v, ydot);
    if (ask->rates != ASK_DENSITIES && m->face)
        spread_forces(m, ydot);
    if (ask->rates != ASK_VELOCITIES)
        spread_densities(m, ydot);
}
