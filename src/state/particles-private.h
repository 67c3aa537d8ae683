/* particles-private.h -- taking the memory of struct particles: for those that fill them, and
 * for moments, at which solids stand elsewhere. */
#ifndef STATE_PARTICLES_PRIVATE_H
#define STATE_PARTICLES_PRIVATE_H

#include "state/particles.h"

/* Zeroed arrays for n particles in so many objects, all in one block; *out is
 * given back with particles_free().  from[] is left to the caller. */
int particles_create(int n, int objects, const struct scales *scales, struct particles **out);

/* The same particles with places and velocities of solids, and with objects, of their own,
 * at first those of t = 0; all else is shared with `of`, which must outlive them. */
int particles_create_beside(const struct particles *of, struct particles **out);

/* Those of a moment that were never rearranged take over the rows of another's, which must outlive them or
 * rearrange no more; solids stand where they stood at t = 0. */
void particles_follow(struct particles *p, const struct particles *of);

/* Of a moment: row i of kind k becomes what row from[k][i] was (NULL: as before). */
int particles_rearrange(struct particles *p, const int *const from[KINDS]);

#endif
