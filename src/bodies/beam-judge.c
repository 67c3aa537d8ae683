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

/* Largest deflection under an even load q is q L^4/(k EI); k by the two ends, 0: none holds it. */
static const double evenly[3][3] = {
    [BENDING_CLAMPED] = { 384, 185, 8 },
    [BENDING_PINNED] = { 185, 384.0 / 5, 0 },
    [BENDING_FREE] = { 8, 0, 0 },
};

/* Water at the reference speed presses by rho U^2/2 on one side; the plate of toth-beam.scene bends
 * by half of what that gives. */
double beam_judge_foresee(const struct body *b, const struct scales *s)
{
    const struct bending_def *d = &b->bending->def;
    const double load = 0.5 * s->rho0 * s->speed * s->speed, k = evenly[d->root][d->tip];
    const double length = b->bending->l * d->elements;

    if (b->trusted || !(k > 0))
        return 0;
    return 0.5 * load * pow(length, 3) / (k * d->EI) / wrong;
}

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

const struct body_surface *beam_judge_surface(const struct body *b)
{
    return &b->surface;
}
