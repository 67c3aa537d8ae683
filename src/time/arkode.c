/* arkode.c -- steps by SUNDIALS' ARKStep, one at a time.
 *
 * ARKStep is started anew ("launched") at the beginning, after a restart and
 * after each t_stop, whose last step may be arbitrarily short: the next one then
 * starts with the length that would have been taken. */
#include "time/arkode.h"

#include "base/status.h"
#include "time/failure.h"
#include <float.h>
#include <math.h>
#include <stdio.h>

static int refuse_launch(const struct arkode *a)
{
    return status_fail(STATUS_FAILED, "%s cannot start at t = %.9g s: %s", a->row->method.name,
                       a->node[0].t, sundials_complaint());
}

static int launch(struct arkode *a, double t_stop)
{
    const struct arkode_node *now = &a->node[0];
    double h = a->natural, h_min;
    int bad;

    if (a->known == 1)
        TRY(arkode_first(a, t_stop, &h));
    h_min = a->def.h_min > 0 ? a->def.h_min : 1e-6 * h;
    sundials_forget();
    bad = ARKStepReInit(a->ark, arkode_explicit, a->imex ? arkode_implicit : NULL, now->t,
                        now->y);
    bad |= ARKodeSetInitStep(a->ark, h);
    bad |= ARKodeSetMinStep(a->ark, h_min);
    if (bad)
        return refuse_launch(a);
    a->choice[0].h = h;
    a->launched = true;
    return STATUS_DONE;
}

static const char *reason(int flag)
{
    switch (flag) {
    case ARK_ERR_FAILURE:
        return "no step, however short, passes the error test";
    case ARK_TOO_MUCH_ACC:
        return "the state is not finite, or tol is below what double precision can resolve";
    default:
        return sundials_complaint();
    }
}

/* The message of a run that cannot go on. */
static int collapse(struct arkode *a, int flag)
{
    const struct choice *c = &a->choice[0];
    char where[96] = "";

    if (flag == ARK_MEM_FAIL)
        return failure_memory(a->row->method.name, a->n);
    choice_where(c, a->moment, where);
    return status_fail_with(STATUS_FAILED, (struct status_advice){ .remedy = FAILURE_REMEDY },
                            "%s collapsed at t = %.9g s, below a step of %.3g s: %s; %s%s",
                            a->row->method.name, a->node[0].t, c->h, reason(flag),
                            c->refusal[0] ? "the right-hand side has no answer: "
                                          : "the largest error, or what is not finite, is in ",
                            c->refusal[0] ? c->refusal : where);
}

/* The vector that the step wrote to becomes the newest node. */
static void rotate(struct arkode *a, double t)
{
    const struct arkode_node fresh = a->node[a->nodes - 1];

    for (int k = a->nodes - 1; k > 0; k--)
        a->node[k] = a->node[k - 1];
    a->node[0] = fresh;
    a->node[0].t = t;
    a->node[0].has_f = false;
    a->stiff.has_start = false;
    a->known += a->known < a->nodes;
    arkode_reuse_last_stage(a);
    arkode_remember(a);
}

/* past: the controller before the step, whose error says little when it was cut short. */
static void report(struct arkode *a, bool stopped, const struct control *past,
                   struct method_step *out)
{
    struct choice made = a->choice[1];
    const double h = a->node[0].t - a->node[1].t;

    if (stopped && h < made.h * (1 - 1e-9))
        made.limiter = METHOD_OUTPUT;
    *out = (struct method_step){ .t = a->node[0].t, .h = h, .limiter = made.limiter,
                                 .rejected = a->rejected };
    choice_where(&made, a->moment, out->where);
    if (made.limiter != METHOD_OUTPUT || a->choice[0].h > a->natural)
        a->natural = a->choice[0].h;
    out->pace = control_pace(made.limiter == METHOD_OUTPUT ? past : &a->control, a->natural);
}

/* SUNDIALS 7 does not ask for the first stage where the table says that it is the
 * last one of the step before; dense output needs those rates all the same. */
static void prepare_first_stage(struct arkode *a)
{
    a->stage = 0;
    if (a->last.y && arkode_rates(a) != STATUS_DONE)
        a->node[0].has_f = false; /* the step will hear it too */
}

int arkode_step(void *self, double t_stop, struct method_step *out)
{
    struct arkode *a = self;
    const struct arkode_node *slot = &a->node[a->nodes - 1];
    const struct control past = a->control;
    sunrealtype t;
    int flag;
    long bad;

    if (!(t_stop > a->node[0].t))
        return status_fail(STATUS_FAILED, "a step to t = %.9g s was asked for at t = %.9g s",
                           t_stop, a->node[0].t);
    if (!a->launched)
        TRY(launch(a, t_stop));
    sundials_forget();
    prepare_first_stage(a);
    if (ARKodeSetStopTime(a->ark, t_stop) != 0 || arkode_stretch(a, t_stop) != 0)
        return refuse_launch(a);
    flag = ARKodeEvolve(a->ark, t_stop, slot->y, &t, ARK_ONE_STEP);
    bad = flag < 0 ? 0 : vector_bad(slot->y);
    if (a->def.seconds > 0 && bad >= 0)
        return arkode_constant_failed(a);
    if (flag < 0)
        return collapse(a, flag);
    if (bad >= 0)
        return failure_not_finite(a->row->method.name, t, moment_entry(a->moment, bad));
    rotate(a, t);
    report(a, flag == ARK_TSTOP_RETURN, &past, out);
    a->launched = flag != ARK_TSTOP_RETURN;
    return STATUS_DONE;
}

int arkode_restart(void *self, double t, const double *y, const struct method_pace *pace)
{
    struct arkode *a = self;

    vector_take(a->node[0].y, y);
    a->node[0].t = t;
    a->node[0].has_f = false;
    a->stiff.has_start = false;
    a->known = 1;
    a->stiff.pasts = 0;
    a->natural = pace ? pace->h : 0;
    a->launched = false;
    a->last.known = false;
    a->refusal[0] = '\0';
    control_start(&a->control, a->row->control, a->table.order, a->table.embedded, pace);
    arkode_remember(a);
    return STATUS_DONE;
}
