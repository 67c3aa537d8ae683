/* elastica-state.h -- where the numbers of a beam that bends far stand in y. */
#ifndef BODIES_ELASTICA_STATE_H
#define BODIES_ELASTICA_STATE_H

#include "bodies/elastica-make.h"

/* Entry of y that holds degree of freedom i of q (rate: of v). */
long elastica_state_place(const struct body *b, const struct layout *l, int i, bool rate);

/* y to w->q and w->v; held degrees of freedom are 0 whatever y says. */
void elastica_state_read(const struct body *b, struct body_work *w, const struct layout *l,
                         const double *y);

/* f [dofs] = weight and prescribed loads at t and w->q; the latter alone to w->given. */
void elastica_state_loads(const struct body *b, struct body_work *w, double t, double *f);

/* Sum over nodes of what moves all of them along and across, in the frame of the tank [DIM]. */
void elastica_state_total(const struct body *b, const double *f, double *to);

/* All of *out but the damping, from w->force, given, inertia and v.  The supports give what
 * momentum needs beyond the loads, 1 . (M v' - F), where what alpha and drag take counts as
 * theirs (both hold on to the ground). */
void elastica_state_report(const struct body *b, const struct body_work *w, struct body_load *out);

#endif
