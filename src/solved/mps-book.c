/* mps-book.c -- what corrections do to y and to the book.
 *
 * Pressure, collisions and stabilisation of an incompressible fluid should do no work but on
 * walls that move.  What they do beside is written where pressure and continuity keep theirs,
 * so that `pressure_defect` tells what the method makes (above 0) or loses.  Densities in y are
 * those of the solved pressures: the internal energy that the equation of state has there is
 * stored nowhere in the fluid, and is taken out by the same column.  Laws that change nothing
 * but densities do nothing here, so their powers are not booked. */
#include "matter/eos.h"
#include "solved/mps-inside.h"

#include <math.h>

void mps_apply(struct mps *s)
{
    struct near *at = &s->near;
    const double *g = s->moment->plan->scales.g;

    for (int i = 0; i < at->fluid; i++) {
        const double m = mps_mass(s, i);
        for (int d = 0; d < DIM; d++) {
            const double du = s->du[i][d];
            s->made += m * (du * (at->u[i][d] + 0.5 * du) - g[d] * s->h * du);
            at->u[i][d] += du;
            at->x[i][d] += s->h * du;
        }
    }
    near_images(at, s->list);
}

/* Where the powers of pressure and continuity are booked. */
static int column(const struct plan *p)
{
    for (int i = 0; i < p->parts; i++)
        if (p->part[i].slot >= 0 && part_conserves(p->part[i].part))
            return p->book.work + p->part[i].slot;
    return -1;
}

static double internal(const struct mps *s, double t, const double *y)
{
    const struct plan_part *pressure = s->moment->plan->pressure;
    struct energies e = { 0 };
    struct view v;

    moment_view(s->moment, t, y, &v);
    pressure->part->energy(pressure->self, &v, &e);
    return e.internal;
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
                of > s->moment->density_low ? of : s->moment->density_low;
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

void mps_write(struct mps *s, double t, const double *y, double *to)
{
    const struct plan *p = s->moment->plan;
    double *book = to + layout_at(&s->moment->layout, p->book.row);
    const double before = internal(s, t, y);

    write_motion(s, to);
    write_densities(s, to);
    forget_densities(p, y + layout_at(&s->moment->layout, p->book.row), book);
    book[column(p)] += s->made + s->walls + internal(s, t + s->h, to) - before;
    book[p->book.walls] -= s->walls;
    for (int o = 0; o < p->particles->objects; o++)
        for (int d = 0; d < DIM; d++)
            book[p->book.impulse + o * DIM + d] += s->push[o][d];
}
