/* ball-union.h -- what discs or balls of one radius fill together. */
#ifndef SHAPES_BALL_UNION_H
#define SHAPES_BALL_UNION_H

#include "shapes/polytope.h"

/* Volume, centre and second moments of the union of balls of that radius [m] about x [n]: what
 * lies in several counts once.  Along the last axis they are exact, across it sums over lines:
 * to some 1e-5. */
int ball_union_moments(const double (*x)[DIM], int n, double radius, struct polytope_moments *to);

/* Its surface [m^2, 2D: m], by how fast the volume grows with the radius; to some 1e-3. */
int ball_union_surface(const double (*x)[DIM], int n, double radius, double *to);

#endif
