/* particles-private.h -- taking the memory of struct particles: for fill.c. */
#ifndef STATE_PARTICLES_PRIVATE_H
#define STATE_PARTICLES_PRIVATE_H

#include "state/particles.h"

/* Zeroed arrays for n particles in so many objects, all in one block; *out is
 * given back with particles_free().  from[] is left to the caller. */
int particles_create(int n, int objects, const struct scales *scales, struct particles **out);

#endif
