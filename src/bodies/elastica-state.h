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

#endif
