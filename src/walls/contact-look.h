/* contact-look.h -- is a box all open to water, or all shut?  What is certain without a look at
 * its points saves most of the work of contact-room.c. */
#ifndef WALLS_CONTACT_LOOK_H
#define WALLS_CONTACT_LOOK_H

#include "state/part.h"

enum contact_look { CONTACT_OPEN, CONTACT_SHUT, CONTACT_MIXED /* or not known */ };

/* Of the box from low to high, as a particle of a solid of this group sees it, with points of
 * its own skin near it or not; bounds [objects] of shapes [m]. */
enum contact_look contact_look(const struct part_places *at, double (*const bounds)[2][DIM],
                               int group, bool skins, const double *low, const double *high);

#endif
