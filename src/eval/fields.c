/* fields.c -- densities that are no state: summed over pairs before the forces. */
#include "eval/inside.h"

#include "base/status.h"

#include <stdio.h>
#include <string.h>

static int refuse_position(struct moment *m, double t)
{
    const struct list *l = m->list;
    const struct object *o;

    if (l->bad < 0) {
        snprintf(m->refusal, sizeof m->refusal, "no memory for the list of pairs at t = %g s", t);
        return STATUS_FAILED;
    }
    const int who = particles_id_of(m->particles, l->bad);
    o = &m->particles->object[m->particles->object_of[l->bad]];
    snprintf(m->refusal, sizeof m->refusal, "the position of particle %d (%s) is not finite at "
             "t = %g s; an earlier stage overflowed", who, o->name, t);
    m->culprit[MOMENT_PLACE_LOST] = (struct moment_culprit){ true, who, t };
    return STATUS_FAILED;
}

static int update_list(struct moment *m, const struct view *v)
{
    struct cloud cloud = { 0 };

    memcpy(cloud.from, v->p->from, sizeof cloud.from);
    memcpy(cloud.x, v->x, sizeof cloud.x);
    memcpy(cloud.row, v->p->row, sizeof cloud.row);
    if (m->plan->engine->sum->list->update(m->list, &cloud) != STATUS_DONE)
        return refuse_position(m, v->t);
    return workspace_fit(m->work, m->list);
}

/* Who has left the domain meets nobody: the density at rest. */
static void settle_kind(struct moment *m, const struct plan_field *f, struct view *v, int k)
{
    const struct workspace *w = m->work;
    const int from = m->list->start[k], n = particles_count(v->p, k);
    double *rho = w->rho + v->p->from[k];
    const struct part_sums job = {
        .v = v, .kind = k, .n = m->list->start[k + 1] - from, .owner = m->list->order + from,
        .sum = (const double (*)[PART_SUMS])(w->sum + from),
    };

    for (int i = 0; i < n && job.n < n; i++)
        rho[i] = m->plan->scales.rho0;
    f->part->part->as.summed->densities(f->part->self, &job, rho);
    v->rho[k] = rho;
    v->stores[k] = (f->part->part->provides & FIELD_DENSITY) != 0;
}

/* Fluid that has left the domain does not drift. */
static void carry(struct moment *m, const struct plan_field *f, struct view *v)
{
    const struct workspace *w = m->work;
    const int from = m->list->start[KIND_FLUID], n = particles_count(v->p, KIND_FLUID);
    const struct part_sums job = {
        .v = v, .kind = KIND_FLUID, .n = m->list->start[KIND_FLUID + 1] - from,
        .owner = m->list->order + from, .sum = (const double (*)[PART_SUMS])(w->sum + from),
    };

    memset(w->drift, 0, (size_t)n * sizeof *w->drift);
    f->part->part->as.summed->carry(f->part->self, &job, w->drift);
}

static int sum_field(struct moment *m, const struct plan_field *f, struct view *v)
{
    const struct sum_field_job job = {
        .list = m->list, .record = m->work->record, .meets = f->meets,
        .needs = f->part->part->as.summed->rows, .gather = f->part->part->as.summed->gather,
        .self = f->part->self, .kernel = m->plan->kernel[PART_DENSITY],
        .sum = m->work->sum,
    };
    unsigned kinds = 0;

    m->plan->engine->sum->field(&job);
    if (f->part->part->as.summed->carry) {
        carry(m, f, v);
        return STATUS_DONE;
    }
    for (int k = 0; k < KINDS; k++)
        if (f->meets[k] && particles_count(v->p, k) > 0) {
            settle_kind(m, f, v, k);
            kinds |= KIND_BIT(k);
        }
    return moment_pack(m, v, kinds);
}

int moment_fields(struct moment *m, struct view *v)
{
    if (m->particles->n == 0)
        return STATUS_DONE;
    TRY(update_list(m, v));
    TRY(moment_pack(m, v, KIND_BIT(KINDS) - 1));
    for (int i = 0; i < m->plan->fields; i++)
        TRY(sum_field(m, &m->plan->field[i], v));
    return STATUS_DONE;
}
