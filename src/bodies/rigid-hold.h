/* rigid-hold.h -- forces of joints, motions and springs on a rigid body, and their books. */
#ifndef BODIES_RIGID_HOLD_H
#define BODIES_RIGID_HOLD_H

#include "bodies/rigid-make.h"

/* Springs: adds to sum [DIM] and moment [TURNING_SPINS] about its own axes, and to the books.
 * w is at the state, as for all of these. */
void rigid_hold_pull(const struct body *b, struct body_work *w, double *sum, double *moment,
                     struct body_load *out);

/* q'' of a body with a joint by all other forces; adds what the joint gives to the books. */
double rigid_hold_answer(const struct body *b, struct body_work *w, const double *sum,
                         const double *moment, struct body_load *out);

/* What springs store, that of a hinge with them [J, 2D: J/m]. */
double rigid_hold_elastic(const struct body *b, struct body_work *w);

#endif
