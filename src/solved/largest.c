/* largest.c -- one loop, by id. */
#include "solved/largest.h"

#include <math.h>

double largest_inside(const struct moment *m, const double *y, const double *vectors, int *where)
{
    const double *x = y + layout_at(&m->layout, m->plan->row.x);
    const double *u = vectors + layout_at(&m->layout, m->plan->row.u);
    double most = 0;

    for (int id = 0; id < particles_count(m->particles, KIND_FLUID); id++) {
        const size_t at = (size_t)particles_row(m->particles, KIND_FLUID, id) * DIM;
        double square = 0;
        for (size_t d = 0; d < DIM; d++)
            square += u[at + d] * u[at + d];
        if (square > most && list_inside(&m->plan->list_def, x + at)) {
            most = square;
            *where = id;
        }
    }
    return sqrt(most);
}
