/* pcisph.c -- prediction and correction: the pressure of a step.
 *
 *   v* = v + h (a - G P/m),  x* = x + h v*                                    (PC1)
 *   rho*_i = sum over j of m_j W_d(x*_i - x*_j), j = i included               (PC2)
 *   P_i <- max(0, P_i + delta (rho*_i - rho_L)),  delta = gain/(2 h^2 m^2 B)  (PC5)
 *
 * until no particle of the fluid has rho* > (1 + limit) rho_L; P = p/rho^2, G of
 * space/nabla.h at x, rho_L and B of a full lattice.  Solids have a P of their own and move
 * as they are told.  x* of the last P is where the step ends, so that the limit holds
 * there; Solenthaler and Pajarola stop one correction later than they look.
 *
 * The list is made at x in each step, wide enough for x*, so that P is a function of
 * (x, v, a, h) and of nothing before.
 *
 * Solenthaler, Pajarola, ACM Trans. Graph. 28 (2009) 40; Toth 2012, (21), (22).  Checked in
 * tests/unit/pcisph.c. */
#include "solved/pcisph-inside.h"

#include "base/status.h"
#include "space/record.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ALL_KINDS = KIND_BIT(KINDS) - 1, WORTH = 4096 };

/* --- places ---------------------------------------------------------------------- */

/* The place of what image s shows; of a particle, its own. */
static int original(const struct list *l, int s)
{
    return l->slot[l->order[s]];
}

static enum kind kind_of(const struct particles *all, int c)
{
    return all->object[all->object_of[c]].kind;
}

/* Where a place will be after h [m]: of the fluid by (PC1). */
static void predict(const struct pcisph *p, const struct view *v, double h, const double *a,
                    int s, double *x)
{
    const int c = p->list->order[s];
    const enum kind k = kind_of(v->p, c);
    const size_t i = (size_t)(c - v->p->from[k]) * DIM;
    const double *push = p->push + (size_t)original(p->list, s) * DIM;

    for (int d = 0; d < DIM; d++) {
        double u = v->u[k][i + (size_t)d];
        if (k == KIND_FLUID)
            u += h * (a[i + (size_t)d] - push[d] / v->p->m[c]);
        x[d] = v->x[k][i + (size_t)d] + h * u;
        if (p->list->offset)
            x[d] += p->list->offset[s][d];
    }
}

/* Records of all places after h; 0: as they are. */
static void write_records(const struct pcisph *p, const struct view *v, double h, const double *a,
                          double *record)
{
    const struct list *l = p->list;

#pragma omp parallel for schedule(static) if (l->listed > WORTH)
    for (int s = 0; s < l->listed; s++) {
        double *r = record + (size_t)s * RECORD, x[DIM];
        predict(p, v, h, a, s, x);
        r[RECORD_X] = x[0];
        r[RECORD_X + 1] = x[1];
#if DIM == 3
        r[RECORD_Z] = x[2];
#endif
        r[RECORD_M] = v->p->m[l->order[s]];
        r[RECORD_RHO] = r[RECORD_IRHO] = 1;
    }
    pack_far(p->m->plan, 0, record + (size_t)l->listed * RECORD);
}

/* --- the iteration ---------------------------------------------------------------- */

static struct nabla_job job_of(const struct pcisph *p, const double *record,
                               const struct kernel_use *kernel)
{
    return (struct nabla_job){ .list = p->list, .record = record, .meets = p->meets,
                               .kernel = kernel };
}

/* (PC2) of a place, and what it is above that of a full lattice [kg/m^D]. */
static double excess(const struct pcisph *p, int s)
{
    const double m = p->m->particles->m[p->list->order[s]];

    return p->sum[s] / m + m * kernel_w(p->density, 0) - p->full;
}

static struct pcisph_worst look(const struct pcisph *p)
{
    struct pcisph_worst worst = { 0, -1 };

    for (int s = p->list->start[KIND_FLUID]; s < p->list->start[KIND_FLUID + 1]; s++) {
        const double compression = excess(p, s) / p->full;
        if (compression > worst.compression || !isfinite(compression))
            worst = (struct pcisph_worst){ compression, s };
        if (!isfinite(compression))
            break;
    }
    return worst;
}

static struct pcisph_worst weigh(struct pcisph *p, const struct view *v, double h, const double *a)
{
    const struct nabla_job job = job_of(p, p->there, p->density);

    write_records(p, v, h, a, p->there);
    p->m->plan->engine->nabla->weights(&job, ALL_KINDS, p->ones, p->sum);
    p->m->counts.passes++;
    return look(p);
}

