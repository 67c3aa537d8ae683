/* lightest.h -- what diffuses fastest: the fluid particle of least density. */
#ifndef EFFECTS_LIGHTEST_H
#define EFFECTS_LIGHTEST_H

#include "state/part.h"

#include <math.h>

/* Its density [kg/m^D], HUGE_VAL without fluid; its id in *where. */
static inline double lightest_fluid(const struct view *v, int *where)
{
    const int n = particles_count(v->p, KIND_FLUID);
    double least = HUGE_VAL;

    for (int id = 0; id < n; id++) {
        const double rho = v->rho[KIND_FLUID][particles_row(v->p, KIND_FLUID, id)];
        if (rho < least) {
            least = rho;
            *where = id;
        }
    }
    return least;
}

#endif
