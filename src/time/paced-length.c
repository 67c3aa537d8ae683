/* paced-length.c -- how long a step with error control may be, and what kept it from being
 * longer: the error estimate or the bound of stability. */
#include "time/paced.h"

#include "time/constant.h"
#include <math.h>

int paced_constant_failed(const struct paced *x)
{
    struct limit limit;
    const double most = x->kind->bound(x, &limit);

    return constant_fail(x->kind->method.name, x->def.seconds, x->t, x->choice.refusal, most,
                         &limit);
}

static void choose_constant(struct paced *x)
{
    x->choice = (struct choice){ .h = x->def.seconds, .limiter = METHOD_STABILITY, .entry = -1,
                                 .limit = { .where = -1, .part = CONSTANT_PART } };
    x->h_min = HUGE_VAL; /* never shortened */
}

void paced_choose(struct paced *x, double h)
{
    struct limit limit;
    double most;

    if (x->def.seconds > 0) {
        choose_constant(x);
        return;
    }
    most = x->kind->bound(x, &limit);
    x->choice = (struct choice){ .h = fmin(h, most), .limiter = METHOD_ERROR,
                                 .entry = vector_largest(x->error), .limit = limit };
    if (most < h)
        x->choice.limiter = METHOD_STABILITY;
}

/* Without a bound: a step along the rates that changes y by as much as an error may. */
static double cautious(struct paced *x, double t_stop)
{
    const double haste = x->kind->haste(x), left = t_stop - x->t;

    return haste > 0 ? fmin(1 / haste, left) : left / 100;
}

/* The first step: that of a segment before, or 0.3 of the bound, as a controller of low gain
 * wants it. */
void paced_first(struct paced *x, double t_stop)
{
    struct limit limit;
    const double given = x->carried > 0 ? x->carried : x->def.h_first;
    double most, h = given;

    if (x->def.seconds > 0) {
        choose_constant(x);
        return;
    }
    most = x->kind->bound(x, &limit);
    if (!(h > 0))
        h = most < HUGE_VAL ? 0.3 * most : cautious(x, t_stop);
    h = fmin(h, most);
    x->choice = (struct choice){ .h = h, .limiter = METHOD_ERROR, .entry = -1, .limit = limit };
    if (most < HUGE_VAL && (given == 0 || h == most))
        x->choice.limiter = METHOD_STABILITY;
    x->h_min = x->def.h_min > 0 ? x->def.h_min : 1e-6 * h;
}
