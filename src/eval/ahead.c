/* ahead.c -- a pressure that looks ahead, and its power. */
#include "eval/passes.h"

#include "base/status.h"
#include "plan/solver.h"
#include "space/record.h"

/* Accelerations and forces by all but the pressure are where its laws will write theirs. */
int passes_look_ahead(struct evaluation *e, const struct plan_field *of)
{
    (void)of;
    return implicit_ahead.find(e->m->ahead, e->m, e->t, e->y, spread_velocities(e->m, e->ydot)[0]);
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
        const double rho = e->view.rho[k][i];
        double linear;
        if (place < 0)
            continue;
        p->pressure->part->as.pressure->pressures(p->pressure->self, 1, &rho, &linear);
        power += (linear / (rho * rho) - m->work->record[(size_t)place * RECORD + RECORD_P2])
                 * all->m[all->from[k] + i] * (rate[i] - (sourced ? sourced[i] : 0));
    }
    return power;
}

/* Laws book rates of density with p; what is stored is the energy of (E1). */
int passes_ahead_power(struct evaluation *e, const struct plan_field *of)
{
    double power = 0;

    (void)of;
    for (int k = 0; k < KINDS; k++)
        if (e->m->plan->row.density[k] >= 0)
            power += power_of(e, k);
    e->m->work->power[e->m->plan->pressure->slot] = power;
    return STATUS_DONE;
}
