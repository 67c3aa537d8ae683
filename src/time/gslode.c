/* gslode.c -- steps by GSL's odeiv2, one at a time.
 *
 * GSL's steppers here give the rates at the end of a step, which are those at the
 * start of the next: no right-hand side is asked for twice, and dense output costs
 * none.  An attempt fails where a right-hand side has no answer, where the state or
 * its error is not finite, and where the error is too large. */
#include "time/gslode.h"

#include "base/status.h"
#include "time/constant.h"
#include "time/dense.h"
#include "time/failure.h"
#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdio.h>

static const char *name(const struct gslode *x)
{
    return x->row->method.name;
}

static const char *culprit(const struct gslode *x)
{
    if (x->def.seconds > 0)
        return CONSTANT_PART;
    return x->entry >= 0 ? moment_entry(x->rates.moment, x->entry) : "the first step";
}

/* Fastest rate where the next step starts [1/s]. */
static struct limit fastest(const struct gslode *x)
{
    struct limit limit[2];

    moment_limit(x->rates.moment, x->node[0].t, x->node[0].y,
                 plan_stiff(moment_plan(x->rates.moment)), limit);
    return limit[limit[1].rate > limit[0].rate];
}

static int constant_failed(const struct gslode *x)
{
    const struct limit limit = fastest(x);
    const double bound = limit.rate > 0 ? x->row->stable / limit.rate : HUGE_VAL;

    return constant_fail(name(x), x->def.seconds, x->node[0].t, x->rates.refusal, bound, &limit);
}

/* The message of a run that cannot go on. */
static int collapse(const struct gslode *x, double h)
{
    const bool refused = x->rates.refusal[0];

    if (x->def.seconds > 0)
        return constant_failed(x);
    return status_fail_with(STATUS_FAILED,
                            (struct status_advice){ .remedy = FAILURE_REMEDY_METHODS },
                            "%s collapsed at t = %.9g s, below a step of %.3g s: %s%s", name(x),
                            x->node[0].t, h,
                            refused ? "the right-hand side has no answer: "
                                    : "no step, however short, passes the error test; the "
                                      "largest error, or what is not finite, is in ",
                            refused ? x->rates.refusal : culprit(x));
}

/* --- lengths --------------------------------------------------------------- */

/* Without a rate: a step along f that changes y by as much as an error may. */
static double first_step(const struct gslode *x, double left)
{
    double rate, most;

    if (x->def.seconds > 0)
        return x->def.seconds;
    if (x->carried > 0)
        return x->carried;
    if (x->def.h_first > 0)
        return x->def.h_first;
    rate = fastest(x).rate;
    if (rate > 0)
        return fmin(x->row->first / rate, left);
    most = vector_most(x->n, x->node[0].f, vector_read(x->weight));
    return most > 0 ? fmin(1 / most, left) : left / 100;
}

static int begin(struct gslode *x, double t_stop)
{
    struct gslode_node *now = &x->node[0];

    if (rates_ask(&x->rates, now->t, now->y, now->f) != STATUS_DONE)
        return failure_start(name(x), now->t, x->rates.refusal);
    x->h = first_step(x, t_stop - now->t);
    x->h_min = x->def.h_min > 0 ? x->def.h_min : 1e-6 * x->h;
    x->entry = -1;
    gsl_odeiv2_step_reset(x->stepper);
    return STATUS_DONE;
}

/* --- steps ----------------------------------------------------------------- */

/* Error of a step from node[0] to `to`; NAN when there is no answer. */
static double attempt(struct gslode *x, double h, struct gslode_node *to)
{
    const struct gslode_node *now = &x->node[0];
    const struct vector_own own = moment_own(x->rates.moment);
    double *error = vector_data(x->error);
    long bad;

    vector_copy(x->n, now->y, to->y);
    if (gsl_odeiv2_step_apply(x->stepper, now->t, h, to->y, error, now->f, to->f, &x->system)
        != GSL_SUCCESS)
        return NAN;
    bad = vector_bad_anywhere(x->n, to->y, &own);
    if (bad < 0)
        bad = vector_bad_anywhere(x->n, error, &own);
    if (bad >= 0) {
        x->entry = bad;
        return NAN;
    }
    return x->def.seconds > 0 ? 0 : N_VWrmsNorm(x->error, x->weight);
}

/* A constant step is taken as it is, or not at all. */
static int accept_constant(struct gslode *x, double h, double *next)
{
    *next = x->def.seconds;
    return attempt(x, h, &x->node[GSLODE_NODES - 1]) == 0 ? STATUS_DONE : STATUS_FAILED;
}

