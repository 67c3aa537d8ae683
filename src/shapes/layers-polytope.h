/* layers-polytope.h -- points in layers below the faces of a convex polytope. */
#ifndef SHAPES_LAYERS_POLYTOPE_H
#define SHAPES_LAYERS_POLYTOPE_H

#include "shapes/points.h"
#include "shapes/polytope.h"

/* Adds points 1/2, 3/2, ... spacings below the faces, at about dx [m] from each other, in as many
 * layers as asked for or up to the middle; in space only.  Each layer is what polytope_shrink()
 * leaves: its corners, its edges in even steps, and rows across its faces. */
int layers_polytope(const struct polytope *p, double dx, long layers, struct points *to);

#endif
