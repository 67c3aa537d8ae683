/* ab3-length.c -- how long a step of "ab3" may be, and what kept it from being longer:
 * the error estimate or the bound of stability.
 *
 * The bound is that of equal steps: the roots r of r^3 - r^2 - z (23 r^2 - 16 r + 5)/12
 * stay within 1.001 up to |z| = 0.700 for the waves of the fluid, with their damping of
 * stability.h (0.724 without any), and up to 0.546 for decay. */
#include "time/ab3.h"

#include "base/status.h"
#include "time/constant.h"
#include <math.h>
#include <stdio.h>

static const double safety = 0.95, wave = 0.700, decay = 0.546;

static double longest(double factor, const struct limit *limit)
{
    return limit->rate > 0 ? safety * factor / limit->rate : HUGE_VAL;
}

/* Largest stable step at (t, y), beams being explicit: HUGE_VAL if the plan knows none. */
static double bound(const struct ab3 *x, struct limit *of)
{
    struct plan *plan = x->rates.plan;
    struct limit limit[2];
    double h[2];

    plan_limit(plan, x->t, x->y, plan_stiff(plan), limit);
    h[0] = longest(wave, &limit[0]);
    h[1] = longest(decay, &limit[1]);
    *of = limit[h[1] < h[0]];
    return fmin(h[0], h[1]);
}

int ab3_constant_failed(const struct ab3 *x)
{
    struct limit limit;
    const double most = bound(x, &limit);

    return constant_fail(ab3_method.name, x->def.seconds, x->t, x->choice.refusal, most, &limit);
}

static void choose_constant(struct ab3 *x)
{
    x->choice = (struct choice){ .h = x->def.seconds, .limiter = METHOD_STABILITY,
                                     .entry = -1,
                                     .limit = { .where = -1, .part = CONSTANT_PART } };
    x->h_min = HUGE_VAL; /* never shortened */
}

void ab3_choose(struct ab3 *x, double h)
{
    struct limit limit;
    const double most = bound(x, &limit);

    if (x->def.seconds > 0) {
        choose_constant(x);
        return;
    }
    x->choice = (struct choice){ .h = fmin(h, most), .limiter = METHOD_ERROR,
                                     .entry = vector_largest(x->error), .limit = limit };
    if (most < h)
        x->choice.limiter = METHOD_STABILITY;
}

/* Without a bound: a step along the rates that changes y by as much as an error may. */
static double cautious(const struct ab3 *x, double t_stop)
{
    const double *weight = vector_data(x->weight);
    double most = 0;

    for (long i = 0; i < x->n; i++)
        most = fmax(most, fabs(x->f[0][i] * weight[i]));
    return most > 0 ? fmin(1 / most, t_stop - x->t) : (t_stop - x->t) / 100;
}

/* The first step, 0.3 of the bound, as a controller of low gain wants it. */
void ab3_first(struct ab3 *x, double t_stop)
{
    struct limit limit;
    const double most = bound(x, &limit);
    double h = x->def.h_first;

    if (x->def.seconds > 0) {
        choose_constant(x);
        return;
    }
    if (!(h > 0))
        h = most < HUGE_VAL ? 0.3 * most : cautious(x, t_stop);
    h = fmin(h, most);
    x->choice = (struct choice){ .h = h, .limiter = METHOD_ERROR, .entry = -1,
                                     .limit = limit };
    if (most < HUGE_VAL && (x->def.h_first == 0 || h == most))
        x->choice.limiter = METHOD_STABILITY;
    x->h_min = x->def.h_min > 0 ? x->def.h_min : 1e-6 * h;
}
