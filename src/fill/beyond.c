/* beyond.c -- points near a place over periodic sides. */
#include "fill/beyond.h"

#include <math.h>

/* Number k of the 2^DIM images of x that are nearest to the middle of the domain: over the
 * sides whose bits are set in k.  False: one of them does not repeat, or is too far away. */
static bool image(const struct scales *s, const double *x, int k, double reach, double *to)
{
    for (int d = 0; d < DIM; d++) {
        const double middle = 0.5 * (s->low[d] + s->high[d]);
        to[d] = x[d];
        if (!(k >> d & 1))
            continue;
        to[d] += x[d] < middle ? s->period[d] : -s->period[d];
        if (!(s->period[d] > 0) || fabs(to[d] - middle) >= 0.5 * s->period[d] + reach)
            return false;
    }
    return true;
}

int beyond_find(const struct buckets *b, const struct scales *s, const double *x, double reach,
                bool (*counts)(const void *self, int j), const void *self)
{
    double to[DIM];
    int j = -1;

    for (int k = 1; k < 1 << DIM && j < 0; k++)
        if (image(s, x, k, reach, to))
            j = buckets_find(b, to, reach, counts, self);
    return j;
}
