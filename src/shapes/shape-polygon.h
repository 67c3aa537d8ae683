/* shape-polygon.h -- flat polygons, for shape.c and for counting sites. */
#ifndef SHAPES_SHAPE_POLYGON_H
#define SHAPES_SHAPE_POLYGON_H

#include "base/param.h"
#include <stdbool.h>

/* Refuses fewer than three corners, a corner given twice in a row, edges that
 * cross or touch, no area.  Corners may go round either way. */
int shape_polygon_check(const struct param_points *points, const char *path,
                        const char *where);

bool shape_polygon_contains(const struct param_points *points, const double *x);
void shape_polygon_bounds(const struct param_points *points, double *low, double *high);
double shape_polygon_distance(const struct param_points *points, const double *x); /* to the
                                                                  outline, never negative [m] */
double shape_polygon_turning(const struct param_points *points); /* 1: corners go round
                                                                  anticlockwise, -1: clockwise */
double shape_polygon_length(const struct param_points *points); /* of the outline [m] */
double shape_polygon_area(const struct param_points *points); /* [m^2], never negative */

#endif
