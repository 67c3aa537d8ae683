/* lightest.h -- what diffuses fastest: the fluid particle of least density. */
#ifndef EFFECTS_LIGHTEST_H
#define EFFECTS_LIGHTEST_H

#include "state/part.h"

#include <math.h>

/* Its density [kg/m^D], HUGE_VAL without fluid; its number in *where. */
static inline double lightest_fluid(const struct view *v, int *where)
{
    const int n = particles_count(v->p, KIND_FLUID);
    double least = HUGE_VAL;

    for (int i = 0; i < n; i++)
        if (v->rho[KIND_FLUID][i] < least) {
            least = v->rho[KIND_FLUID][i];
            *where = i;
        }
    return least;
}

#endif
