/* ab3.c -- Adams-Bashforth with error control: the frame around its formulas. */
#include "time/ab3.h"

#include "base/status.h"
#include "time/constant.h"
#include "time/dense.h"
#include <math.h>
#include <stdio.h>

/* The message of a run that cannot go on. */
static int collapse(const struct ab3 *x, double h)
{
    const struct choice *c = &x->choice;
    char where[96];

    if (x->def.seconds > 0)
        return ab3_constant_failed(x);
    choice_where(c, x->rates.plan, where);
    return status_fail(STATUS_FAILED,
                       "ab3 collapsed at t = %.9g s, below a step of %.3g s: %s%s. Things to try: "
                       "a smaller tol, the norm \"max\", more viscosity or density diffusion, a "
                       "smaller spacing, a higher sound speed, or another method (imex3, cks43)",
                       x->t, h,
                       c->refusal[0] ? "the right-hand side has no answer: "
                                     : "no step, however short, passes the error test; the "
                                       "largest error, or what is not finite, is in ",
                       c->refusal[0] ? c->refusal : where);
}

static int begin(struct ab3 *x, double t_stop)
{
    if (rates_ask(&x->rates, x->t, x->y, x->f[0]) != STATUS_DONE)
        return status_fail(STATUS_FAILED,
                           "ab3 cannot start at t = %.9g s: the right-hand side has no answer there "
                           "(%s); look for particles that overlap or start outside the domain",
                           x->t, x->rates.refusal);
    x->time[0] = x->t;
    x->known = 1;
    x->ready = true;
    ab3_first(x, t_stop);
    return STATUS_DONE;
}

static void swap_states(struct ab3 *x)
{
    double *const y = x->y;

    x->y = x->y_old;
    x->y_old = y;
}

/* Error of a step from y_old; NAN when there is no answer. */
static double attempt(struct ab3 *x, double h)
{
    const bool answer = ab3_advance(x, h) == STATUS_DONE;
    long bad;

    snprintf(x->choice.refusal, sizeof x->choice.refusal, "%s", answer ? "" : x->rates.refusal);
    if (!answer)
        return NAN;
    bad = vector_first_bad(x->n, x->y);
    if (bad < 0)
        return x->def.seconds > 0 ? 0 : N_VWrmsNorm(x->error, x->weight);
    x->choice.entry = bad;
    return NAN;
}

/* Shortens the step until it is accepted; `next` is what its error asks for then. */
static int accept(struct ab3 *x, double *h, double *next)
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
static int give_up(struct ab3 *x, double h)
{
    swap_states(x);
    x->stepped = false;
    return collapse(x, h);
}

static void report(const struct ab3 *x, bool cut, struct method_step *out)
{
    struct choice made = x->choice;

    if (cut)
        made.limiter = METHOD_OUTPUT;
    *out = (struct method_step){ .t = x->t, .h = x->t - x->t_old, .limiter = made.limiter,
                                 .rejected = x->rejected };
    choice_where(&made, x->rates.plan, out->where);
}

/* Rates of a step that was cut short take the place of the last ones: differences over
 * so short a time say nothing of longer steps. */
static int take(struct ab3 *x, double t_stop, struct method_step *out)
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
    ab3_remember(x, cut && h < asked / 3);
    report(x, cut, out);
    if (cut)
        x->control = before;
    ab3_choose(x, cut ? asked : next);
    return STATUS_DONE;
}

int ab3_step(void *self, double t_stop, struct method_step *out)
{
    struct ab3 *x = self;

    if (!(t_stop > x->t))
        return status_fail(STATUS_FAILED, "a step to t = %.9g s was asked for at t = %.9g s",
                           t_stop, x->t);
    if (!x->ready)
        TRY(begin(x, t_stop));
    return take(x, t_stop, out);
}

/* The Hermite interpolant of the last step's ends: its error is of order h^4. */
int ab3_at(void *self, double t, double *y)
{
    struct ab3 *x = self;
    const double time[2] = { x->t, x->t_old };
    double c[4];

    if (t == x->t || (x->stepped && t == x->t_old)) {
        vector_copy(x->n, t == x->t ? x->y : x->y_old, y);
        return STATUS_DONE;
    }
    if (!x->stepped || !(t > x->t_old && t < x->t))
        return status_fail(STATUS_FAILED, "the state at t = %.9g s was asked for, which does not "
                                          "lie in the last step (to %.9g s)", t, x->t);
    dense_hermite(2, time, t, c, c + 2);
    vector_combine(4, c, (const double *[]){ x->y, x->y_old, x->f[0], x->begun }, x->n, y);
    return STATUS_DONE;
}

static const char *serves(const struct plan *plan)
{
    return plan_size(plan) == 0 ? "nothing in this scene moves" : NULL;
}

static const double *state(const void *self)
{
    return ((const struct ab3 *)self)->y;
}

static const char *table(const void *self)
{
    (void)self;
    return "AB3, variable step";
}

const struct method ab3_method = {
    .name = "ab3",
    .about = "explicit multistep, Adams-Bashforth of order 3 with error control, 1 right-hand "
             "side a step",
    .source = "Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section III.5",
    .adaptive = true,
    .order = 3,
    .serves = serves,
    .create = ab3_create,
    .step = ab3_step,
    .at = ab3_at,
    .state = state,
    .restart = ab3_restart,
    .table = table,
    .free = ab3_free,
    .vectors = ab3_vectors,
};
