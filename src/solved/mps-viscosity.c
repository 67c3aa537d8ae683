/* mps-viscosity.c -- viscosity by the Laplacian of MPS.
 *
 *     du = dt nu 2 D/(lambda n0) sum (u_j - u_i) w(r_ij)                          (M3)
 *
 * over all neighbours, solids with their velocities: the fluid sticks to them.  Koshizuka and
 * Oka 1996. */
#include "solved/mps-inside.h"

#include <math.h>
#include <string.h>

/* What i gets by its neighbour k, as a factor of u_j - u_i. */
static double share(const struct mps *s, int i, size_t k)
{
    const struct weights *w = &s->laplacian;
    const double c = s->h * s->key->nu * 2 * DIM / (w->lambda * w->n0);
    double step[DIM];

    return c * weights_w(w, sqrt(near_step(&s->near, i, s->near.place[k], step)));
}

/* The solid in place j gets what fluid around it loses there. */
static void push_solid(struct mps *s, int j)
{
    const struct near *at = &s->near;

    for (size_t k = at->from[j]; k < at->from[j + 1]; k++) {
        const int i = at->origin[at->place[k]];
        double apart[DIM];
        if (i >= at->fluid)
            continue;
        for (int d = 0; d < DIM; d++)
            apart[d] = at->u[i][d] - at->u[j][d];
        mps_push(s, MPS_VISCOSITY, j, mps_mass(s, i) * share(s, j, k), apart);
    }
}

void mps_viscosity(struct mps *s)
{
    const struct near *at = &s->near;

#pragma omp parallel for schedule(static)
    for (int i = 0; i < at->fluid; i++) {
        memset(s->du[i], 0, sizeof s->du[i]);
        for (size_t k = at->from[i]; k < at->from[i + 1]; k++) {
            const int j = at->origin[at->place[k]];
            const double by = share(s, i, k);
            for (int d = 0; d < DIM; d++)
                s->du[i][d] += by * (at->u[j][d] - at->u[i][d]);
        }
    }
    for (int j = at->fluid; j < at->n; j++)
        push_solid(s, j);
}
