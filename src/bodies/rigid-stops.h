/* rigid-stops.h -- sides of the domain that stop a rigid body.
 *
 * A box is a smaller one, its core, with a ball of the margin around each point: its corners
 * meet a side as balls.  A disc or sphere is one ball. */
#ifndef BODIES_RIGID_STOPS_H
#define BODIES_RIGID_STOPS_H

#include "bodies/rigid-make.h"

enum { RIGID_PLACES = 2 * DIM << DIM }; /* corners at sides, at most */

/* Fills in b->stops.  BAD_SCENE when the body reaches beyond a side at the start. */
int rigid_stops_create(struct body *b, const struct scales *s);

/* Adds forces to sum [DIM], and moments to [TURNING_SPINS] in the frame of the body; sets rates
 * of xi [places][DIM] and power [2] of pressing and rubbing on the body [W].  w is at the state. */
void rigid_stops(const struct body *b, const struct body_work *w, const double *xi, double *sum,
                 double *moment, double *xi_rate, double power[2]);

#endif
