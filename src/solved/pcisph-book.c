/* pcisph-book.c -- energy and steps where densities stand for pressures.
 *
 * No law moves densities, so works of such laws are 0 but for the density's own: it gives
 * what the equation of state stores more after a step than before.  The column
 * `pressure_defect` is then all that the pressure gave or took and what is stored of it:
 * 0 for a fluid that is truly incompressible. */
#include "solved/pcisph-inside.h"

#include "eval/observe.h"

#include <stdio.h>
#include <string.h>

static bool only_densities(const struct part *part)
{
    return part->as.law && part->as.law->columns == COLUMN_DRHO;
}

/* What the equation of state stores [J], in the order of ids. */
static double stored(const struct pcisph *p, const double *y)
{
    const struct plan *plan = p->m->plan;
    const struct particles *all = p->m->particles;
    double energy = 0;

    for (int k = 0; k < KINDS; k++)
        for (int id = 0; id < particles_count(all, k); id++) {
            const int i = particles_row(all, k, id);
            energy += all->m[all->from[k] + i]
                    * eos_energy(p->eos, y[layout_at(&p->m->layout, plan->row.density[k]) + i]);
        }
    return energy;
}

void pcisph_settle(const struct pcisph *p, double h, const double *y_old, const double *y,
                   double *rates)
{
    const struct plan *plan = p->m->plan;
    double *book = rates + layout_at(&p->m->layout, plan->book.row) + plan->book.work;

    for (int k = 0; k < KINDS; k++)
        if (particles_count(p->m->particles, k) > 0)
            memset(rates + layout_at(&p->m->layout, plan->row.density[k]), 0,
                   (size_t)particles_count(p->m->particles, k) * sizeof *rates);
    for (int i = 0; i < plan->parts; i++) {
        const struct plan_part *one = &plan->part[i];
        if (!only_densities(one->part) || one->slot < 0)
            continue;
        book[one->slot] = one->part->provides & FIELD_DENSITY
                        ? (stored(p, y) - stored(p, y_old)) / h : 0;
    }
}

double pcisph_pace(const struct pcisph *p)
{
    return p->m->plan->scales.hs / p->m->plan->scales.speed;
}

void pcisph_decay(const struct pcisph *p, double t, const double *y, struct limit *out)
{
    const struct plan *plan = p->m->plan;
    struct view v;

    *out = (struct limit){ .where = -1, .decay = true };
    observe_fluid(p->m, t, y, &v);
    for (int i = 0; i < plan->parts; i++) {
        const struct part *part = plan->part[i].part;
        struct limit one = { .where = -1 };
        if (!part->limit || only_densities(part) || part->as.source)
            continue;
        part->limit(plan->part[i].self, &v, &one);
        if (!one.decay || !(one.rate > out->rate))
            continue;
        *out = one;
        snprintf(out->part, sizeof out->part, "%.63s", part->name);
    }
}
