/* dv-length.c -- the error of a step of "dv", and how long the next one may be.
 *
 * With A'' by divided differences of the last three A, and D'' likewise, the step
 * adds errors of the size
 *
 *   e_x = h^3/24 A',  e_v = h^3/24 A'',  e_rho = h^3/24 D''
 *
 * Waves of frequency w (v' = -w r, r' = w v) with damping d of one of both, which
 * the step takes explicitly, stay bounded while (w h)^2 + 2 d h <= 4:
 *
 *   h <= 4/(d + sqrt(d^2 + 4 w^2))
 *
 * that is 2/w alone and 2/d alone. */
#include "time/dv.h"

#include "base/status.h"
#include "time/constant.h"
#include <math.h>
#include <stdio.h>

static const double safety = 0.95; /* of the stability bound */

/* --- the error ----------------------------------------------------------- */

/* error = factor times the second divided difference of the rates of a class.  In
 * a first step, rates are taken as constant before. */
static void bent(struct dv *x, enum layout_class what, const struct dv_past *p, double h,
                 double factor)
{
    const long i = x->from[what];
    const bool known = p->known > 1;
    const double t[3] = { p->t[0], p->t[1], known ? p->t[2] : p->t[1] - h };
    double c[3];

    for (int k = 0; k < 3; k++)
        c[k] = factor / ((t[k] - t[(k + 1) % 3]) * (t[k] - t[(k + 2) % 3]));
    vector_combine(3, c, (const double *[]){ p->f[0] + i, p->f[1] + i, p->f[known ? 2 : 1] + i },
                   x->from[what + 1] - i, vector_data(x->error) + i);
}

double dv_error(struct dv *x, double h)
{
    if (x->def.seconds > 0)
        return 0; /* whatever it is, the step stays */

    const long v = x->from[LAYOUT_VELOCITY];
    const double cube = h * h * h, slope = cube / 24 / (x->a.t[0] - x->a.t[1]);
    const double c[2] = { slope, -slope };

    vector_combine(2, c, (const double *[]){ x->a.f[0] + v, x->a.f[1] + v }, v,
                   vector_data(x->error));
    bent(x, LAYOUT_VELOCITY, &x->a, h, cube / 12);
    bent(x, LAYOUT_OTHER, &x->d, h, cube / 12);
    return N_VWrmsNorm(x->error, x->weight);
}

/* --- the bound ----------------------------------------------------------- */

/* Largest stable step at (t, y), bodies being implicit: HUGE_VAL if the plan knows
 * none. */
static double bound(const struct dv *x, struct limit *of)
{
    struct limit limit[2];
    double w, d;

    plan_limit(x->plan, x->t, x->y, false, limit);
    w = limit[0].rate;
    d = limit[1].rate;
    *of = limit[d > w];
    return w > 0 || d > 0 ? safety * 4 / (d + sqrt(d * d + 4 * w * w)) : HUGE_VAL;
}

int dv_constant_failed(const struct dv *x)
{
    struct limit limit;
    const double most = bound(x, &limit);

    return constant_fail("dv", x->def.seconds, x->t, x->choice.refusal, most, &limit);
}

static void choose_constant(struct dv *x)
{
    x->choice = (struct choice){ .h = x->def.seconds, .limiter = METHOD_STABILITY,
                                    .entry = -1,
                                    .limit = { .where = -1, .part = CONSTANT_PART } };
    x->h_min = HUGE_VAL; /* never shortened */
}

void dv_choose(struct dv *x, double h)
{
    if (x->def.seconds > 0) {
        choose_constant(x);
        return;
    }

    struct limit limit;
    const double most = bound(x, &limit);

    x->choice = (struct choice){ .h = fmin(h, most), .limiter = METHOD_ERROR,
                                    .entry = vector_largest(x->error), .limit = limit };
    if (most < h)
        x->choice.limiter = METHOD_STABILITY;
}

/* Without a bound: a step along the rates, those of bodies left to themselves among them,
 * that changes y by as much as an error may. */
static double cautious(struct dv *x, double t_stop)
{
    const double *weight = vector_data(x->weight);
    const long v = x->from[LAYOUT_VELOCITY];
    double most = 0;

    if (plan_rhs(x->plan, PLAN_IMPLICIT, x->t, x->y, x->right) != STATUS_DONE)
        return (t_stop - x->t) / 100;
    for (long i = 0; i < x->n; i++) {
        const double f = i < v ? x->y[v + i] : x->a.f[1][i] + x->d.f[1][i] + x->right[i];
        most = fmax(most, fabs(f * weight[i]));
    }
    return most > 0 ? fmin(1 / most, t_stop - x->t) : (t_stop - x->t) / 100;
}

/* The first step, 0.3 of the bound, as a controller of low gain wants it. */
void dv_first(struct dv *x, double t_stop)
{
    if (x->def.seconds > 0) {
        choose_constant(x);
        return;
    }

    struct limit limit;
    const double most = bound(x, &limit);
    double h = x->def.h_first;

    if (!(h > 0))
        h = most < HUGE_VAL ? 0.3 * most : cautious(x, t_stop);
    h = fmin(h, most);
    x->choice = (struct choice){ .h = h, .limiter = METHOD_ERROR, .entry = -1,
                                    .limit = limit };
    if (most < HUGE_VAL && (x->def.h_first == 0 || h == most))
        x->choice.limiter = METHOD_STABILITY;
    x->h_min = x->def.h_min > 0 ? x->def.h_min : 1e-6 * h;
}
