/* fixed-pcisph.c -- steps whose pressure is solved for: PCISPH.
 *
 *   P = that of solved/pcisph.h for a step h from (x, v)
 *   u_new = u + h a(x, u, P)
 *   x_new = x + h u_new
 *   h = min(CFL hs/max(v_max, U), 0.25 sqrt(hs/a_max), 1/2 of 1/rate for decay)     (PC6)
 *
 * What is compressed is pushed apart within a step, so that a short step among long ones has a
 * pressure many times too high: steps to the end of a segment are of about one length.  No
 * sound goes into the step.  U is the reference speed: without it the first steps, from
 * rest, would be too long.  Bodies with an implicit side take steps of their own under the
 * forces of that pressure, as `staggered` has it.  Solenthaler, Pajarola 2009; Toth 2012,
 * sections 3.4.3, 3.6. */
#include "time/fixed.h"

#include "algebra/vector.h"
#include "base/status.h"
#include "solved/pcisph.h"
#include <math.h>
#include <string.h>

static int take(struct fixed *x)
{
    struct pcisph *p;
    const int status = pcisph_create(x->moment, &p);

    x->own = p;
    return status;
}

static void leave(struct fixed *x)
{
    struct pcisph *p = x->own;

    pcisph_free(&p);
    x->own = NULL;
}

/* (PC6), over the rows of velocities of particles. */
static double length(struct fixed *x)
{
    const struct layout *l = moment_layout(x->moment);
    const double hs = plan_length(x->plan) / 2;
    struct limit decay;
    double h = x->number * pcisph_pace(x->own);

    x->limit = (struct limit){ .where = -1, .part = "reference speed" };
    for (int r = 0; r < l->rows; r++) {
        int fast = -1, pushed = -1;
        if (l->row[r].what != LAYOUT_VELOCITY || strncmp(l->row[r].name, "velocity", 8) != 0)
            continue;
        const double v = fixed_largest(x, r, x->y, &fast);
        const double a = fixed_largest(x, r, x->f, &pushed);
        if (v > 0)
            h = fixed_shorter(x, h, x->number * hs / v, fast, "velocity");
        if (a > 0)
            h = fixed_shorter(x, h, 0.25 * sqrt(hs / a), pushed, "acceleration");
    }
    pcisph_decay(x->own, x->t, x->y, &decay);
    return decay.rate > 0 ? fixed_shorter(x, h, 0.5 / decay.rate, decay.where, decay.part) : h;
}

/* Rates of the whole step, at its end: dense output and the next length see them. */
static void keep(struct fixed *x)
{
    const long u = x->from[LAYOUT_VELOCITY];

    vector_copy(x->n, x->rates, x->f);
    vector_copy(u, x->y + u, x->f);
    x->has_f = true;
}

static int advance(struct fixed *x, double h)
{
    const long u = x->from[LAYOUT_VELOCITY], rest = x->from[LAYOUT_OTHER];
    const double c[2] = { 1, h };

    TRY(moment_eval(x->moment, (struct ask){ .sides = x->kind->sides, .without_pressure = true },
                    x->t_old, x->y_old, x->rates));
    vector_copy(x->n, x->y_old, x->try);
    TRY(pcisph_solve(x->own, x->t_old, h, x->rates, x->try));
    TRY(moment_eval(x->moment, (struct ask){ .sides = x->kind->sides, .ahead = h / 2 }, x->t_old,
                    x->try, x->rates));
    pcisph_settle(x->own, h, x->y_old, x->try, x->rates);
    vector_combine(2, c, (const double *[]){ x->y_old + u, x->rates + u }, rest - u, x->y + u);
    vector_combine(2, c, (const double *[]){ x->y_old, x->y + u }, u, x->y);
    vector_combine(2, c, (const double *[]){ x->try + rest, x->rates + rest }, x->n - rest,
                   x->y + rest);
    if (x->ranges > 0)
        TRY(fixed_bend(x, h, x->rates));
    keep(x);
    return STATUS_DONE;
}

static const char *serves(const struct plan *plan)
{
    const char *why = method_bodies_alone(plan);

    if (!why)
        why = fixed_serves(plan);
    return why ? why : pcisph_serves(plan);
}

const struct fixed_kind fixed_pcisph = {
    .method = FIXED_METHOD_SERVING(serves, "pcisph", 1,
                           "pressure by prediction and correction until no fluid is compressed "
                           "by more than pcisph.limit; effects on densities do nothing; bodies "
                           "as in staggered; order 1",
                           "Solenthaler, Pajarola 2009; Toth 2012, (21), (22), section 3.4.3"),
    .number = 0.2,
    .sides = ASK_EXPLICIT,
    .even = true,
    .take = take,
    .leave = leave,
    .length = length,
    .advance = advance,
};
