/* paced.c -- steps with error control: tried, shortened, accepted and reported. */
#include "time/paced.h"

#include "base/status.h"
#include "time/constant.h"
#include "time/failure.h"
#include <math.h>
#include <stdio.h>

static const char *name(const struct paced *x)
{
    return x->kind->method.name;
}

/* The message of a run that cannot go on. */
static int collapse(const struct paced *x, double h)
{
    const struct choice *c = &x->choice;
    char where[96];

    if (x->def.seconds > 0)
        return paced_constant_failed(x);
    choice_where(c, x->moment, where);
    return status_fail_with(STATUS_FAILED,
                            (struct status_advice){ .remedy = FAILURE_REMEDY_METHODS },
                            "%s collapsed at t = %.9g s, below a step of %.3g s: %s%s", name(x),
                            x->t, h,
                            c->refusal[0] ? "the right-hand side has no answer: "
                                          : "no step, however short, passes the error test; the "
                                            "largest error, or what is not finite, is in ",
                            c->refusal[0] ? c->refusal : where);
}

/* The failure stays in choice.refusal alone, as a shorter step may do. */
static void keep_refusal(struct paced *x)
{
    snprintf(x->choice.refusal, sizeof x->choice.refusal, "%.319s", x->kind->refusal(x));
    status_clear();
}

static int begin(struct paced *x, double t_stop)
{
    if (x->kind->begin(x) != STATUS_DONE) {
        keep_refusal(x);
        return failure_start(name(x), x->t, x->choice.refusal);
    }
    x->ready = true;
    paced_first(x, t_stop);
    return STATUS_DONE;
}

static void swap_states(struct paced *x)
{
    double *const y = x->y;

    x->y = x->y_old;
    x->y_old = y;
}

/* Error of a step from y_old; NAN when there is no answer.  A constant step has none. */
static double attempt(struct paced *x, double h)
{
    struct vector_own own;
    long bad;

    x->choice.refusal[0] = '\0';
    if (x->kind->advance(x, h) != STATUS_DONE) {
        keep_refusal(x);
        return NAN;
    }
    own = moment_own(x->moment);
    bad = vector_bad_anywhere(x->n, x->y, &own);
    if (bad < 0)
        return x->def.seconds > 0 ? 0 : x->kind->error(x, h);
    x->choice.entry = bad;
    return NAN;
}

/* Shortens the step until it is accepted; `next` is what its error asks for then. */
static int accept(struct paced *x, double *h, double *next)
{
    for (;;) {
        const double e = attempt(x, *h);
        *next = control_next(&x->control, *h, e);
        if (e <= x->control.row->accept)
            return STATUS_DONE;
        x->rejected++;
        x->choice.limiter = METHOD_ERROR;
        if (isfinite(e))
            x->choice.entry = vector_largest(x->error);
        *h = isfinite(e) ? *next : *h / 2;
        if (*h < x->h_min)
            return STATUS_FAILED;
    }
}

/* Back to the state at the end of the last step. */
static int give_up(struct paced *x, double h)
{
    swap_states(x);
    x->stepped = false;
    return collapse(x, h);
}

static void report(const struct paced *x, bool cut, struct method_step *out)
{
    struct choice made = x->choice;

    if (cut)
        made.limiter = METHOD_OUTPUT;
    *out = (struct method_step){ .t = x->t, .h = x->t - x->t_old, .limiter = made.limiter,
                                 .rejected = x->rejected };
    choice_where(&made, x->moment, out->where);
}

/* Rates of a step that was cut short take the place of the last ones: differences over
 * so short a time say nothing of longer steps. */
static int take(struct paced *x, double t_stop, struct method_step *out)
{
    const struct control before = x->control;
    const double asked = x->choice.h, left = t_stop - x->t;
    const double slack = x->def.seconds > 0 ? CONSTANT_SLACK : 1e-12;
    double h = asked >= left * (1 - slack) ? left : asked, next;

    x->t_old = x->t;
    swap_states(x);
    if (accept(x, &h, &next) != STATUS_DONE)
        return give_up(x, h);
    const bool cut = h == left && h < asked * (1 - 1e-9);
    x->t = h == left ? t_stop : x->t_old + h;
    x->stepped = true;
    x->kind->remember(x, cut && h < asked / 3);
    report(x, cut, out);
    if (cut)
        x->control = before;
    paced_choose(x, cut ? asked : next);
    out->pace = control_pace(&x->control, x->choice.h);
    return STATUS_DONE;
}

int paced_step(void *self, double t_stop, struct method_step *out)
{
    struct paced *x = self;

    if (!(t_stop > x->t))
        return status_fail(STATUS_FAILED, "a step to t = %.9g s was asked for at t = %.9g s",
                           t_stop, x->t);
    if (!x->ready)
        TRY(begin(x, t_stop));
    return take(x, t_stop, out);
}

int paced_at(void *self, double t, double *y)
{
    struct paced *x = self;

    if (t == x->t || (x->stepped && t == x->t_old)) {
        vector_copy(x->n, t == x->t ? x->y : x->y_old, y);
        return STATUS_DONE;
    }
    if (!x->stepped || !(t > x->t_old && t < x->t))
        return status_fail(STATUS_FAILED, "the state at t = %.9g s was asked for, which does not "
                                          "lie in the last step (to %.9g s)", t, x->t);
    x->kind->inside(x, t, y);
    return STATUS_DONE;
}

const double *paced_state(const void *self)
{
    return ((const struct paced *)self)->y;
}
