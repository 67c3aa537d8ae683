/* contact-beside.h -- the points of skins near a particle, of which few reach a cell around it, and
 * fewer a part of that: the others need not be asked at each of its corners. */
#ifndef WALLS_CONTACT_BESIDE_H
#define WALLS_CONTACT_BESIDE_H

#include "walls/contact-skin.h"

enum {
    CONTACT_BESIDE_CUTS = DIM == 2 ? 4 : 2, /* times that a cell is cut at most */
    CONTACT_BESIDE_MOST = 4096
};

struct contact_beside { /* large */
    const struct contact_skin *skin; /* of all solids */
    int n, point[CONTACT_BESIDE_MOST];     /* points near the particle */
    double step[CONTACT_BESIDE_MOST][DIM]; /* from it to them [m] */
    int count[CONTACT_BESIDE_CUTS + 1];    /* those of them, by number, that reach the cell */
    int reach[CONTACT_BESIDE_CUTS + 1][CONTACT_BESIDE_MOST]; /* at hand, by cuts that are left */
};

/* One more, if there is room for it. */
void contact_beside_add(struct contact_beside *b, int point, const double *step);

/* Notes which points reach the cube around `middle' [DIM] from the particle, its sides 2 half:
 * `cuts' are left of it.  Where some have been done, it is a part of that with one cut more. */
void contact_beside_keep(struct contact_beside *b, int cuts, const double *middle, double half);

/* Does one of these points fill the place `step' [DIM] from the particle? */
bool contact_beside_fills(const struct contact_beside *b, int cuts, const double *step);

#endif
