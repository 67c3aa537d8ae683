/* solids.c -- what the fluid does to solids: forces on them, and the power of walls. */
#include "eval/face.h"
#include "eval/inside.h"

#include <string.h>

static const double *force_on(const struct moment *m, int row)
{
    return m->work->wet.f[row - m->particles->from[KIND_WALL]];
}

/* What the fluid's forces do on a wall that moves [W]. */
static double power_of(const struct moment *m, int object)
{
    double power = 0;

    for (int k = 0; k < wet_rows(m, object); k++) {
        const int row = wet_row(m, object, k);
        for (int d = 0; d < DIM; d++)
            power += force_on(m, row)[d] * m->particles->u[row][d];
    }
    return power;
}

/* The force on an object, added in order of ids: in a sum of its own, as one in memory would be
 * waited for by each particle. */
static void sum_object(const struct moment *m, int object, double *force)
{
    const int n = wet_rows(m, object);
    double sum[DIM] = { 0 };

    for (int k = 0; k < n; k++) {
        const double *f = force_on(m, wet_row(m, object, k));
        for (int d = 0; d < DIM; d++)
            sum[d] += f[d];
    }
    memcpy(force, sum, sizeof sum);
}

void solids_turn(const double *about, const double *x, const double *f, double turn[3])
{
    double arm[3] = { 0 };

    for (int d = 0; d < DIM; d++)
        arm[d] = x[d] - about[d];
    turn[2] += arm[0] * f[1] - arm[1] * f[0];
    if (DIM == 3) {
        turn[0] += arm[1] * f[2] - arm[2] * f[1];
        turn[1] += arm[2] * f[0] - arm[0] * f[2];
    }
}

/* Forces on a part of a solid, added in order of ids. */
static void sum_panel(struct moment *m, const struct plan_panel *p, double *sum, double turn[3])
{
    for (int k = 0; k < p->n; k++) {
        const int row = particles_row_of(m->particles, p->id[k]);
        const double *f = force_on(m, row);
        for (int d = 0; d < DIM; d++)
            sum[d] += f[d];
        solids_turn(p->about, m->particles->x[row], f, turn);
    }
}

static void sum_panels(struct moment *m)
{
    const int first = m->particles->objects;

    memset(m->force + first, 0, (size_t)m->plan->book.panels * sizeof *m->force);
    memset(m->turn, 0, (size_t)m->plan->book.panels * sizeof *m->turn);
    for (int i = 0; i < m->plan->book.panels; i++)
        sum_panel(m, &m->plan->book.panel[i], m->force[first + i], m->turn[i]);
}

void solids_sum(struct moment *m)
{
    const struct particles *all = m->particles;
    const struct plan *p = m->plan;

    memset(m->force, 0, all->objects * sizeof *m->force);
    m->wall_power = 0;
    for (int i = 0; i < all->objects; i++)
        if (all->object[i].kind != KIND_FLUID && all->object[i].n > 0) /* else there may be no list */
            sum_object(m, i, m->force[i]);
    sum_panels(m);
    for (int i = 0; i < p->walls; i++)
        if (p->wall[i].moves)
            m->wall_power += power_of(m, p->wall[i].object);
    if (m->face)
        m->wall_power += m->face->power;
}

void solids_skin(const struct moment *m, struct moment_body *b)
{
    for (int j = 0; j < b->skin; j++)
        memcpy(b->force[j], force_on(m, particles_row_of(m->particles,
                                                         m->particles->object[b->object].from + j)),
               sizeof b->force[j]);
}
