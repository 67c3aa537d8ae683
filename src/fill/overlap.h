/* overlap.h -- are particles of different objects too near each other. */
#ifndef FILL_OVERLAP_H
#define FILL_OVERLAP_H

#include "fill/fill.h"

/* Refuses fluid nearer than 0.7 dx to another fluid or inside its shape, and skins nearer
 * than that to another solid or inside a wall; warns of walls in one place.  Fluids have made
 * room for solids before (carve.h).  item[k] is what object k was made from, dx [m]. */
int overlap_check(const struct particles *p, const struct fill_item *item, double dx);

#endif
