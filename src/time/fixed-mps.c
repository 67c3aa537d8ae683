/* fixed-mps.c -- MPS: the frame gives the rates by all but the pressure, solved/mps.h takes
 * the step.
 *
 * The error is of order 1.  Between two steps the state is a straight line: corrections of a
 * step have no rate.  Sources of pressure grow as 1/dt^2, so a short last step before a stop
 * would throw the fluid apart: steps up to there are of one length. */
#include "time/fixed.h"

#include "algebra/vector.h"
#include "base/status.h"

static int at(void *self, double t, double *y)
{
    struct fixed *x = self;
    const double s = x->stepped ? (t - x->t_old) / (x->t - x->t_old) : 0;

    if (t == x->t || !x->stepped || !(t >= x->t_old && t < x->t))
        return fixed_at(self, t, y);
    vector_combine(2, (const double[]){ 1 - s, s }, (const double *[]){ x->y_old, x->y }, x->n, y);
    return STATUS_DONE;
}

static const char *serves(const struct plan *plan)
{
    return fixed_solved_serves("mps", plan);
}

const struct fixed_kind fixed_mps = {
    .method = { .name = "mps",
                .told = { "moving particle semi-implicit: pressure of an incompressible fluid, solved "
                          "for in each step (group mps); order 1",
                          "Koshizuka, Oka, Nucl. Sci. Eng. 123 (1996) 421-434" },
                .adaptive = false, .order = 1, .serves = serves, .create = fixed_create,
                .step = fixed_step, .at = at, .state = fixed_state, .restart = fixed_restart,
                .table = fixed_table, .free = fixed_free, .room = { fixed_vectors },
                .rearrange = fixed_rearrange },
    .number = 0.2,
    .even = true,
    .sides = ASK_EXPLICIT,
    .without_pressure = true,
    .spared = 2,
    .remedy = "Steps are not halved, as pressures grow with shorter ones. Try mps@0.2, which "
              "chooses its steps, mps.gamma = 0.2 or mps.bundle = \"enhanced\"",
    .take = fixed_solved_take,
    .leave = fixed_solved_leave,
    .length = fixed_solved_length,
    .advance = fixed_solved_advance,
};
