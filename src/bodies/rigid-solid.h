/* rigid-solid.h -- a rigid body as contacts see it. */
#ifndef BODIES_RIGID_SOLID_H
#define BODIES_RIGID_SOLID_H

#include "bodies/rigid-make.h"

extern const struct body_solid rigid_solid;

/* Fills in how contacts meet it.  BAD_SCENE: its margin leaves nothing of it. */
int rigid_solid_make(struct body *b, const struct scales *s);

/* Adds what contacts push it by: force [DIM], moment [TURNING_SPINS] in the frame of the body,
 * and the part of the force that walls give [DIM]. */
void rigid_solid_add(const struct body_work *w, double *force, double *moment, double *by_walls);

#endif
