/* mps-book.c -- what corrections do to y and to the book.
 *
 * Pressure, collisions, stabilisation and viscosity change velocities one after the other.  With
 * du_k of the k-th, u before and u' after the step, a particle's kinetic energy changes by
 *
 *     sum over k of m du_k . (u + u')/2                                           (M17)
 *
 * exactly: each has a column of its own, with what it gave to moving walls beside.  Pressure and
 * collisions of an incompressible fluid should give nothing, so that these columns tell what the
 * method makes (above 0) or loses.  Densities in y are those of the solved pressures: the
 * internal energy that the equation of state has there is stored nowhere in the fluid; the
 * column of pressure and continuity, `pressure_defect`, has its changes, and nothing else.
 * Laws that change nothing but densities do nothing here, so their powers are not booked. */
#include "eval/given.h"
#include "matter/eos.h"
#include "solved/mps-inside.h"

#include <math.h>

void mps_begin(struct mps *s)
{
    const size_t bytes = (size_t)s->moment->particles->n * sizeof *s->gave.push;

    for (int k = 0; k < MPS_WORKS; k++) {
        memset(s->gave.kick[k], 0, bytes);
        s->gave.walls[k] = 0;
    }
    memset(s->gave.push, 0, bytes);
}

void mps_apply(struct mps *s, enum mps_work what)
{
    struct near *at = &s->near;

    for (int i = 0; i < at->fluid; i++)
        for (int d = 0; d < DIM; d++) {
            const double du = s->du[i][d];
            s->gave.kick[what][mps_id(s, i)][d] += du;
            at->u[i][d] += du;
            at->x[i][d] += s->h * du;
        }
    near_images(at, s->list);
}

int mps_conserved(const struct plan *p)
{
    for (int i = 0; i < p->parts; i++)
        if (p->part[i].slot >= 0 && part_conserves(p->part[i].part))
            return p->book.work + p->part[i].slot;
    return -1;
}

static double internal(const struct mps *s, double t, const double *y)
{
    const struct plan_part *pressure = s->moment->plan->pressure;
    struct energy_sums e = { 0 };
    struct view v;

    moment_view(s->moment, t, y, &v);
    pressure->part->energy(pressure->self, &v, &e);
    return exact_sum_value(&e.internal);
}

/* Fluid outside of the domain is in no list: it falls, without a pressure. */
static void write_densities(const struct mps *s, double *to)
{
    const struct plan *p = s->moment->plan;
    const struct eos *eos = p->pressure->self;
    const struct list *l = s->list;

    for (int k = 0; k < KINDS; k++) {
        double *rho = p->row.density[k] < 0
                      ? NULL : to + layout_at(&s->moment->layout, p->row.density[k]);
        const int n = particles_count(s->moment->particles, (enum kind)k);
        for (int i = 0; i < n && rho; i++)
            rho[i] = eos->rho0;
        for (int i = l->start[k]; i < l->start[k + 1] && rho; i++) {
            const double of = eos_density(eos, s->p[i]);
            rho[l->order[i] - s->moment->particles->from[k]] =
                of > s->moment->density[0] ? of : s->moment->density[0];
        }
    }
}

static void write_motion(const struct mps *s, double *to)
{
    const struct moment *m = s->moment;
    double *x = to + layout_at(&m->layout, m->plan->row.x);
    double *u = to + layout_at(&m->layout, m->plan->row.u);

    for (int i = 0; i < s->near.fluid; i++)
        for (int d = 0; d < DIM; d++) {
            const size_t at = (size_t)s->list->order[i] * DIM + (size_t)d;
            x[at] = s->near.x[i][d] - (s->list->offset ? s->list->offset[i][d] : 0);
            u[at] = s->near.u[i][d];
        }
}

/* The book without what laws of densities gave in this step. */
static void forget_densities(const struct plan *p, const double *before, double *book)
{
    for (int i = 0; i < p->parts; i++)
        if (p->part[i].slot >= 0 && mps_density_law(p->part[i].part))
            book[p->book.work + p->part[i].slot] = before[p->book.work + p->part[i].slot];
}

/* (M17) */
static double work_of(const struct mps *s, enum mps_work what, const double *y, const double *to)
{
    const struct moment *m = s->moment;
    const long u = layout_at(&m->layout, m->plan->row.u);
    double work = s->gave.walls[what];

    for (int id = 0; id < particles_count(m->particles, KIND_FLUID); id++) {
        const int row = particles_row(m->particles, KIND_FLUID, id);
        for (int d = 0; d < DIM; d++) {
            const long at = u + (long)row * DIM + d;
            work += m->particles->m[row] * s->gave.kick[what][id][d] * 0.5 * (y[at] + to[at]);
        }
    }
    return work;
}

void mps_write(struct mps *s, double t, const double *y, double *to)
{
    const struct plan *p = s->moment->plan;
    double *book = to + layout_at(&s->moment->layout, p->book.row);
    const double before = internal(s, t, y);

    write_motion(s, to);
    write_densities(s, to);
    forget_densities(p, y + layout_at(&s->moment->layout, p->book.row), book);
    book[mps_conserved(p)] += internal(s, t + s->h, to) - before;
    for (int k = 0; k < MPS_WORKS; k++) {
        book[s->gave.column[k]] += work_of(s, k, y, to);
        book[p->book.walls] -= s->gave.walls[k];
    }
    given_add(s->moment, s->h, (const double (*)[DIM])s->gave.push, book);
}
