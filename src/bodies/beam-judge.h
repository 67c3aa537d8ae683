/* beam-judge.h -- how far a linear beam may bend. */
#ifndef BODIES_BEAM_JUDGE_H
#define BODIES_BEAM_JUDGE_H

#include "bodies/beam-state.h"

/* Members of the watch of bodies_beam: see bodies.h.  A deflection of a tenth of the length is worth a
 * doubt, one of a fifth ends a run whose scene does not ask for theory = "linear" itself. */
int beam_judge(const struct body *b, const struct layout *l, double t, const double *y,
               char *doubt, size_t room);
bool beam_judge_held(const struct body *b, int i);
const struct body_surface *beam_judge_surface(const struct body *b);
double beam_judge_foresee(const struct body *b, const struct scales *s);

#endif
