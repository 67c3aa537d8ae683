/* fields.c -- the list of pairs, and densities that are no state: summed over pairs. */
#include "eval/share.h"

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
    const int particle = particles_id_of(m->particles, l->bad);
    o = &m->particles->object[m->particles->object_of[l->bad]];
    snprintf(m->refusal, sizeof m->refusal, "the position of particle %d (%s) is not finite at "
             "t = %g s; an earlier stage overflowed", particle, o->name, t);
    moment_note(m, MOMENT_PLACE_LOST, particle, t);
    return STATUS_FAILED;
}

/* A moment for looking sums over the run's list if that fits, else over its own, made where
 * it looks: what was looked at before says nothing. */
static int choose_list(struct moment *m, const struct cloud *cloud)
{
    const struct list_engine *lists = m->plan->engine->sum->list;
    bool fits;

    fits = m->own->stands && !lists->stale(m->beside->list, cloud);
    m->list = fits && !m->beside->share ? m->beside->list : m->own;
    if (m->list == m->own)
        list_forget(m->own);
    return fits && m->beside->share ? share_remake(m->beside, m->own) : STATUS_DONE;
}

static int make_list(struct evaluation *e, struct cloud *cloud)
{
    struct moment *m = e->m;

    if (m->share)
        return m->beside ? share_list_beside(e, cloud) : share_list(e, cloud);
    if (m->beside)
        TRY(choose_list(m, cloud));
    return m->plan->engine->sum->list->update(m->list, cloud);
}

int passes_list(struct evaluation *e, const struct plan_field *of)
{
    struct moment *m = e->m;
    struct cloud cloud = { 0 };

    (void)of;
    memcpy(cloud.from, e->view.p->from, sizeof cloud.from);
    memcpy(cloud.x, e->view.x, sizeof cloud.x);
    memcpy(cloud.row, e->view.p->row, sizeof cloud.row);
    if (make_list(e, &cloud) != STATUS_DONE)
        return m->share && m->share->heard.apart ? STATUS_FAILED : refuse_position(m, e->t);
    return workspace_fit(m->work, m->list);
}

/* Particles outside the domain have no neighbours: the density at rest. */
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

int passes_sum(struct evaluation *e, const struct plan_field *f)
{
    struct moment *m = e->m;
    struct view *v = &e->view;
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
