/* turning.h -- how a rigid body is turned, and how that changes.
 *
 * In the plane an angle and its rate; in space a quaternion q and the spin Omega [rad/s] in
 * the frame of the body, whose axes are those of its inertia.  Only the direction of q means
 * something: no result depends on its length. */
#ifndef BODIES_TURNING_H
#define BODIES_TURNING_H

#include "space/kinds.h"

#include <stdbool.h>

enum {
    TURNING_NUMBERS = DIM == 2 ? 1 : 4, /* of q: an angle [rad], or w, x, y, z */
    TURNING_SPINS = DIM == 2 ? 1 : 3,   /* of a spin or a moment               */
};

/* q of a body turned by angle [TURNING_SPINS] [rad]: in space about its direction, by its
 * length. */
void turning_about(const double *angle, double *q);

/* (RB1): what takes vectors of the body into space. */
void turning_matrix(const double *q, double to[DIM][DIM]);

/* (RB2): q' of this spin. */
void turning_rate(const double *q, const double *spin, double *to);

/* Velocity by the spin of a place `arm` from the centre, all in one frame. */
void turning_velocity(const double *spin, const double *arm, double *to);

/* Adds the moment of a force on that place to `to` [TURNING_SPINS]: the transpose. */
void turning_moment(const double *arm, const double *force, double *to);

/* -Omega x I Omega of (RB3), with the principal moments I [TURNING_SPINS]; 0 in the plane. */
void turning_gyration(const double *inertia, const double *spin, double *to);

#if DIM == 3
/* The turn q after the turn `first`: q first. */
void turning_product(const double *q, const double *first, double *to);

/* Is q a turn?  All numbers 0 are none. */
bool turning_known(const double *q);
#endif

#endif
