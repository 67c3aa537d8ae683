/* fields.c -- densities that are no state: summed over pairs before the forces. */
#include "plan/inside.h"

#include "base/status.h"

#include <stdio.h>
#include <string.h>

static int refuse_position(struct plan *p, const struct list *l, double t)
{
    const struct object *o;

    if (l->bad < 0) {
        snprintf(p->refusal, sizeof p->refusal, "no memory for the list of pairs at t = %g s", t);
        return STATUS_FAILED;
    }
    o = &p->particles->object[p->particles->object_of[l->bad]];
    snprintf(p->refusal, sizeof p->refusal, "the position of particle %d (%s) is not finite at "
             "t = %g s; an earlier stage overflowed", l->bad, o->name, t);
    p->culprit[PLAN_PLACE_LOST] = (struct plan_culprit){ true, l->bad, t };
    return STATUS_FAILED;
}

static int update_list(struct plan *p, struct plan_workspace *w, const struct view *v)
{
    struct cloud cloud = { 0 };

    memcpy(cloud.from, v->p->from, sizeof cloud.from);
    memcpy(cloud.x, v->x, sizeof cloud.x);
    if (p->engine->sum->list->update(w->list, &cloud) != STATUS_DONE)
        return refuse_position(p, w->list, v->t);
    return plan_workspace_fit(p, w);
}

/* Who has left the domain meets nobody: the density at rest. */
static void settle_kind(struct plan *p, const struct plan_field *f, struct plan_workspace *w,
                        struct view *v, int k)
{
    const int from = w->list->start[k], n = particles_count(v->p, k);
    double *rho = w->rho + v->p->from[k];
    const struct settle job = {
        .v = v, .kind = k, .n = w->list->start[k + 1] - from, .owner = w->list->order + from,
        .sum = (const double (*)[PART_SUMS])(w->sum + from), .rho = rho,
    };

    for (int i = 0; i < n && job.n < n; i++)
        rho[i] = p->scales.rho0;
    f->part->part->settle(f->part->self, &job);
    v->rho[k] = rho;
    v->stores[k] = (f->part->part->provides & FIELD_DENSITY) != 0;
}

/* Fluid that has left the domain does not drift. */
static void carry(struct plan *p, const struct plan_field *f, struct plan_workspace *w,
                  struct view *v)
{
    const int from = w->list->start[KIND_FLUID], n = particles_count(v->p, KIND_FLUID);
    const struct settle job = {
        .v = v, .kind = KIND_FLUID, .n = w->list->start[KIND_FLUID + 1] - from,
        .owner = w->list->order + from, .sum = (const double (*)[PART_SUMS])(w->sum + from),
    };

    memset(p->drift, 0, (size_t)n * sizeof *p->drift);
    f->part->part->carry(f->part->self, &job, p->drift);
}

static int sum_field(struct plan *p, const struct plan_field *f, struct plan_workspace *w,
                     struct view *v)
{
    const struct sum_field_job job = {
        .list = w->list, .record = w->record, .meets = f->meets,
        .needs = f->part->part->gather_rows, .gather = f->part->part->gather,
        .self = f->part->self, .kernel = p->kernel[PART_DENSITY], .sum = w->sum,
    };
    unsigned kinds = 0;

    p->engine->sum->field(&job);
    if (f->part->part->carry) {
        carry(p, f, w, v);
        return STATUS_DONE;
    }
    for (int k = 0; k < KINDS; k++)
        if (f->meets[k] && particles_count(v->p, k) > 0) {
            settle_kind(p, f, w, v, k);
            kinds |= KIND_BIT(k);
        }
    return plan_pack(p, w, v, kinds);
}

int plan_fields(struct plan *p, struct plan_workspace *w, struct view *v)
{
    if (p->particles->n == 0)
        return STATUS_DONE;
    TRY(update_list(p, w, v));
    TRY(plan_pack(p, w, v, KIND_BIT(KINDS) - 1));
    for (int i = 0; i < p->fields; i++)
        TRY(sum_field(p, &p->field[i], w, v));
    return STATUS_DONE;
}
