/* beam-state.h -- where a beam's numbers stand in y. */
#ifndef BODIES_BEAM_STATE_H
#define BODIES_BEAM_STATE_H

#include "bodies/beam-make.h"

/* Entry of y that holds degree of freedom i of q (rate: of v). */
long beam_state_place(const struct body *b, const struct layout *l, int i, bool rate);

/* y to w->q and w->v; held degrees of freedom are 0 whatever y says. */
void beam_state_read(const struct body *b, struct body_work *w, const struct layout *l,
                     const double *y);

/* Are there prescribed loads at t? */
bool beam_state_pushed(const struct body *b, double t);

/* f [dofs] = weight and prescribed loads at t. */
void beam_state_loads(const struct body *b, double t, double *f);

/* All of *out but the damping, from w->force, w->inertia, w->v at t, and the water's force along
 * the axis.  The supports give what momentum needs beyond the loads: across, 1 . (M v' - F), where
 * what alpha and drag take counts as theirs (both hold on to the ground); along the axis, where
 * nothing moves, the opposite of the loads. */
void beam_state_report(const struct body *b, const struct body_work *w, double t, double axial,
                       struct body_load *out);

#endif
