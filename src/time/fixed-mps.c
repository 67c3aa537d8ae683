/* fixed-mps.c -- MPS: the frame gives the rates by all but the pressure, solved/mps.h takes
 * the step.
 *
 * The error is of order 1.  Between two steps the state is a straight line: corrections of a
 * step have no rate. */
#include "time/fixed.h"

#include "algebra/vector.h"
#include "base/status.h"
#include "solved/mps.h"

#include <math.h>

static int take(struct fixed *x)
{
    struct mps *mps = NULL;
    const int status = mps_create(x->moment, &mps);

    x->own = mps;
    return status;
}

static void leave(struct fixed *x)
{
    struct mps *mps = x->own;

    mps_free(&mps);
    x->own = NULL;
}

static double length(struct fixed *x)
{
    return mps_length(x->own, x->number, x->t, x->y, &x->limit);
}

static int advance(struct fixed *x, double h)
{
    return mps_step(x->own, x->t_old, h, x->y_old, x->f_old, x->y);
}

static int at(void *self, double t, double *y)
{
    struct fixed *x = self;
    const double s = x->stepped ? (t - x->t_old) / (x->t - x->t_old) : 0;

    if (t == x->t || !x->stepped || !(t >= x->t_old && t < x->t))
        return fixed_at(self, t, y);
    vector_combine(2, (const double[]){ 1 - s, s }, (const double *[]){ x->y_old, x->y }, x->n, y);
    return STATUS_DONE;
}

const struct fixed_kind fixed_mps = {
    .method = { .name = "mps",
                .told = { "moving particle semi-implicit: pressure of an incompressible fluid, solved "
                          "for in each step (group mps); order 1",
                          "Koshizuka, Oka, Nucl. Sci. Eng. 123 (1996) 421-434" },
                .adaptive = false, .order = 1, .serves = mps_serves, .create = fixed_create,
                .step = fixed_step, .at = at, .state = fixed_state, .restart = fixed_restart,
                .table = fixed_table, .free = fixed_free, .vectors = fixed_vectors,
                .rearrange = fixed_rearrange },
    .number = 0.2,
    .sides = ASK_EXPLICIT,
    .without_pressure = true,
    .remedy = "Steps are not halved, as pressures grow with shorter ones. Try mps@0.2, which "
              "chooses its steps, mps.gamma = 0.2 or mps.bundle = \"enhanced\"",
    .length = length,
    .advance = advance,
    .take = take,
    .leave = leave,
};
