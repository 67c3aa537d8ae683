/* cvode.c -- steps by SUNDIALS' CVODE, one at a time.
 *
 * CVODE is started anew at the beginning and after a restart: it then goes back to
 * order 1 and chooses its first step by itself. */
#include "time/cvode.h"

#include "base/status.h"
#include "time/failure.h"
#include <math.h>
#include <stdio.h>

int cvode_refuse(const struct cvode *c, const char *what)
{
    return status_fail(STATUS_FAILED, "method %s: SUNDIALS %d.%d.%d refuses %s (%s)",
                       c->row->method.name, SUNDIALS_VERSION_MAJOR, SUNDIALS_VERSION_MINOR,
                       SUNDIALS_VERSION_PATCH, what, sundials_complaint());
}

static const char *name(const struct cvode *c)
{
    return c->row->method.name;
}

/* Steps that had to be repeated, of the error test and of the solver. */
static long repeated(const struct cvode *c)
{
    long errors = 0, solves = 0;

    if (c->h > 0) {
        CVodeGetNumErrTestFails(c->cvode, &errors);
        CVodeGetNumStepSolveFails(c->cvode, &solves);
    }
    return errors + solves;
}

static int launch(struct cvode *c)
{
    if (CVodeReInit(c->cvode, c->t, c->y) != 0
        || CVodeSetInitStep(c->cvode, c->def.h_first) != 0
        || CVodeSetMinStep(c->cvode, c->def.h_min) != 0)
        return cvode_refuse(c, "to start");
    c->floored = c->def.h_min > 0;
    c->launched = true;
    return STATUS_DONE;
}

/* The first step that CVODE took says what is short. */
static int set_floor(struct cvode *c)
{
    sunrealtype first;

    c->floored = true;
    if (CVodeGetActualInitStep(c->cvode, &first) != 0
        || CVodeSetMinStep(c->cvode, 1e-6 * first) != 0)
        return cvode_refuse(c, "a shortest step");
    return STATUS_DONE;
}

static const char *reason(int flag)
{
    switch (flag) {
    case CV_ERR_FAILURE:
        return "no step, however short, passes the error test";
    case CV_CONV_FAILURE:
        return "the equations of a step, however short, are not solved by its iteration";
    case CV_TOO_MUCH_ACC:
        return "the state is not finite, or tol is below what double precision can resolve";
    default:
        return sundials_complaint();
    }
}

/* The message of a run that cannot go on. */
static int collapse(const struct cvode *c, int flag)
{
    const bool refused = c->rates.refusal[0];
    const long entry = vector_largest(c->y);
    sunrealtype h = 0;

    if (flag == CV_MEM_FAIL)
        return failure_memory(name(c), c->n);
    if (flag == CV_FIRST_RHSFUNC_ERR)
        return failure_start(name(c), c->t, c->rates.refusal);
    CVodeGetCurrentStep(c->cvode, &h);
    return status_fail_with(STATUS_FAILED,
                            (struct status_advice){ .remedy = FAILURE_REMEDY_METHODS },
                            "%s collapsed at t = %.9g s, below a step of %.3g s: %s; %s%s",
                            name(c), c->t, h, reason(flag),
                            refused ? "the right-hand side has no answer: "
                                    : "the largest error, or what is not finite, is in ",
                            refused      ? c->rates.refusal
                            : entry >= 0 ? moment_entry(c->rates.moment, entry)
                                         : "no entry known");
}

/* The entry whose error was largest in the step just made. */
static const char *largest_error(struct cvode *c)
{
    if (CVodeGetEstLocalErrors(c->cvode, c->spare) != 0)
        return "not known";
    N_VWrmsNorm(c->spare, c->weight);
    return moment_entry(c->rates.moment, vector_largest(c->spare));
}

/* touch: what contacts allowed. */
static void report(struct cvode *c, double planned, const struct limit *touch,
                   struct method_step *out)
{
    const bool cut = c->h < planned * (1 - 1e-9);
    const bool bound = !cut && c->h * touch->rate > 1 - 1e-9;

