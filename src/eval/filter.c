/* filter.c -- an event at which densities of the fluid are replaced, between two segments. */
#include "eval/passes.h"

#include "base/status.h"

#include <math.h>

/* Does it act at t? */
static bool is_due(const struct plan_part *one, double t)
{
    const struct part_filter *filter = one->part->as.filter;

    return filter && filter->event(one->self, nextafter(t, -HUGE_VAL)) <= t;
}

static double internal(const struct plan *p, const struct view *v)
{
    struct energy_sums sum = { 0 };

    if (p->pressure && p->pressure->part->energy)
        p->pressure->part->energy(p->pressure->self, v, &sum);
    return exact_sum_value(&sum.internal);
}

/* Fluid that has left the domain keeps its density. */
static void replace(struct moment *m, const struct plan_part *one, const struct view *v,
                    double *rho)
{
    const struct workspace *w = m->work;
    const int from = m->list->start[KIND_FLUID];
    const struct sum_field_job job = {
        .list = m->list, .record = w->record, .meets = one->part->as.filter->meets,
        .needs = one->part->as.filter->rows, .gather = one->part->as.filter->gather,
        .self = one->self, .kernel = m->plan->kernel[PART_DENSITY], .sum = w->sum,
    };
    const struct part_sums sums = {
        .v = v, .kind = KIND_FLUID, .n = m->list->start[KIND_FLUID + 1] - from,
        .owner = m->list->order + from, .sum = (const double (*)[PART_SUMS])(w->sum + from),
    };

    m->plan->engine->sum->field(&job);
    one->part->as.filter->densities(one->self, &sums, rho);
}

static int act(struct moment *m, const struct plan_part *one, double t, double *y)
{
    const struct plan *p = m->plan;
    double *book = y + layout_at(&m->layout, p->book.row) + p->book.work + one->slot;
    struct view v;

    if (rates_fields(m, t, y, &v) != STATUS_DONE)
        return status_fail(STATUS_FAILED, "%s cannot filter at t = %g s: %s", one->path, t,
                           moment_refusal(m));
    const double before = internal(p, &v);
    replace(m, one, &v, y + layout_at(&m->layout, p->row.density[KIND_FLUID]));
    *book += internal(p, &v) - before;
    return STATUS_DONE;
}

int moment_event(struct moment *m, double t, double *y)
{
    const struct plan *p = m->plan;

    for (int i = 0; i < p->parts; i++)
        if (is_due(&p->part[i], t))
            TRY(act(m, &p->part[i], t, y));
    return STATUS_DONE;
}
