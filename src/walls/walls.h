/* walls.h -- how solids meet the fluid. */
#ifndef WALLS_WALLS_H
#define WALLS_WALLS_H

#include "state/part.h"

/* Wall models of the compiled width, NULL-ended; the first is the default.  Rooms
 * without lanes ask the engine for them. */
#ifdef LANES
#define walls_table LANE_NAME(walls_table)
extern const struct part *const walls_table[];
#endif

#endif
