/* dv.c -- staggered Verlet with error control: the frame around its formulas. */
#include "time/dv.h"

#include "base/status.h"
#include "time/constant.h"
#include "time/fixed.h"
#include <math.h>
#include <stdio.h>

static void swap(double **a, double **b)
{
    double *c = *a;

    *a = *b;
    *b = c;
}

static int refuse_start(const struct dv *x)
{
    return status_fail(STATUS_FAILED,
                       "dv cannot start at t = %g s: the right-hand side has no answer there (%s); "
                       "look for particles that overlap or start outside the domain", x->t,
                       plan_refusal(x->plan));
}

/* The message of a run that cannot go on. */
static int collapse(const struct dv *x, double h)
{
    const struct choice *c = &x->choice;
    char where[96];

    if (x->def.seconds > 0)
        return dv_constant_failed(x);
    choice_where(c, x->plan, where);
    return status_fail(STATUS_FAILED,
                       "dv collapsed at t = %.9g s, below a step of %.3g s: %s%s. Things to try: "
                       "a smaller tol, the norm \"max\", more viscosity or density diffusion, a "
                       "smaller spacing, a higher sound speed, or another method (imex3, cks43)",
                       x->t, h,
                       c->refusal[0] ? "the right-hand side has no answer: "
                                     : "no step, however short, passes the error test; the "
                                       "largest error, or what is not finite, is in ",
                       c->refusal[0] ? c->refusal : where);
}

static void keep_refusal(struct dv *x)
{
    const char *said = status_message(); /* of memory, or of a solve */

    snprintf(x->choice.refusal, sizeof x->choice.refusal, "%.319s",
             said[0] ? said : plan_refusal(x->plan));
    status_clear();
}

/* Error of a step from y_old; NAN when there is no answer. */
static double attempt(struct dv *x, double h)
{
    const bool answer = dv_advance(x, h) == STATUS_DONE;
    long bad;

    x->choice.refusal[0] = '\0';
    if (!answer) {
        keep_refusal(x);
        return NAN;
    }
    bad = vector_first_bad(x->n, x->y);
    if (bad < 0)
        return dv_error(x, h);
    x->choice.entry = bad;
    return NAN;
}

/* Shortens the step until it is accepted; `next` is what its error asks for then. */
static int accept(struct dv *x, double *h, double *next)
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

/* The newest rates become past.  Those of a step that was cut short take the place
 * of the last ones: differences over so short a time say nothing of longer steps. */
static void push(struct dv_past *p, bool short_)
{
    p->begun = p->f[1];
    swap(&p->f[0], &p->f[1]);
    if (!short_) {
        swap(&p->f[0], &p->f[2]);
        p->t[2] = p->t[1];
        p->known = 2;
    }
    p->t[1] = p->t[0];
}

/* Back to the state at the end of the last step. */
static int give_up(struct dv *x, double h)
{
    swap(&x->y, &x->y_old);
    x->stepped = false;
    return collapse(x, h);
}

static void report(const struct dv *x, bool cut, struct method_step *out)
{
    struct choice made = x->choice;

    if (cut)
        made.limiter = METHOD_OUTPUT;
    *out = (struct method_step){ .t = x->t, .h = x->t - x->t_old, .limiter = made.limiter,
                                 .rejected = x->rejected };
    choice_where(&made, x->plan, out->where);
}

static int take(struct dv *x, double t_stop, struct method_step *out)
{
    const struct control before = x->control;
    const double asked = x->choice.h, left = t_stop - x->t;
    const double slack = x->def.seconds > 0 ? CONSTANT_SLACK : 1e-12;
    double h = asked >= left * (1 - slack) ? left : asked, next;

    x->t_old = x->t;
    swap(&x->y, &x->y_old);
    if (accept(x, &h, &next) != STATUS_DONE)
        return give_up(x, h);
    const bool cut = h == left && h < asked * (1 - 1e-9);
    const bool short_ = cut && h < asked / 3 && x->a.known > 1;
    x->t = h == left ? t_stop : x->t_old + h;
    x->stepped = true;
    swap(&x->load, &x->load_old);
    push(&x->a, short_);
    push(&x->d, short_);
    report(x, cut, out);
    if (cut)
        x->control = before;
    dv_choose(x, cut ? asked : next);
    return STATUS_DONE;
}

int dv_step(void *self, double t_stop, struct method_step *out)
{
    struct dv *x = self;

    if (!(t_stop > x->t))
        return status_fail(STATUS_FAILED, "a step to t = %.9g s was asked for at t = %.9g s",
                           t_stop, x->t);
    if (!x->ready) {
        if (dv_begin(x) != STATUS_DONE)
            return refuse_start(x);
        dv_first(x, t_stop);
    }
    return take(x, t_stop, out);
}

static const char *serves(const struct plan *plan)
{
    const char *why = fixed_serves(plan);

    return why ? why : plan_halves(plan);
}

static const double *state(const void *self)
{
    return ((const struct dv *)self)->y;
}

static const char *table(const void *self)
{
    (void)self;
    return "dv";
}

const struct method dv_method = {
    .name = "dv",
    .about = "staggered Verlet, velocities and densities in turn, order 2 (1 in the dissipative "
             "terms), with error control, bodies implicit",
    .source = "Verlet, Phys. Rev. 159 (1967) 98-103",
    .adaptive = true,
    .order = 2,
    .serves = serves,
    .create = dv_create,
    .step = dv_step,
    .at = dv_at,
    .state = state,
    .restart = dv_restart,
    .table = table,
    .free = dv_free,
    .vectors = dv_vectors,
};
