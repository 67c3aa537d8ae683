/* fixed-pcisph.c -- steps whose pressure is solved for: PCISPH, by solved/pcisph.h.
 *
 * What is compressed is pushed apart within a step, so that a short step among long ones has a
 * pressure many times too high: steps to the end of a segment are of about one length.
 * Bodies with an implicit side take steps of their own under the forces of that pressure, as
 * `staggered` has it. */
#include "time/fixed.h"

#include "algebra/vector.h"
#include "base/status.h"

/* Rates of the whole step, at its end: dense output and the next length see them. */
static void keep(struct fixed *x)
{
    const long u = x->from[LAYOUT_VELOCITY];

    vector_copy(x->n, x->rates, x->f);
    vector_copy(u, x->y + u, x->f);
    x->has_f = true;
}

/* Backward Euler has M (v_new - v)/h = F - K q_new - D v_new: what supports give and damping takes
 * is that of the end of a step. */
static void book(struct fixed *x, double t, double h)
{
    moment_body_book(x->moment, t, x->y, h, x->y);
}

/* The step has booked what bodies get where it starts. */
static int bend(struct fixed *x, double h)
{
    moment_body_book(x->moment, x->t_old, x->y_old, -h, x->y);
    return fixed_bend(x, h, x->rates, book);
}

static int advance(struct fixed *x, double h)
{
    TRY(fixed_solved_advance(x, h));
    if (x->ranges > 0)
        TRY(bend(x, h));
    keep(x);
    return STATUS_DONE;
}

static const char *serves(const struct plan *plan)
{
    const char *why = method_bodies_alone(plan);

    if (!why)
        why = fixed_serves(plan);
    return why ? why : fixed_solved_serves("pcisph", plan);
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
    .spared = 1,
    .take = fixed_solved_take,
    .leave = fixed_solved_leave,
    .length = fixed_solved_length,
    .advance = advance,
};
