/* fixed.c -- the frame of methods without error control. */
#include "time/fixed.h"

#include "algebra/vector.h"
#include "base/status.h"
#include "state/scales.h"
#include "time/constant.h"
#include "time/dense.h"
#include <math.h>
#include <stdio.h>

enum { HALVINGS = 6 };

static bool paired(const struct layout *l)
{
    int v = 0;

    for (int x = 0; x < l->rows; x++) {
        if (l->row[x].what != LAYOUT_POSITION)
            continue;
        while (v < l->rows && l->row[v].what != LAYOUT_VELOCITY)
            v++;
        if (v == l->rows || l->row[v].n != l->row[x].n
            || l->row[v].components != l->row[x].components)
            return false;
        v++;
    }
    return l->from[1] - l->from[0] == l->from[2] - l->from[1];
}

const char *fixed_serves(const struct plan *plan)
{
    if (plan_size(plan) == 0)
        return "nothing in this scene moves";
    if (plan_drifts(plan))
        return plan_drifts(plan);
    return paired(plan_layout(plan)) ? NULL
                                     : "its positions and velocities do not pair up one by one (bodies "
                                       "that turn in 3D have four and three, for example)";
}

/* A wave part states SCALES_WAVE (c0 + v)/hs as its fastest rate. */
static double longest(struct fixed *x, bool stiff)
{
    struct limit limit[2];
    double wave, decay;

    moment_limit(x->moment, x->t, x->y, stiff, limit);
    wave = limit[0].rate > 0 ? x->number * SCALES_WAVE / limit[0].rate : HUGE_VAL;
    decay = limit[1].rate > 0 ? 0.5 / limit[1].rate : HUGE_VAL;
    x->limit = limit[decay < wave];
    return fmin(wave, decay);
}

double fixed_wave_step(struct fixed *x)
{
    return longest(x, plan_stiff(x->plan) && x->ranges == 0);
}

double fixed_explicit_step(struct fixed *x)
{
    return longest(x, plan_stiff(x->plan));
}

void fixed_hold(const struct fixed *x, double *to)
{
    for (int k = 0; k < x->ranges; k++)
        vector_copy(x->range[k][1] - x->range[k][0], x->y_old + x->range[k][0],
                    to + x->range[k][0]);
}

static int ensure_rates(struct fixed *x)
{
    if (!x->has_f)
        TRY(moment_eval(x->moment,
                        (struct ask){ .sides = x->kind->sides,
                                      .without_pressure = x->kind->without_pressure },
                        x->t, x->y, x->f));
    x->has_f = true;
    return STATUS_DONE;
}

/* Length of the next step [s]: as asked for, or by the rule. */
static double length(struct fixed *x)
{
    if (!(x->seconds > 0))
        return x->kind->length(x);
    x->limit = (struct limit){ .where = -1, .part = CONSTANT_PART };
    return x->seconds;
}

/* Of a kind that knows no better length. */
static int stuck(struct fixed *x, double h)
{
    const char *refusal = moment_refusal(x->moment);
    char cause[80];

    snprintf(cause, sizeof cause, "Its own step is %.3g s there", x->kind->length(x));
    return status_fail_with(STATUS_FAILED, (struct status_advice){ cause, x->kind->remedy },
                            "%s has no answer at t = %.9g s, in a step of %.3g s: %s",
                            x->kind->method.name, x->t_old, h,
                            refusal[0] ? refusal : "the state is not finite");
}

static int collapse(struct fixed *x, double h)
{
    const char *refusal = moment_refusal(x->moment);
    char remedy[160];

    if (x->kind->remedy)
        return stuck(x, h);
    if (x->seconds > 0 && h > 0) {
        const double bound = x->kind->length(x);
        return constant_fail(x->kind->method.name, x->seconds, x->t, refusal, bound, &x->limit);
    }
    snprintf(remedy, sizeof remedy, "It does not control its error: try %s@%g, or a method that "
             "does (imex3, ark436)", x->kind->method.name, x->number / 2);
    return status_fail_with(STATUS_FAILED, (struct status_advice){ .remedy = remedy },
                            "%s has no answer at t = %.9g s, not even after a step of %.3g s: %s",
                            x->kind->method.name, x->t_old, h,
                            refusal[0] ? refusal : "the state is not finite");
}

static void swap(double **a, double **b)
{
    double *c = *a;

    *a = *b;
    *b = c;
}

/* y, f become y_old, f_old; t_old is where the step starts. */
static void begin(struct fixed *x)
{
    swap(&x->y, &x->y_old);
    swap(&x->f, &x->f_old);
    x->t_old = x->t;
    x->has_f = false;
}

