/* fit.h -- does the spacing fit the sides of boxes, and which one would. */
#ifndef FILL_FIT_H
#define FILL_FIT_H

#include "fill/fill.h"

/* Refuses a fluid box, or a domain with a frame around it, whose sides are no
 * whole number of spacings; says which spacings near dx [m] fit all of them. */
int fit_check(const struct fill_item *item, int items, double dx);

#endif
