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

/* Weights of a full surrounding: the integral of w over the support, by the
 * volume of a particle. */
static double full(const struct scales *s)
{
    const double h = s->support / s->dx;

    return DIM == 2 ? M_PI / 7 * h * h : 2 * M_PI / 21 * h * h * h;
}

/* --- sums over the fluid around a point -------------------------------------------------- */

/* Of what there is in the rows of the view. */
struct looking {
    const struct scales *scales;
    const double *x, *y, *value;
    int components;
    struct exact_terms weight, sum[DIM];
};

static void add(void *self, int i)
{
    struct looking *l = self;
    const double w = weight(l->scales, l->x, l->y + DIM * (long)i);

    if (!(w > 0))
        return;
    exact_terms_add(&l->weight, w);
    for (int k = 0; k < l->components; k++)
        exact_terms_add(&l->sum[k], w * l->value[(long)l->components * i + k]);
}

/* Weighted sums around x of value [count of fluid][components]. */
static void sum_up(const struct crowd *c, const double *value, int components, const double *x,
                   struct probe_sums *to)
{
    const struct view *v = crowd_view(c);
    struct looking l = { .scales = v->p->scales, .x = x, .y = v->x[KIND_FLUID], .value = value,
                         .components = components, .weight = { .to = &to->weight } };

    *to = (struct probe_sums){ .components = components };
    for (int k = 0; k < components; k++)
        l.sum[k].to = &to->sum[k];
    crowd_near(c, x, add, &l);
    exact_terms_end(&l.weight);
    for (int k = 0; k < components; k++)
        exact_terms_end(&l.sum[k]);
}

void probe_sum_pressure(const struct crowd *c, const double *p, const double *x, struct probe_sums *to)
{
    sum_up(c, p, 1, x, to);
}

void probe_sum_velocity(const struct crowd *c, const double *x, struct probe_sums *to)
{
    sum_up(c, crowd_view(c)->u[KIND_FLUID], DIM, x, to);
}

void probe_share(int n, struct probe_sums *of)
{
    struct exact_sum *sum[PROBE_SHARED * (1 + DIM)];
    int sums = 0;

    for (int i = 0; i < n; i++) {
        sum[sums++] = &of[i].weight;
        for (int k = 0; k < of[i].components; k++)
            sum[sums++] = &of[i].sum[k];
    }
    exact_sum_share(sums, sum);
}

double probe_mean_pressure(const struct crowd *c, const struct probe_sums *s)
{
    return exact_sum_value(&s->sum[0])
           / fmax(exact_sum_value(&s->weight), full(crowd_view(c)->p->scales) / 16);
}

void probe_mean_velocity(const struct probe_sums *s, double *u)
{
    const double weight = exact_sum_value(&s->weight);

    for (int d = 0; d < DIM; d++)
        u[d] = weight > 0 ? exact_sum_value(&s->sum[d]) / weight : 0;
}

double probe_pressure(const struct crowd *c, const double *p, const double *x)
{
    struct probe_sums sums;

    probe_sum_pressure(c, p, x, &sums);
    return probe_mean_pressure(c, &sums);
}

void probe_velocity(const struct crowd *c, const double *x, double *u)
{
    struct probe_sums sums;

    probe_sum_velocity(c, x, &sums);
    probe_mean_velocity(&sums, u);
}

/* --- levels ------------------------------------------------------------------------------ */

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
        if (view_has(v, i) && y[DIM - 1] > best && is_near(s, x, y, axes) && crowd_is_water(c, i))
            best = y[DIM - 1];
    }
    return best - s->low[DIM - 1];
}

double probe_height(const struct crowd *c, const double *x, int axes)
{
    const double top = top_of(c, x, axes);

    return top > 0 ? top + crowd_view(c)->p->scales->dx / 2 : 0;
}
