/* shape-box.h -- boxes that may be turned, and how to get into their axes and back. */
#ifndef SHAPES_SHAPE_BOX_H
#define SHAPES_SHAPE_BOX_H

#include "shapes/shape.h"

/* A box has axes of its own, in which it reaches from `from` to `to`; they are
 * turned by `angle` about `axis` through its centre.  Quarter turns are exact. */
void shape_box_own(const struct shape *s, const double *x, double *own);   /* [DIM] [m] */
void shape_box_place(const struct shape *s, const double *own, double *x); /* may be one */

#endif
