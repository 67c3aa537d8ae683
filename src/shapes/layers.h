/* layers.h -- particles in layers that follow the outline of a wall. */
#ifndef SHAPES_LAYERS_H
#define SHAPES_LAYERS_H

#include "shapes/shape.h"
#include "shapes/points.h"
#include <math.h>

/* Does the wall follow its outline: polygon, disc or sphere, unless its key `fill`
 * says "lattice"? */
bool layers_wanted(const struct shape *s);

/* Adds points 1/2, 3/2, ... spacings inside of the outline, spaced evenly along it at
 * about dx [m]: as many layers as s->thickness has room for, or up to the middle. */
int layers_fill(const struct shape *s, double dx, struct points *to);

/* Adds points about dx [m] apart at one depth [m] inside of the outline of a polygon that
 * shape_polygon_check() has seen, with dents or without; none is nearer to it than 0.98 depths.  2D. */
int layers_row(const struct param_points *outline, double depth, double dx, struct points *to);

/* About how many points, in no time. */
double layers_estimate(const struct shape *s, double dx);

/* Is there a place x on the outline of a polygon that its points do not cover,
 * because the shape is too thin there? */
int layers_bare(const struct shape *s, double dx, const struct points *p, double *x, bool *bare);

/* Into how many steps of about dx, at most 1.05 dx, a length is divided: 1 or more. */
static inline long layers_steps(double length, double dx)
{
    const long n = lrint(length / dx);

    return length > 1.05 * n * dx ? n + 1 : n > 0 ? n : 1;
}

#endif
