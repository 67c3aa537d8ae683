/* probe.c -- gauges: pressure, velocity, height of the water. */
#include "measure/probe.h"

#include "state/period.h"

#include <math.h>

/* Wendland's C2 function without its constant, which a mean does not need. */
static double weight(const struct scales *s, const double *x, const double *y)
{
    const double r2 = period_square(s, x, y, DIM);
    double rest;

    if (!(r2 < s->support * s->support))
        return 0;
    rest = 1 - sqrt(r2) / s->support;
    return rest * rest * rest * rest * (5 - 4 * rest);
}

/* Weighted sums around x of value [count of fluid][components]. */
struct mean {
    const struct scales *scales;
    const double *x, *y, *value;
    double weight, sum[DIM];
    int components;
};

static void add(void *self, int i)
{
    struct mean *m = self;
    const double w = weight(m->scales, m->x, m->y + DIM * (long)i);

    m->weight += w;
    for (int k = 0; w > 0 && k < m->components; k++)
        m->sum[k] += w * m->value[(long)m->components * i + k];
}

static struct mean mean_make(const struct crowd *c, const double *value, int components,
                             const double *x)
{
    const struct view *v = crowd_view(c);
    struct mean m = { .scales = v->p->scales, .x = x, .y = v->x[KIND_FLUID], .value = value,
                      .components = components };

    crowd_near(c, x, add, &m);
    return m;
}

/* Weights of a full surrounding: the integral of w over the support, by the
 * volume of a particle. */
static double full(const struct scales *s)
{
    const double h = s->support / s->dx;

    return DIM == 2 ? M_PI / 7 * h * h : 2 * M_PI / 21 * h * h * h;
}

double probe_pressure(const struct crowd *c, const double *p, const double *x)
{
    const struct mean m = mean_make(c, p, 1, x);

    return m.sum[0] / fmax(m.weight, full(crowd_view(c)->p->scales) / 16);
}

void probe_velocity(const struct crowd *c, const double *x, double *u)
{
    const struct mean m = mean_make(c, crowd_view(c)->u[KIND_FLUID], DIM, x);

    for (int d = 0; d < DIM; d++)
        u[d] = m.weight > 0 ? m.sum[d] / m.weight : 0;
}

static bool is_near(const struct scales *s, const double *x, const double *y, int axes)
{
    return period_square(s, x, y, axes) <= s->support * s->support;
}

/* The water's highest particle above the domain's lowest point [m], 0 when there is none. */
static double top_of(const struct crowd *c, const double *x, int axes)
{
    const struct view *v = crowd_view(c);
    const struct scales *s = v->p->scales;
    const int n = particles_count(v->p, KIND_FLUID);
    double best = s->low[DIM - 1];

    for (int i = 0; i < n; i++) {
        const double *y = v->x[KIND_FLUID] + DIM * (long)i;
        if (y[DIM - 1] > best && is_near(s, x, y, axes) && crowd_is_water(c, i))
            best = y[DIM - 1];
    }
    return best - s->low[DIM - 1];
}

double probe_height(const struct crowd *c, const double *x, int axes)
{
    const double top = top_of(c, x, axes);

    return top > 0 ? top + crowd_view(c)->p->scales->dx / 2 : 0;
}
