/* probe.c -- gauges: pressure, velocity, height of the water. */
#include "measure/probe.h"

#include <math.h>

/* Wendland's C2 function without its constant, which a mean does not need. */
static double weight(const double *x, const double *y, double support)
{
    double r2 = 0, rest;

    for (int d = 0; d < DIM; d++)
        r2 += (x[d] - y[d]) * (x[d] - y[d]);
    if (!(r2 < support * support))
        return 0;
    rest = 1 - sqrt(r2) / support;
    return rest * rest * rest * rest * (5 - 4 * rest);
}

/* mean [components] of value [n][components] of the fluid around x */
static void mean(const struct view *v, const double *value, int components, const double *x,
                 double *to)
{
    const int n = particles_count(v->p, KIND_FLUID);
    const double *y = v->x[KIND_FLUID];
    double sum = 0;

    for (int k = 0; k < components; k++)
        to[k] = 0;
    for (long i = 0; i < n; i++) {
        const double w = weight(x, y + DIM * i, v->p->scales->support);
        sum += w;
        for (int k = 0; w > 0 && k < components; k++)
            to[k] += w * value[components * i + k];
    }
    for (int k = 0; sum > 0 && k < components; k++)
        to[k] /= sum;
}

double probe_pressure(const struct view *v, const double *p, const double *x)
{
    double found;

    mean(v, p, 1, x, &found);
    return found;
}

void probe_velocity(const struct view *v, const double *x, double *u)
{
    mean(v, v->u[KIND_FLUID], DIM, x, u);
}

static bool is_near(const double *x, const double *y, int axes, double support)
{
    double r2 = 0;

    for (int d = 0; d < axes; d++)
        r2 += (x[d] - y[d]) * (x[d] - y[d]);
    return r2 <= support * support;
}

double probe_height(const struct crowd *c, const double *x, int axes)
{
    const struct view *v = crowd_view(c);
    const struct scales *s = v->p->scales;
    const int n = particles_count(v->p, KIND_FLUID);
    double best = s->low[DIM - 1];

    for (int i = 0; i < n; i++) {
        const double *y = v->x[KIND_FLUID] + DIM * (long)i;
        if (y[DIM - 1] > best && is_near(x, y, axes, s->support) && crowd_is_water(c, i))
            best = y[DIM - 1];
    }
    return best - s->low[DIM - 1];
}
