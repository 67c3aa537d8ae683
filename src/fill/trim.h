/* trim.h -- fluid with a slanted or round border makes room for walls it touches. */
#ifndef FILL_TRIM_H
#define FILL_TRIM_H

#include "fill/fill.h"
#include "fill/points.h"

/* The sites of a lattice may come as near as they like to a border that does not
 * follow it.  Takes out of points[k] of each such fluid item k (a polygon, a ball, a
 * turned box) those nearer than 0.75 dx [m] to a particle of a wall.  Fluid that
 * reaches further into a wall still has wall particles inside: overlap.h finds them. */
int trim_fluids(const struct fill_item *item, int items, double dx, struct points *points);

#endif
