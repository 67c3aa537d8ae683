/* pcisph-step.c -- a step whose pressure prediction and correction find:
 *
 *   P = that of pcisph.h for a step h from (x, v)
 *   u_new = u + h a(x, u, P)
 *   x_new = x + h u_new
 *   h = min(CFL hs/max(v_max, U), 0.25 sqrt(hs/a_max), 1/2 of 1/rate for decay)     (PC6)
 *
 * No sound goes into the step.  U is the reference speed: without it the first steps, from
 * rest, would be too long.  Its rates are those of the whole step, but for positions.
 * Solenthaler, Pajarola 2009; Toth 2012, sections 3.4.3, 3.6. */
#include "eval/given.h"
#include "solved/largest.h"
#include "solved/pcisph-inside.h"

#include "algebra/vector.h"
#include "base/status.h"
#include "plan/solver.h"

#include <math.h>
#include <stdio.h>

static int create(struct moment *moment, void **out)
{
    struct pcisph *p;
    const int status = pcisph_create(moment, &p);

    *out = p;
    return status;
}

static void leave(void **self)
{
    struct pcisph *p = *self;

    pcisph_free(&p);
    *self = NULL;
}

/* The shorter one of h and `other`, which then is what decides. */
static double shorter(double h, double other, int where, const char *name, struct limit *limit)
{
    if (!(other < h))
        return h;
    *limit = (struct limit){ .where = where };
    snprintf(limit->part, sizeof limit->part, "%.63s", name);
    return other;
}

static double length(void *self, double number, double t, const double *y, const double *f,
                     struct limit *limit)
{
    const struct pcisph *p = self;
    const double hs = p->m->plan->scales.support / 2;
    int fast = -1, pushed = -1;
    const double v = largest_inside(p->m, y, y, &fast), a = largest_inside(p->m, y, f, &pushed);
    double h = number * pcisph_pace(p);
    struct limit decay;

    *limit = (struct limit){ .where = -1, .part = "reference speed" };
    if (v > 0)
        h = shorter(h, number * hs / v, fast, "velocity", limit);
    if (a > 0)
        h = shorter(h, 0.25 * sqrt(hs / a), pushed, "acceleration", limit);
    pcisph_decay(p, t, y, &decay);
    return decay.rate > 0 ? shorter(h, 0.5 / decay.rate, decay.where, decay.part, limit) : h;
}

static int step(void *self, double t, double h, const double *y, const double *f, double *to,
                double *rates)
{
    struct pcisph *p = self;
    const long *from = p->m->layout.from, size = moment_size(p->m);
    const long u = from[LAYOUT_VELOCITY], rest = from[LAYOUT_OTHER];
    const double c[2] = { 1, h };

    (void)f;
    TRY(moment_eval(p->m, (struct ask){ .sides = ASK_EXPLICIT, .without_pressure = true }, t, y,
                    rates));
    vector_copy(size, y, to);
    TRY(pcisph_solve(p, t, h, rates, to));
    TRY(moment_eval(p->m, (struct ask){ .sides = ASK_EXPLICIT, .ahead = h / 2 }, t, to, rates));
    given_start(p->m);
    pcisph_settle(p, h, y, to, rates);
    vector_combine(2, c, (const double *[]){ y + u, rates + u }, rest - u, to + u);
    vector_combine(2, c, (const double *[]){ y, to + u }, u, to);
    vector_combine(2, c, (const double *[]){ to + rest, rates + rest }, size - rest, to + rest);
    return STATUS_DONE;
}

const struct plan_solved solved_pcisph = {
    .name = "pcisph", .serves = pcisph_serves, .create = create, .free = leave,
    .memory = pcisph_memory,
    .length = length, .step = step,
};