/* (PC5), and what it pushes the fluid with. */
static void correct(struct pcisph *p, double h)
{
    const struct list *l = p->list;
    const double m = p->m->plan->scales.mass;
    const double delta = p->set->gain / (2 * h * h * m * m * p->response);
    const struct nabla_job job = job_of(p, p->here, p->force);

    for (int s = 0; s < l->start[KINDS]; s++)
        p->P[s] = fmax(0, p->P[s] + delta * excess(p, s));
    for (int s = l->start[KINDS]; s < l->listed; s++)
        p->P[s] = p->P[original(l, s)];
    p->m->plan->engine->nabla->gradient(&job, KIND_BIT(KIND_FLUID), p->P, p->push);
    p->m->counts.passes++;
}

static int refuse(struct pcisph *p, const struct view *v, int iterations, double h,
                  const struct pcisph_worst *worst)
{
    const int c = p->list->order[worst->place];
    char place[PLAN_PLACE], much[48] = "no longer finite";

    moment_place(p->m, v, c, place);
    if (isfinite(worst->compression))
        snprintf(much, sizeof much, "%.3g %% too dense (limit %g %%)", 100 * worst->compression,
                 100 * p->set->limit);
    snprintf(p->m->refusal, sizeof p->m->refusal, "no pressure found: after %d "
             "iterations of a step of %.3g s fluid particle %d (%.40s) at %.60s m is %s. They "
             "diverge when delta is too large for the kernels (pcisph.gain, kernel.support above "
             "3 spacings, two kernels), are slow when particles meet fast (shorter steps, a higher "
             "pcisph.most), and in vain when water starts too dense (pcisph.limit)", iterations, h, particles_id_of(v->p, c),
             v->p->object[v->p->object_of[c]].name, place, much);
    p->m->counts.refused++;
    return STATUS_FAILED;
}

static int iterate(struct pcisph *p, const struct view *v, double h, const double *a)
{
    for (int k = 0;; k++) {
        const struct pcisph_worst worst = weigh(p, v, h, a);
        if (!isfinite(worst.compression))
            return refuse(p, v, k, h, &worst);
        if (k >= p->set->least && worst.compression <= p->set->limit) {
            p->m->counts.compression = fmax(p->m->counts.compression, worst.compression);
            return STATUS_DONE;
        }
        if (k == p->set->most)
            return refuse(p, v, k, h, &worst);
        correct(p, h);
        p->m->counts.iterations++;
    }
}

/* --- densities of the pressure ----------------------------------------------------- */

/* rho^2 hardly changes. */
double pcisph_density_of(const struct eos *eos, double P)
{
    double rho = eos->rho0;

    for (int i = 0; i < 12; i++)
        rho = eos_density(eos, P * rho * rho);
    return rho;
}

static int refuse_pressure(struct pcisph *p, int c, double P)
{
    snprintf(p->m->refusal, sizeof p->m->refusal, "no density has the pressure %g Pa that was "
             "found for particle %d; a higher eos.c0 has one",
             P * p->eos->rho0 * p->eos->rho0, particles_id_of(p->m->particles, c));
    return STATUS_FAILED;
}

/* Particles outside the domain have no pressure. */
static int write_densities(struct pcisph *p, double *y)
{
    const struct particles *all = p->m->particles;

    for (int c = 0; c < all->n; c++) {
        const enum kind k = kind_of(all, c);
        const int s = p->list->slot[c];
        double *rho = y + layout_at(&p->m->layout, p->m->plan->row.density[k]) + c - all->from[k];

        *rho = s < 0 ? p->eos->rho0 : pcisph_density_of(p->eos, p->P[s]);
        if (!isfinite(*rho))
            return refuse_pressure(p, c, p->P[s]);
    }
    return STATUS_DONE;
}

int pcisph_solve(struct pcisph *p, double t, double h, const double *rates, double *y)
{
    const struct list_engine *lists = p->m->plan->engine->sum->list;
    const double *a = rates + layout_at(&p->m->layout, p->m->plan->row.u);
    struct cloud cloud = { 0 };
    struct view v;

    moment_view(p->m, t, y, &v);
    memcpy(cloud.from, v.p->from, sizeof cloud.from);
    memcpy(cloud.x, v.x, sizeof cloud.x);
    memcpy(cloud.row, v.p->row, sizeof cloud.row);
    list_forget(p->list);
    TRY(lists->update(p->list, &cloud));
    TRY(pcisph_fit(p));
    write_records(p, &v, 0, a, p->here);
    TRY(iterate(p, &v, h, a));
    return write_densities(p, y);
}