    *out = (struct method_step){ .t = c->t, .h = c->h,
                                 .limiter = cut ? METHOD_OUTPUT : bound ? METHOD_STABILITY
                                                                        : METHOD_ERROR,
                                 .rejected = c->rejected + repeated(c) };
    snprintf(out->where, sizeof out->where, "%.95s",
             cut ? "end of the segment" : bound ? touch->part : largest_error(c));
}

/* A longest step of 0 is none. */
static int bound_step(struct cvode *c, struct limit *touch)
{
    moment_contact_limit(c->rates.moment, c->t, vector_data(c->y), touch);
    return CVodeSetMaxStep(c->cvode, touch->rate > 0 ? 1 / touch->rate : 0) == 0
         ? STATUS_DONE : cvode_refuse(c, "a longest step");
}

/* What CVODE meant to take; 0 before its first step. */
static double planned_step(const struct cvode *c)
{
    sunrealtype h = 0;

    if (c->h > 0)
        CVodeGetCurrentStep(c->cvode, &h);
    return h;
}

int cvode_step(void *self, double t_stop, struct method_step *out)
{
    struct cvode *c = self;
    const double t_old = c->t;
    struct vector_own own;
    struct limit touch;
    sunrealtype t;
    int flag;
    long bad;

    if (!(t_stop > t_old))
        return status_fail(STATUS_FAILED, "a step to t = %.9g s was asked for at t = %.9g s",
                           t_stop, t_old);
    sundials_forget();
    if (!c->launched)
        TRY(launch(c));
    TRY(bound_step(c, &touch));
    const double planned = touch.rate > 0 ? fmin(planned_step(c), 1 / touch.rate) : planned_step(c);
    const long before = repeated(c);
    if (CVodeSetStopTime(c->cvode, t_stop) != 0)
        return cvode_refuse(c, "the end of a segment");
    flag = CVode(c->cvode, t_stop, c->spare, &t, CV_ONE_STEP);
    if (flag < 0)
        return collapse(c, flag);
    own = moment_own(c->rates.moment);
    bad = vector_bad_anywhere(c->n, vector_read(c->spare), &own);
    if (bad >= 0)
        return failure_not_finite(name(c), t, moment_entry(c->rates.moment, bad));
    vector_take(c->y, vector_read(c->spare));
    c->t = t;
    c->h = t - t_old;
    if (!c->floored)
        TRY(set_floor(c));
    report(c, repeated(c) > before || t < t_stop ? 0 : planned, &touch, out);
    return STATUS_DONE;
}

/* CVODE's own interpolant, of the order of the step. */
int cvode_at(void *self, double t, double *y)
{
    struct cvode *c = self;

    if (t == c->t) {
        moment_take(c->rates.moment, vector_data(c->y), y);
        return STATUS_DONE;
    }
    if (!(c->h > 0 && t >= c->t - c->h * (1 + 1e-12) && t < c->t)
        || CVodeGetDky(c->cvode, t, 0, c->spare) != 0)
        return status_fail(STATUS_FAILED, "the state at t = %.9g s was asked for, which does not "
                                          "lie in the last step (to %.9g s)", t, c->t);
    moment_take(c->rates.moment, vector_data(c->spare), y);
    return STATUS_DONE;
}

/* At order 1 a step is short: one of the length that a higher order had before is refused as often
 * as CVODE asks to find its own (doc/output.md). */
int cvode_restart(void *self, double t, const double *y, const struct method_pace *pace)
{
    struct cvode *c = self;

    (void)pace;
    c->rejected += repeated(c);
    vector_take(c->y, y);
    c->t = t;
    c->h = 0;
    c->launched = false;
    c->rates.refusal[0] = '\0';
    return STATUS_DONE;
}

/* All that CVODE keeps are clones of y. */
int cvode_rearrange(void *self, int blocks, const struct vector_rows *block)
{
    const struct cvode *c = self;

    return vector_rearrange(c->y, blocks, block);
}
