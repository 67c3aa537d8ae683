/* blame.c -- when a run fails: who is pushed hardest, and by which part. */
#include "plan/inside.h"
#include "plan/observe.h"

#include "base/status.h"
#include "state/period.h"
#define LANES 2 /* only sizes without lanes are used here */
#include "space/pairs.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double size_of(const double *v)
{
    double square = 0;

    for (int d = 0; d < DIM; d++)
        square += v[d] * v[d];
    return sqrt(square);
}

/* The tables with the laws of one slot only. */
static void keep_slot(const struct plan *p, int slot, struct pairs_table *table)
{
    for (int i = 0; i < KINDS * KINDS; i++) {
        const struct pairs_table *all = &p->table[i];
        struct pairs_table *one = &table[i];

        one->n = 0;
        one->needs = all->needs;
        for (int k = 0; k < all->n; k++)
            if (all->work[k].slot == slot) {
                one->work[one->n] = all->work[k];
                one->work[one->n++].needs = all->needs;
            }
    }
}

/* Accelerations of the fluid by the laws of one slot (-1: by all). */
static int forces_of(struct plan *p, struct plan_workspace *w, int slot,
                     struct pairs_table *table)
{
    struct sum_job job = {
        .list = w->list, .record = w->record, .table = p->table, .slots = p->slots,
        .f = w->f, .drho = w->drho, .power = w->power,
    };

    if (slot >= 0) {
        keep_slot(p, slot, table);
        job.table = table;
    }
    return p->engine->sum->pairs(&job, &w->scratch);
}

static int hardest(const struct plan *p, const struct plan_workspace *w)
{
    double most = -1;
    int where = -1;

    for (int s = w->list->start[KIND_FLUID]; s < w->list->start[KIND_FLUID + 1]; s++) {
        const double a = size_of(w->f + (size_t)s * DIM) / p->particles->m[w->list->order[s]];
        if (a > most) {
            most = a;
            where = s;
        }
    }
    return where;
}

/* A mass that does not fill its site presses everybody from the start. */
static void doubt_mass(const struct plan *p, char *text, size_t room)
{
    const double site = p->scales.rho0 * pow(p->scales.dx, DIM);

    if (fabs(p->scales.mass / site - 1) > 0.05)
        snprintf(text, room, "; particle_mass = %g, but a site of this spacing holds %g at rest",
                 p->scales.mass, site);
}

static void tell(const struct plan *p, const struct view *v, const struct plan_workspace *w,
                 int slot, const struct plan_part *part, double a, char *text, size_t room)
{
    const int c = w->list->order[slot];
    const double *u = v->u[KIND_FLUID] + (size_t)c * DIM;
    char z[32] = "", mass[160] = "";
    double x[DIM];

    period_home(&p->scales, v->x[KIND_FLUID] + (size_t)c * DIM, x);
    if (DIM == 3)
        snprintf(z, sizeof z, ", %g", x[DIM - 1]);
    doubt_mass(p, mass, sizeof mass);
    snprintf(text, room, "at t = %g s particle %d (%s) at (%g, %g%s) m is pushed hardest: %s (%s) "
             "alone gives it %.3g m/s^2; its density is %.4g kg/m^3, its speed %.3g m/s, the sound "
             "speed %g m/s%s", v->t, c, p->particles->object[p->particles->object_of[c]].name,
             x[0], x[1], z, part->path, part->part->about, a,
             v->rho[KIND_FLUID] ? v->rho[KIND_FLUID][c] : p->scales.rho0, size_of(u),
             p->scales.c0, mass);
}

static int blame(struct plan *p, struct plan_workspace *w, const struct view *v,
                 struct pairs_table *table, char *text, size_t room)
{
    const struct plan_part *worst = NULL;
    double most = -1;
    int slot;

    TRY(forces_of(p, w, -1, table));
    slot = hardest(p, w);
    for (int i = 0; i < p->parts && slot >= 0; i++) {
        double a;
        if (p->part[i].slot < 0)
            continue;
        TRY(forces_of(p, w, p->part[i].slot, table));
        a = size_of(w->f + (size_t)slot * DIM) / p->particles->m[w->list->order[slot]];
        if (a > most) {
            most = a;
            worst = &p->part[i];
        }
    }
    if (worst)
        tell(p, v, w, slot, worst, most, text, room);
    return STATUS_DONE;
}

void plan_blame(struct plan *p, double t, const double *y, char *text, size_t room)
{
    struct pairs_table *table = calloc(KINDS * KINDS, sizeof *table);
    struct plan_workspace w = { 0 };
    struct view v;

    text[0] = '\0';
    plan_view_make(p, t, y, &v);
    if (table && p->row_x >= 0 && plan_workspace_make(p, &w) == STATUS_DONE
        && plan_fields(p, &w, &v) == STATUS_DONE)
        blame(p, &w, &v, table, text, room);
    plan_workspace_free(p, &w);
    free(table);
    status_clear();
}
