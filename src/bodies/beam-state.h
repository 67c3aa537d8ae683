/* beam-state.h -- where a beam's numbers stand in y. */
#ifndef BODIES_BEAM_STATE_H
#define BODIES_BEAM_STATE_H

#include "bodies/beam-make.h"

/* Entry of y that holds degree of freedom i of q (rate: of v). */
long beam_state_place(const struct body *b, const struct layout *l, int i, bool rate);

/* y to w->q and w->v; held degrees of freedom are 0 whatever y says. */
void beam_state_read(const struct body *b, struct body_work *w, const struct layout *l,
                     const double *y);

#endif
