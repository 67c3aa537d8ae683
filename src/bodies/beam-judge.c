/* beam-judge.c -- how far a linear beam may bend.
 *
 * A cantilever with a force at its tip, by the exact curve (Bisshopp and Drucker, Quart. Appl.
 * Math. 3 (1945) 272-275): where the linear tip moves by a tenth of the length, the exact one
 * is 1 % behind, at a fifth 4 %, at a half a fifth. */
#include "bodies/beam-judge.h"

#include "base/status.h"

#include <math.h>
#include <stdio.h>

static const double doubtful = 0.1, wrong = 0.2; /* of the length */

/* Largest deflection of a node [m]. */
static double deflection(const struct body *b, const struct layout *l, const double *y)
{
    double most = 0;

    for (int i = 0; i < b->bending->dofs; i += 2)
        most = fmax(most, fabs(y[beam_state_place(b, l, i, false)]));
    return most;
}

int beam_judge(const struct body *b, const struct layout *l, double t, const double *y,
               char *doubt, size_t room)
{
    const double length = b->bending->l * b->bending->def.elements;
    const double share = deflection(b, l, y) / length;

    doubt[0] = '\0';
    if (share > wrong && !b->trusted)
        return status_fail_with(STATUS_FAILED, (struct status_advice){
                                    .cause = "A linear beam is right for small deflections only",
                                    .remedy = "set theory = \"elastica\" for it, or theory = "
                                              "\"linear\" if you want it so" },
                                "%s has bent by %.3g %% of its length at t = %g s, more than %g %%",
                                b->path, 100 * share, t, 100 * wrong);
    if (share > doubtful)
        snprintf(doubt, room, "%s has bent by %.3g %% of its length at t = %g s; linear beams are "
                 "right to 1 %% below %g %%: take theory = \"elastica\"", b->path, 100 * share, t,
                 100 * doubtful);
    return STATUS_DONE;
}

bool beam_judge_held(const struct body *b, int i)
{
    const struct bending_def *d = &b->bending->def;

    return skin_held(&b->skin->def, d->root != BENDING_FREE, d->tip != BENDING_FREE, i);
}
