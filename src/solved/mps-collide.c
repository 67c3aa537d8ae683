/* mps-collide.c -- pairs that are too near to each other.
 *
 * Collisions: where r < a l0 and the pair approaches, with restitution e and masses of both
 * (a solid's is infinite), n from i to j:
 *
 *     du_i = (1 + e) m_j/(m_i + m_j) min(0, u_ij . n) n                           (M15)
 *
 * Dynamic stabilisation, where the pressure left a pair nearer than d = a l0: with e the
 * direction before, r_ij the way after, r_s and r_c its parts along and across e,
 *
 *     du_i = -1/(2 dt) (sqrt(d^2 - r_c^2) - r_s) e                                (M16)
 *
 * so that a pair is d apart after the step; Tsuruta, Khayyer and Gotoh, Comput. Fluids 82
 * (2013) 158-164, where w stands as a factor, too.  Both are sums over pairs, of velocities
 * before: no order of pairs counts. */
#include "solved/mps-inside.h"

#include <math.h>
#include <string.h>

/* What i gets by a pair, in units of the way from i to j. */
typedef double pair_change(const struct mps *s, const double *step, double r2,
                           const double *du, bool solid);

static double collide(const struct mps *s, const double *step, double r2, const double *du,
                      bool solid)
{
    const double a = s->key->collision_distance * s->moment->plan->scales.dx;
    double approach = 0;

    if (!(r2 < a * a) || !(r2 > 0))
        return 0;
    for (int d = 0; d < DIM; d++)
        approach += du[d] * step[d];
    return approach < 0 ? (1 + s->key->restitution) * (solid ? 1 : 0.5) * approach / r2 : 0;
}

/* Sums over pairs of i; solids j get what i loses. */
static void change(struct mps *s, int i, pair_change *by)
{
    const struct near *at = &s->near;
    double step[DIM], apart[DIM];

    memset(s->du[i], 0, sizeof s->du[i]);
    for (size_t k = at->from[i]; k < at->from[i + 1]; k++) {
        const int j = at->origin[at->place[k]];
        const double r2 = near_step(at, i, at->place[k], step);
        for (int d = 0; d < DIM; d++)
            apart[d] = at->u[j][d] - at->u[i][d];
        const double c = by(s, step, r2, apart, j >= at->fluid);
        for (int d = 0; d < DIM; d++)
            s->du[i][d] += c * step[d];
        if (j >= at->fluid && c != 0)
            mps_push(s, MPS_COLLISIONS, j, -mps_mass(s, i) * c, step);
    }
}

void mps_collide(struct mps *s)
{
    for (int i = 0; i < s->near.fluid; i++)
        change(s, i, collide);
}

/* (M16) of a pair, as a factor of the way before. */
static double restore(const double *before, const double *after, double d2)
{
    double square = 0, along = 0, length = 0;

    for (int d = 0; d < DIM; d++) {
        length += before[d] * before[d];
        square += after[d] * after[d];
        along += after[d] * before[d];
    }
    if (!(length > 0) || !(square < d2))
        return 0;
    length = sqrt(length);
    along /= length;
    const double across = square - along * along;
    return (sqrt(fmax(d2 - across, 0)) - along) / length;
}

/* Solids give way to nobody: the fluid takes all of it there. */
void mps_stabilise(struct mps *s)
{
    const struct near *at = &s->near;
    const double d0 = s->key->ds_distance * s->moment->plan->scales.dx;

    for (int i = 0; i < at->fluid; i++) {
        memset(s->du[i], 0, sizeof s->du[i]);
        for (size_t k = at->from[i]; k < at->from[i + 1]; k++) {
            const int j = at->origin[at->place[k]];
            double after[DIM], was[DIM];
            if (!(near_step(at, i, at->place[k], after) < d0 * d0))
                continue;
            for (int d = 0; d < DIM; d++) /* images moved as their originals did */
                was[d] = after[d] - (at->x[j][d] - s->was[j][d]) + (at->x[i][d] - s->was[i][d]);
            const double c = -restore(was, after, d0 * d0) / (2 * s->h)
                             * (j >= at->fluid ? 2 : 1);
            for (int d = 0; d < DIM; d++)
                s->du[i][d] += c * was[d];
            if (j >= at->fluid)
                mps_push(s, MPS_STABILISATION, j, -mps_mass(s, i) * c, was);
        }
    }
}
