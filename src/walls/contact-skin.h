/* contact-skin.h -- the room that points of a skin fill, at rest.
 *
 * A skin is known by its points alone: each fills a cell, a box along the line to its nearest
 * neighbour, as long as that is far, and across it as wide as the layers are apart, dx where
 * there is one layer only. */
#ifndef WALLS_CONTACT_SKIN_H
#define WALLS_CONTACT_SKIN_H

#include "state/part.h"
#include "walls/contact-cells.h"

struct contact_skin {
    double axis[DIM][DIM]; /* unit vectors          */
    double half[DIM];      /* half its sides [m]    */
    bool alone;            /* the only layer: water on either side is before it */
};

/* Of solid i, counted from the first; cells hold all solids. */
void contact_skin_fit(const struct part_places *at, const struct contact_cells *cells, int i,
                      struct contact_skin *to);

/* Is the place `step` [DIM] from its point in that cell? */
bool contact_skin_fills(const struct contact_skin *s, const double *step);
/* May that cell have a place in common with the cube around `step', its sides 2 half along the
 * axes?  False is certain. */
bool contact_skin_reaches(const struct contact_skin *s, const double *step, double half);

#endif
