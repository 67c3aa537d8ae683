/* rigid-skin.h -- where the points that the water meets stand in a rigid body.
 *
 * Layers below its surface, the first half a spacing deep.  A box is filled by rows that its
 * sides are whole numbers of; a disc or sphere has rings or shells. */
#ifndef BODIES_RIGID_SKIN_H
#define BODIES_RIGID_SKIN_H

#include "bodies/rigid-def.h"

/* The number of points; arm [points][DIM] from the centre, in the frame of the body [m], NULL:
 * not asked. */
int rigid_skin(const struct rigid_def *d, double spacing, int layers, double (*arm)[DIM]);

/* Is x inside of the body as it stands at the start? */
bool rigid_skin_holds(const struct rigid_def *d, const double *x);

#endif
