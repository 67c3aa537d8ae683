/* crowd.h -- tells water from spray: which fluid particles have company.
 *
 * A fluid particle belongs to the water when it has at least half as many
 * neighbours within the support as a site of the full lattice has, at least half
 * of those fluid.  Neighbours are fluid, and of solids only what lies below the
 * domain's floor: so a toe two particles thin that runs along the floor is water;
 * drops in the air, single particles that slide over the floor and the film that
 * sinking water leaves on a wall are not.  Fluid outside the domain neither
 * belongs nor counts.  Up is the last axis. */
#ifndef MEASURE_CROWD_H
#define MEASURE_CROWD_H

#include "state/particles.h"
#include <stdbool.h>

struct crowd; /* work arrays, made once for a run */

int crowd_create(const struct particles *p, struct crowd **out);
void crowd_free(struct crowd **crowd); /* NULL is welcome */

/* Sorts the fluid of this moment, and the solids that count, into cells: O(n).  The view must live as long
 * as questions are asked.  Where it has some rows of the fluid alone (view_has()), with what is near to
 * these, questions are about them. */
void crowd_update(struct crowd *c, const struct view *v);

const struct view *crowd_view(const struct crowd *c); /* of the last update */

/* Asks `see` about every fluid particle i, of the rows that the view has, within the support of x, and about some
 * that are further away. */
typedef void crowd_see(void *self, int i);
void crowd_near(const struct crowd *c, const double *x, crowd_see *see, void *self);

/* Neighbours within the support of a site of the full lattice of spacing dx. */
int crowd_full(const struct scales *s);

/* Does the fluid particle in row i belong to the water? */
bool crowd_is_water(const struct crowd *c, int i);

#endif
