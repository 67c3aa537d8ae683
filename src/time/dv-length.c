/* dv-length.c -- the error of a step of "dv", and the bound of stability.
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
#include <math.h>

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
                   x->from[what + 1] - i, vector_data(x->frame.error) + i);
}

double dv_error(struct paced *frame, double h)
{
    struct dv *x = (struct dv *)frame;
    const long v = x->from[LAYOUT_VELOCITY];
    const double cube = h * h * h, slope = cube / 24 / (x->a.t[0] - x->a.t[1]);
    const double c[2] = { slope, -slope };

    vector_combine(2, c, (const double *[]){ x->a.f[0] + v, x->a.f[1] + v }, v,
                   vector_data(frame->error));
    bent(x, LAYOUT_VELOCITY, &x->a, h, cube / 12);
    bent(x, LAYOUT_OTHER, &x->d, h, cube / 12);
    return N_VWrmsNorm(frame->error, frame->weight);
}

/* --- the bound ----------------------------------------------------------- */

/* Bodies are implicit. */
double dv_bound(const struct paced *x, struct limit *of)
{
    struct limit limit[2];
    double w, d;

    moment_limit(x->moment, x->t, x->y, false, limit);
    w = limit[0].rate;
    d = limit[1].rate;
    *of = limit[d > w];
    return w > 0 || d > 0 ? safety * 4 / (d + sqrt(d * d + 4 * w * w)) : HUGE_VAL;
}

/* Of rates that begin() asked for, those of bodies left to themselves among them. */
double dv_haste(struct paced *frame)
{
    struct dv *x = (struct dv *)frame;
    const double *weight = vector_data(frame->weight);
    const long v = x->from[LAYOUT_VELOCITY];
    const bool bodies = x->ranges > 0;
    double most = 0;

    if (bodies
        && moment_eval(frame->moment, ASK_IMPLICIT_SIDE, frame->t, frame->y, x->right)
               != STATUS_DONE)
        return 0;
    for (long i = 0; i < frame->n; i++) {
        const double own = bodies ? x->right[i] : 0;
        const double f = i < v ? frame->y[v + i] : x->a.f[1][i] + x->d.f[1][i] + own;
        most = fmax(most, fabs(f * weight[i]));
    }
    return most;
}
