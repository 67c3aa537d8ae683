/* shape-hull.h -- convex hulls (3D), for shapes and rigid bodies. */
#ifndef SHAPES_SHAPE_HULL_H
#define SHAPES_SHAPE_HULL_H

#include "base/param.h"
#include "shapes/polytope.h"

/* The hull of the points of a scene [m].  Refuses (BAD_SCENE) fewer than four, those that lie
 * in one plane, and more faces than what looks at all of them can bear.  path is the object,
 * where is "FILE:LINE".  The caller frees *out, also after a refusal. */
int shape_hull_make(const struct param_points *points, const char *path, const char *where,
                    struct polytope *out);

#endif
