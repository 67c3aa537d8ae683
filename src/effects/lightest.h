/* lightest.h -- what diffuses fastest: the fluid particle of least density. */
#ifndef EFFECTS_LIGHTEST_H
#define EFFECTS_LIGHTEST_H

#include "state/part.h"

#include <math.h>

/* Its density [kg/m^D], HUGE_VAL without fluid; its id is where it limits. */
static inline double lightest_fluid(const struct view *v, struct limit *out)
{
    const int n = particles_count(v->p, KIND_FLUID) - v->others;
    const int *id = v->p->id[KIND_FLUID];
    double least = HUGE_VAL;

    for (int i = 0; i < n; i++) {
        const double rho = v->rho[KIND_FLUID][i];
        const int name = id ? id[i] : i;
        if (rho < least || (rho == least && name < out->where)) {
            least = rho;
            out->where = name;
        }
    }
    out->found = -least;
    return least;
}

#endif
