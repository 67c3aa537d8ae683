/* shape-rows.h -- rows of sites along an axis of a shape. */
#ifndef SHAPES_SHAPE_ROWS_H
#define SHAPES_SHAPE_ROWS_H

#include <stdbool.h>

/* Sites at origin + (i + 1/2) pitch, i = 0 .. n-1. */
struct shape_rows {
    long n;
    double origin, pitch; /* [m] */
};

/* Is side a whole number of spacings, to 1e-6 of that number?  *n is the
 * nearest number in any case, limited to 1e15. */
bool shape_rows_fit(double side, double dx, long *n);

/* As many sites as fit, spread over the whole side. */
struct shape_rows shape_rows_spread(double low, double high, double dx);

/* From `low` on at the spacing itself, unless that fits the side. */
struct shape_rows shape_rows_cover(double low, double high, double dx);

/* As many as fit, symmetric about the middle, at the spacing itself. */
struct shape_rows shape_rows_centre(double low, double high, double middle, double dx);

#endif
