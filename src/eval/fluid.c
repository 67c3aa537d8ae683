/* fluid.c -- rates of the fluid: what no pair gives is added to what pairs gave. */
#include "eval/passes.h"

#include "base/status.h"
#include "base/threads.h"
#include "base/waiting.h"

#include <string.h>

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

/* The weight, or the other body forces, on some rows. */
static void accelerate(const struct evaluation *e, bool weight, struct threads_part rows)
{
    const struct plan *p = e->m->plan;

    for (int i = 0; i < p->parts; i++) {
        const struct part_force *force = p->part[i].part->as.force;
        if (force && force->weight == weight)
            force->accelerate(p->part[i].self, &e->view, rows.from, rows.to,
                              spread_velocities(e->m, e->ydot));
    }
}

/* Rates of density that no pair gives: kept apart, too, where power looks ahead. */
static void densify(const struct evaluation *e, double *rate, struct threads_part rows)
{
    const struct plan *p = e->m->plan;
    double *apart = e->m->work->sourced, *to = apart ? apart : rate;

    if (apart)
        memset(apart + rows.from, 0, (size_t)(rows.to - rows.from) * sizeof *apart);
    for (int i = 0; i < p->parts; i++)
        if (p->part[i].part->as.source)
            p->part[i].part->as.source->densify(p->part[i].self, &e->view, rows.from, rows.to, to);
    for (int i = rows.from; apart && i < rows.to; i++)
        rate[i] += apart[i];
}

static struct threads_part all_rows(const struct evaluation *e)
{
    return (struct threads_part){ 0, moment_rows_of(e->m, KIND_FLUID) };
}

/* What one thread does: it writes to rows that no other one has. */
static void give_part(const struct evaluation *e)
{
    const struct threads_part rows = threads_part(all_rows(e).to);

    spread_part(e->m, e->ask, &e->view, e->ydot);
    if (e->ask->rates != ASK_DENSITIES)
        accelerate(e, true, rows);
    if (e->job.to.rho)
        densify(e, e->job.to.rho, rows);
}

int passes_fluid(struct evaluation *e, const struct plan_field *of)
{
    (void)of;
    spread_stop(e->m, e->job.to);
    THREADS(waiting_repays(all_rows(e).to), give_part(e));
    return STATUS_DONE;
}

int passes_pulls(struct evaluation *e, const struct plan_field *of)
{
    struct moment *m = e->m;
    const double (*udot)[DIM] = (const double (*)[DIM])spread_velocities(m, e->ydot);

    (void)of;
    memset(m->pull, 0, sizeof m->pull);
    add_momentum(e->view.p, -1, udot, m->pull);
    accelerate(e, false, all_rows(e));
    add_momentum(e->view.p, 1, udot, m->pull);
    return STATUS_DONE;
}

void passes_add_body_forces(struct evaluation *e)
{
    accelerate(e, true, all_rows(e));
    accelerate(e, false, all_rows(e));
}
