/* arkode-length.c -- how long a step may be, and what kept it from being longer:
 * the error estimate or the bound of stability. */
#include "time/arkode.h"

#include "base/status.h"
#include "time/constant.h"
#include "time/failure.h"
#include "time/stability.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double safety = 0.95; /* of the stability bound */
static const double dearer = 1.1;  /* steps that a beam in water may add */

static double longest(double factor, const struct limit *limit)
{
    return limit->rate > 0 ? safety * factor / limit->rate : HUGE_VAL;
}

/* Largest stable step at (t, y): HUGE_VAL if the plan knows none. */
double arkode_bound(struct arkode *a, double t, const double *y)
{
    struct limit limit[2];
    double wave, decay;

    moment_limit(a->moment, t, y, !a->imex && plan_stiff(a->plan), limit);
    wave = longest(a->stable.wave, &limit[0]);
    decay = longest(a->stable.decay, &limit[1]);
    a->stable.limit = limit[decay < wave];
    a->stable.h = fmin(wave, decay);
    return a->stable.h;
}

/* Steps that are to follow the first mode of each beam: error tests allow a beam whose
 * deflections are small against its thickness steps over whole periods, which damp it.
 * But hardly more of them than without: a beam is to cost nothing, however stiff. */
static void follow(struct arkode *a)
{
    const double most = a->stable.h < HUGE_VAL ? dearer * a->stable.swing / a->stable.h
                                               : HUGE_VAL;
    struct limit mode;

    moment_swing(a->moment, most, &mode);
    if (!(mode.rate * a->stable.h > a->stable.swing))
        return;
    a->stable.h = a->stable.swing / mode.rate;
    a->stable.limit = mode;
}

/* ARKStep asks after every attempt: the error norm was taken just before.  Where the start of
 * the step has no rates, that is the reason of all attempts: SUNDIALS 7 asks for them once. */
int arkode_adapt(N_Vector y, sunrealtype t, sunrealtype h1, sunrealtype h2, sunrealtype h3,
                 sunrealtype e1, sunrealtype e2, sunrealtype e3, int q, int p, sunrealtype *next,
                 void *self)
{
    struct arkode *a = self;
    struct choice *c = &a->choice[0];

    (void)t, (void)h2, (void)h3, (void)e2, (void)e3, (void)q, (void)p;
    a->choice[1] = *c;
    a->error.accepted = e1 <= 1;
    a->rejected += !a->error.accepted;
    *next = control_next(&a->control, h1, e1 * a->row->control->accept);
    *c = (struct choice){ .h = *next, .limiter = METHOD_ERROR,
                                 .entry = vector_largest(y) };
    if (!a->error.accepted)
        memcpy(c->refusal, a->refusal, sizeof c->refusal);
    if (a->error.accepted || a->node[0].has_f)
        a->refusal[0] = '\0';
    return 0;
}

/* ARKStep asks right after arkode_adapt(); 0 means that there is no bound. */
int arkode_stable(N_Vector y, sunrealtype t, sunrealtype *h, void *self)
{
    struct arkode *a = self;
    struct choice *c = &a->choice[0];

    if (a->error.accepted) {
        arkode_bound(a, t, vector_read(y));
        if (a->imex)
            follow(a);
    }
    *h = a->stable.h < HUGE_VAL ? a->stable.h : 0;
    if (a->stable.h < c->h) {
        c->h = a->stable.h;
        c->limiter = METHOD_STABILITY;
        c->limit = a->stable.limit;
    }
    return 0;
}

/* Without a bound: a step along f that changes y by as much as an error may, on whichever rank. */
static int cautious(struct arkode *a, double t_stop, double *h)
{
    const struct arkode_node *now = &a->node[0];
    double most;

    if (arkode_rates(a) != STATUS_DONE)
        return failure_start(a->row->method.name, now->t, a->refusal);
    most = vector_most(a->n, vector_read(now->f), a->error.weight);
    *h = most > 0 ? fmin(1 / most, t_stop - now->t) : (t_stop - now->t) / 100;
    return STATUS_DONE;
}

/* ARKStep has no estimate then, and every step is like the first. */
static void choose_constant(struct arkode *a)
{
    a->choice[0] = (struct choice){ .h = a->def.seconds, .limiter = METHOD_STABILITY,
                                           .entry = -1,
                                           .limit = { .where = -1, .part = CONSTANT_PART } };
    a->choice[1] = a->choice[0];
}

/* The last step takes along what rounding has left before t_stop. */
int arkode_stretch(struct arkode *a, double t_stop)
{
    const double left = t_stop - a->node[0].t, h = a->def.seconds;

    return h > 0 && left > h && left <= h * (1 + CONSTANT_SLACK)
               ? ARKodeSetFixedStep(a->ark, left) : 0;
}

int arkode_constant_failed(struct arkode *a)
{
    const struct arkode_node *now = &a->node[0];
    const double bound = arkode_bound(a, now->t, vector_read(now->y));

    return constant_fail(a->row->method.name, a->def.seconds, now->t, a->refusal, bound,
                         &a->stable.limit);
}

/* The first step: that of a segment before, else 0.3 of the bound, from where a controller of
 * low gain comes to the error it aims at within a few steps. */
int arkode_first(struct arkode *a, double t_stop, double *h)
{
    const struct arkode_node *now = &a->node[0];
    const double bound = arkode_bound(a, now->t, vector_read(now->y));

    if (a->def.seconds > 0) {
        *h = a->def.seconds;
        choose_constant(a);
        return STATUS_DONE;
    }
    a->choice[0] = (struct choice){ .limiter = METHOD_ERROR, .entry = -1,
                                           .limit = a->stable.limit };
    const double given = a->natural > 0 ? a->natural : a->def.h_first;

    if (given > 0)
        *h = given;
    else if (bound < HUGE_VAL)
        *h = 0.3 * bound;
    else
        TRY(cautious(a, t_stop, h));
    if (a->imex)
        follow(a);
    *h = fmin(*h, a->stable.h);
    if (bound < HUGE_VAL && (given == 0 || *h == bound))
        a->choice[0].limiter = METHOD_STABILITY;
    a->choice[0].h = *h;
    return STATUS_DONE;
}