static int attempt(struct fixed *x, double h)
{
    const struct vector_own own = moment_own(x->moment);

    TRY(x->kind->advance(x, h));
    return vector_bad_anywhere(x->n, x->y, &own) < 0 ? STATUS_DONE : STATUS_FAILED;
}

/* Halves the step while there is no answer. */
static int advance(struct fixed *x, double *h)
{
    for (int k = 0; attempt(x, *h) != STATUS_DONE; k++) {
        x->has_f = false;
        x->halved++;
        if (x->kind->remedy || k == HALVINGS || *h / 2 < x->h_min)
            return STATUS_FAILED;
        status_clear(); /* what a solve said */
        *h /= 2;
    }
    return STATUS_DONE;
}

/* The state stays that of the last step. */
static int give_up(struct fixed *x, double h)
{
    swap(&x->y, &x->y_old);
    swap(&x->f, &x->f_old);
    x->has_f = true;
    x->stepped = false;
    return collapse(x, h);
}

static void report(const struct fixed *x, double h, enum method_limiter limiter,
                   struct method_step *out)
{
    *out = (struct method_step){ .t = x->t, .h = h, .limiter = limiter, .rejected = x->halved };
    if (limiter == METHOD_OUTPUT)
        snprintf(out->where, sizeof out->where, "end of the segment");
    else if (x->limit.where >= 0)
        snprintf(out->where, sizeof out->where, "%s, particle %d", x->limit.part, x->limit.where);
    else
        snprintf(out->where, sizeof out->where, "%s", x->limit.part);
}

/* Steps of one length up to a stop; one that was asked for in seconds stays if it fits. */
static double even_out(const struct fixed *x, double left, double h)
{
    const double steps = left / h;

    return x->seconds > 0 && fabs(steps - round(steps)) < 1e-6 ? h : left / ceil(steps - 1e-9);
}

int fixed_step(void *self, double t_stop, struct method_step *out)
{
    struct fixed *x = self;
    const double left = t_stop - x->t;
    double h, asked;

    x->t_old = x->t;
    if (!(left > 0))
        return status_fail(STATUS_FAILED, "a step to t = %.9g s was asked for at t = %.9g s",
                           t_stop, x->t);
    if (ensure_rates(x) != STATUS_DONE)
        return collapse(x, 0);
    h = length(x);
    if (x->kind->even)
        h = even_out(x, left, h);
    const bool last = h >= left * (1 - (x->seconds > 0 ? CONSTANT_SLACK : 1e-12));
    asked = h = last ? left : h;
    begin(x);
    if (advance(x, &h) != STATUS_DONE)
        return give_up(x, h);
    x->t = last && h == asked ? t_stop : x->t_old + h;
    x->stepped = true;
    report(x, h, last && h == asked ? METHOD_OUTPUT : METHOD_STABILITY, out);
    return STATUS_DONE;
}

/* Rates do not hold the stiff side of bodies with steps of their own: a straight
 * line from end to end. */
static void line_at(const struct fixed *x, double t, double *y)
{
    const double s = (t - x->t_old) / (x->t - x->t_old);

    for (int k = 0; k < x->ranges; k++)
        for (long i = x->range[k][0]; i < x->range[k][1]; i++)
            y[i] = x->y_old[i] + s * (x->y[i] - x->y_old[i]);
}

int fixed_at(void *self, double t, double *y)
{
    struct fixed *x = self;
    const double time[2] = { x->t, x->t_old };
    double c[4];

    if (t == x->t || (x->stepped && t == x->t_old)) {
        vector_copy(x->n, t == x->t ? x->y : x->y_old, y);
        return STATUS_DONE;
    }
    if (!x->stepped || !(t > x->t_old && t < x->t))
        return status_fail(STATUS_FAILED, "the state at t = %.9g s was asked for, which does not "
                                          "lie in the last step (to %.9g s)", t, x->t);
    if (ensure_rates(x) != STATUS_DONE)
        return collapse(x, x->t - x->t_old);
    dense_hermite(2, time, t, c, c + 2);
    vector_combine(4, c, (const double *[]){ x->y, x->y_old, x->f, x->f_old }, x->n, y);
    line_at(x, t, y);
    return STATUS_DONE;
}

const double *fixed_state(const void *self)
{
    return ((const struct fixed *)self)->y;
}

const char *fixed_table(const void *self)
{
    return ((const struct fixed *)self)->table;
}
