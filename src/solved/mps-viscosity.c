/* mps-viscosity.c -- viscosity by the Laplacian of MPS.
 *
 *     du = dt nu 2 D/(lambda n0) sum (u_j - u_i) w(r_ij)                          (M3)
 *
 * over all neighbours, solids with their velocities: the fluid sticks to them.  Koshizuka and
 * Oka 1996. */
#include "solved/mps-inside.h"

#include <math.h>
#include <string.h>

void mps_viscosity(struct mps *s)
{
    const struct near *at = &s->near;
    const struct weights *w = &s->laplacian;
    const double c = s->h * s->key->nu * 2 * DIM / (w->lambda * w->n0);

#pragma omp parallel for schedule(static)
    for (int i = 0; i < at->fluid; i++) {
        double step[DIM];
        memset(s->du[i], 0, sizeof s->du[i]);
        for (size_t k = at->from[i]; k < at->from[i + 1]; k++) {
            const int j = at->origin[at->place[k]];
            const double by = c * weights_w(w, sqrt(near_step(at, i, at->place[k], step)));
            for (int d = 0; d < DIM; d++)
                s->du[i][d] += by * (at->u[j][d] - at->u[i][d]);
        }
    }
}