/* Shortens the step until it is accepted; `next` is what its error asks for then. */
static int accept(struct gslode *x, double *h, double *next, bool *shortened)
{
    if (x->def.seconds > 0) {
        *shortened = false;
        return accept_constant(x, *h, next);
    }
    for (*shortened = false;; *shortened = true) {
        const double e = attempt(x, *h, &x->node[GSLODE_NODES - 1]);
        if (x->row->order == 0)
            x->control.k = (int)gsl_odeiv2_step_order(x->stepper) + 1;
        if (isfinite(e))
            x->entry = vector_largest(x->error);
        *next = control_next(&x->control, *h, e);
        if (e <= x->control.row->accept)
            return STATUS_DONE;
        x->rejected++;
        *h = isfinite(e) ? *next : *h / 2;
        if (*h < x->h_min)
            return STATUS_FAILED;
    }
}

/* The vector that the step wrote to becomes the newest node. */
static void rotate(struct gslode *x, double t)
{
    const struct gslode_node fresh = x->node[GSLODE_NODES - 1];

    for (int k = GSLODE_NODES - 1; k > 0; k--)
        x->node[k] = x->node[k - 1];
    x->node[0] = fresh;
    x->node[0].t = t;
    x->known += x->known < GSLODE_NODES;
}

/* Contacts bound steps that errors choose: a step past one is seen by nothing. */
static double bounded(const struct gslode *x, double h, struct limit *touch)
{
    *touch = (struct limit){ .rate = 0 };
    if (x->def.seconds > 0)
        return h;
    moment_contact_limit(x->rates.moment, x->node[0].t, x->node[0].y, touch);
    return touch->rate > 0 ? fmin(h, 1 / touch->rate) : h;
}

static const char *limiter_name(const struct gslode *x, bool cut, const struct limit *touch, double h)
{
    return cut ? "end of the segment" : h * touch->rate > 1 - 1e-9 ? touch->part : culprit(x);
}

int gslode_step(void *self, double t_stop, struct method_step *out)
{
    struct gslode *x = self;
    const double t = x->node[0].t, left = t_stop - t;
    const struct control past = x->control;
    struct limit touch;
    double h, next;
    bool shortened;

    if (!(left > 0))
        return status_fail(STATUS_FAILED, "a step to t = %.9g s was asked for at t = %.9g s",
                           t_stop, t);
    if (x->h == 0)
        TRY(begin(x, t_stop));
    if (x->known == GSLODE_NODES)
        x->known--; /* the oldest gives its place to the step */
    const double asked = bounded(x, x->h, &touch), slack = x->def.seconds > 0 ? CONSTANT_SLACK : 1e-12;
    h = asked >= left * (1 - slack) ? left : asked;
    if (accept(x, &h, &next, &shortened) != STATUS_DONE)
        return collapse(x, h);
    const bool cut = !shortened && h < asked * (1 - 1e-9);
    rotate(x, h == left ? t_stop : t + h);
    x->h = cut ? asked : next;
    *out = (struct method_step){ .t = x->node[0].t, .h = x->node[0].t - t,
                                 .limiter = cut ? METHOD_OUTPUT
                                          : x->def.seconds > 0 || h * touch.rate > 1 - 1e-9
                                                ? METHOD_STABILITY : METHOD_ERROR,
                                 .rejected = x->rejected };
    if (x->row->order > 0) /* else it begins at order 1, where steps are short */
        out->pace = control_pace(cut ? &past : &x->control, x->h);
    snprintf(out->where, sizeof out->where, "%.95s", limiter_name(x, cut, &touch, h));
    return STATUS_DONE;
}

/* --- between the ends -------------------------------------------------------- */

/* The Hermite interpolant of the last step's ends (error h^4), or of the last two
 * steps' (h^6). */
int gslode_at(void *self, double t, double *y)
{
    struct gslode *x = self;
    double time[GSLODE_NODES], c[2 * GSLODE_NODES];
    const double *v[2 * GSLODE_NODES];
    int nodes;

    if (t == x->node[0].t) {
        vector_copy(x->n, x->node[0].y, y);
        return STATUS_DONE;
    }
    if (x->known < 2 || !(t >= x->node[1].t && t < x->node[0].t))
        return status_fail(STATUS_FAILED, "the state at t = %.9g s was asked for, which does not "
                                          "lie in the last step (to %.9g s)", t, x->node[0].t);
    for (int k = 0; k < x->known; k++)
        time[k] = x->node[k].t;
    nodes = dense_nodes(x->known, time);
    dense_hermite(nodes, time, t, c, c + nodes);
    for (int k = 0; k < nodes; k++) {
        v[k] = x->node[k].y;
        v[nodes + k] = x->node[k].f;
    }
    vector_combine(2 * nodes, c, v, x->n, y);
    return STATUS_DONE;
}

int gslode_restart(void *self, double t, const double *y, const struct method_pace *pace)
{
    struct gslode *x = self;

    moment_take(x->rates.moment, y, x->node[0].y);
    x->node[0].t = t;
    x->known = 1;
    x->h = 0;
    x->carried = pace ? pace->h : 0;
    x->rates.refusal[0] = '\0';
    control_start(&x->control, x->row->control, x->row->order, x->row->embedded, pace);
    return STATUS_DONE;
}
