/* contacts-near.h -- where solids are at a moment, and which pairs of them are near enough to look
 * at: each body by the balls around it in a grid, walls with all bodies.
 *
 * The grid is made anew at each look, from places alone, so no pair is missed and f stays a
 * function of (t, y). */
#ifndef BODIES_CONTACTS_NEAR_H
#define BODIES_CONTACTS_NEAR_H

#include "bodies/contacts-list.h"

/* What looks are made in. */
struct contacts_work {
    long (*cell)[DIM];  /* [movers] in which cell each is                        */
    int *first, buckets; /* [buckets] a body of each, -1: none; a power of two   */
    int *next;          /* [movers] the one after it, -1: none                   */
    int *found;         /* [solids] partners of one body                         */
    int near, *pair;    /* [pairs] of them those found last, ascending           */
    int *seat_of;       /* [pairs] -1: none                                      */
    struct contacts_spots spots; /* of one pair: room for the places of any       */
    double *bent;       /* [2][block][DIM] of a pair without a seat              */
};

int contacts_near_create(const struct contacts *c, struct contacts_work **out);
void contacts_near_free(struct contacts_work **work);

/* Sets where bodies are; before all else. */
void contacts_near_place(const struct contacts *c, const struct contacts_moment *m);

/* Where solid i is; of a wall or side in `room`. */
const struct solid_place *contacts_near_of(const struct contacts *c,
                                           const struct contacts_moment *m, int i,
                                           struct solid_place *room);

/* Sets near and pair of m->work: all pairs whose balls are less than `gap` apart [m] are among
 * them, and few others. */
void contacts_near_find(const struct contacts *c, const struct contacts_moment *m, double gap);

#endif
