/* ahead.c -- a pressure that looks ahead, and its power. */
#include "eval/passes.h"

#include "base/status.h"
#include "plan/solver.h"
#include "space/record.h"

#include <string.h>

/* Solids press with what was found, as records have it; what the density alone gives is kept. */
static void replace_press(const struct moment *m)
{
    const struct particles *all = m->particles;
    struct workspace *w = m->work;
    const int first = all->from[KIND_WALL];

    memcpy(w->law, w->p2, (size_t)(all->n - first) * sizeof *w->law);
    for (int i = first; i < all->n; i++) {
        const int place = m->list->slot[i];
        w->p2[i - first] = place < 0 ? 0 : w->record[(size_t)place * RECORD + RECORD_P2];
    }
}

/* Accelerations and forces by all but the pressure are where its laws will write theirs.  What
 * walls do to skins goes by densities of now, as g(o) does, (W6): it is no part of the solve. */
int passes_look_ahead(struct evaluation *e, const struct plan_field *of)
{
    struct moment *m = e->m;

    (void)of;
    wet_take(m);
    if (m->work->between && m->work->between == m->work->law)
        press_between(m, m->work->p2);
    TRY(implicit_ahead.find(m->ahead, m, e->t, e->y, spread_velocities(m, e->ydot)[0]));
    if (m->work->law)
        replace_press(m);
    return STATUS_DONE;
}

/* p/rho^2 of row i of kind k by (E1); of solids that press by a mean, by (W6). */
static double law_of(const struct evaluation *e, int k, int i)
{
    const struct plan_part *pressure = e->m->plan->pressure;
    const struct particles *all = e->m->particles;
    const double rho = e->view.rho[k][i];
    double linear;

    if (k != KIND_FLUID && e->m->work->law)
        return e->m->work->law[all->from[k] + i - all->from[KIND_WALL]];
    pressure->part->as.pressure->pressures(pressure->self, 1, &rho, &linear);
    return linear / (rho * rho);
}

/* Of kind k: the sum of (p_E1 - p)/rho^2 m rho' [W], rho' of the flow: what sources of density give
 * has no power, as they act where (E1) stores nothing. */
static double power_of(const struct evaluation *e, int k)
{
    const struct moment *m = e->m;
    const struct plan *p = m->plan;
    const struct particles *all = m->particles;
    const double *rate = e->ydot + layout_at(&m->layout, p->row.density[k]);
    const double *sourced = k == KIND_FLUID ? m->work->sourced : NULL;
    double power = 0;

    for (int id = 0; id < particles_count(all, k); id++) {
        const int i = particles_row(all, (enum kind)k, id), place = m->list->slot[all->from[k] + i];
        if (place < 0)
            continue;
        power += (law_of(e, k, i) - m->work->record[(size_t)place * RECORD + RECORD_P2])
                 * all->m[all->from[k] + i] * (rate[i] - (sourced ? sourced[i] : 0));
    }
    return power;
}

/* The same of the densities that solids have by being near one another: what the forces
 * between them by that difference of pressures would give. */
static double power_between(struct moment *m)
{
    const struct plan_part *wall = m->plan->passes.press;
    const struct particles *all = m->particles;
    struct workspace *w = m->work;
    const int first = all->from[KIND_WALL];
    double (*f)[DIM] = (double (*)[DIM])w->pressed, power = 0;

    for (int i = 0; i < all->n - first; i++)
        w->law[i] -= w->p2[i];
    const int n = wall->part->as.wall->press->meet(wall->self, w->press, all, w->law, f, w->rows);
    for (int k = 0; k < n; k++)
        for (int d = 0; d < DIM; d++)
            power -= f[w->rows[k]][d] * all->u[first + w->rows[k]][d];
    return power;
}

/* Laws book rates of density with p; what is stored is the energy of (E1).  What looking ahead
 * takes of that for good has a column of its own. */
int passes_ahead_power(struct evaluation *e, const struct plan_field *of)
{
    const double dissipated = implicit_ahead.power(e->m->ahead);
    double power = -dissipated;

    (void)of;
    for (int k = 0; k < KINDS; k++)
        if (e->m->plan->row.density[k] >= 0)
            power += power_of(e, k);
    if (e->m->work->between != e->m->work->law)
        power += power_between(e->m);
    e->m->work->power[e->m->plan->pressure->slot] = power;
    e->m->work->power[e->m->plan->slots] = dissipated;
    return STATUS_DONE;
}
