/* period.h -- places and distances where directions repeat. */
#ifndef STATE_PERIOD_H
#define STATE_PERIOD_H

#include "state/scales.h"

#include <math.h>

/* x [DIM] brought into the domain by whole lengths; as it is where nothing repeats. */
static inline void period_home(const struct scales *s, const double *x, double *to)
{
    for (int d = 0; d < DIM; d++) {
        to[d] = x[d];
        if (s->period[d] > 0)
            to[d] -= s->period[d] * floor((x[d] - s->low[d]) / s->period[d]);
    }
}

/* A distance along d, by the nearest image [m]. */
static inline double period_nearest(const struct scales *s, int d, double distance)
{
    if (s->period[d] > 0)
        distance -= s->period[d] * floor(distance / s->period[d] + 0.5);
    return distance;
}

/* Square of the distance of x and y in their first `axes` directions [m^2]. */
static inline double period_square(const struct scales *s, const double *x, const double *y,
                                   int axes)
{
    double sum = 0;

    for (int d = 0; d < axes; d++) {
        const double step = period_nearest(s, d, x[d] - y[d]);
        sum += step * step;
    }
    return sum;
}

#endif
