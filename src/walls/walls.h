/* walls.h -- how solids meet the fluid, and how walls move. */
#ifndef WALLS_WALLS_H
#define WALLS_WALLS_H

#include "state/part.h"

/* Wall models of the compiled width, NULL-ended; the first is the default.  Rooms
 * without lanes ask the engine for them. */
#ifdef LANES
#define walls_table LANE_NAME(walls_table)
extern const struct part *const walls_table[];
#endif

/* Prescribed motion of a wall: x = x0 + velocity t + amplitude sin(2 pi f t). */
struct walls_motion {
    double velocity[3];  /* [m/s]                       */
    double amplitude[3]; /* [m]                         */
    double frequency;    /* f [Hz]                      */
};
extern const struct param walls_motion_params[];

/* Does it move at all? */
bool walls_motion_any(const struct walls_motion *m);

/* Displacement [m], velocity [m/s] and acceleration [m/s^2] at time t, each [DIM]. */
void walls_motion_at(const struct walls_motion *m, double t, double *shift, double *u, double *a);

#endif
