/* rigid-axes.h -- axes of inertia. */
#ifndef BODIES_RIGID_AXES_H
#define BODIES_RIGID_AXES_H

#include "bodies/turning.h"
#include "shapes/polytope.h"

/* Principal moments by mass, gyration [TURNING_SPINS] [m^2], of an even body; the axes as columns
 * of R, and in space as a quaternion frame [4].  Where the axes of `m` are principal ones already
 * they stay, and frame is (1, 0, 0, 0); in the plane they always do. */
int rigid_axes(const struct polytope_moments *m, double *gyration, double *frame,
               double R[DIM][DIM]);

#endif
