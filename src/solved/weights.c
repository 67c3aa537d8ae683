/* weights.c -- sums over the lattice: those over a continuum are 10 to 90 % off. */
#include "solved/weights.h"

#include <math.h>

/* Adds the neighbour at these whole steps. */
static void add(struct weights *s, const int *step, double l0)
{
    double square = 0;

    for (int d = 0; d < DIM; d++)
        square += step[d] * step[d] * l0 * l0;
    const double r = sqrt(square), w = weights_w(s, r);
    s->n0 += w;
    s->lambda += square * w;
    s->inverse += w > 0 ? s->re / r : 0;
}

struct weights weights_of(double re, double l0)
{
    struct weights s = { .re = re };
    const int most = (int)(re / l0) + 1, side = 2 * most + 1;
    int sites = 1;

    for (int d = 0; d < DIM; d++)
        sites *= side;
    for (int k = 0; k < sites; k++) {
        int step[DIM], left = k;
        for (int d = 0; d < DIM; d++) {
            step[d] = left % side - most;
            left /= side;
        }
        add(&s, step, l0);
    }
    s.lambda /= s.n0;
    s.kappa = s.inverse / (DIM * s.n0);
    return s;
}
