/* polygon-parts.h -- a polygon with dents as convex ones. */
#ifndef SHAPES_POLYGON_PARTS_H
#define SHAPES_POLYGON_PARTS_H

#include "base/param.h"
#include "shapes/polytope.h"

/* Cuts a polygon that shape_polygon_check() has seen into convex parts, at most four times the
 * least number: Hertel, Mehlhorn, Foundations of Computation Theory 1983, 207-218.  part
 * [points->n] is filled; the caller frees the first *parts of them. */
int polygon_parts(const struct param_points *points, struct polytope *part, int *parts);

#endif
