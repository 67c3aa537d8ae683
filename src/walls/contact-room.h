/* contact-room.h -- how much of the kernel around a particle of a solid stands in room that
 * water can fill:
 *
 *   s_w = dx^D sum_c phi_c W(x_c - x_w)                 over cells c of a lattice through x_w
 *   n_w = dx^D sum_c phi_c W(x_c - x_w) e_c,  phi_c: share of the cell that is open
 *
 * with e_c the mean direction from the particle to what is open there.  Open is what lies in
 * the domain or in another solid, which may leave (contact-others.h), but not in the solid
 * itself or in one that never moves against it.  Where faces lie between sites s_w is the sum over open
 * sites, which is what water on a lattice gives; where they are slanted or round it changes
 * with them smoothly.  Cells that a face cuts are cut, 4 times in the plane and twice in
 * space, to measure phi.
 *
 * A solid that is one layer thick (a skin of one layer, a box) has water before it on both
 * sides, and its density feels the sum: there s_w is the larger of what is open on one side and on the
 * other, so that it holds water on one side.  When the other becomes wet, both stand farther
 * from it. */
#ifndef WALLS_CONTACT_ROOM_H
#define WALLS_CONTACT_ROOM_H

#include "walls/contact-cells.h"
#include "walls/contact-skin.h"

struct contact_room {
    const struct part_places *at;
    const struct contact_cells *cells; /* of all solids */
    struct contact_skin *skin;         /* [solids] of points of skins */
    double (*bounds)[2][DIM];          /* [objects] of shapes [m]  */
    int side;                          /* cells along an axis that the kernel may see */
    double *weight;                    /* [side^D] of these cells, 0: not seen */
};

struct contact_share {
    double open;        /* s_w, from 0 to about 1 */
    double normal[DIM]; /* n_w                    */
    bool alone;         /* its solid is one layer thick here */
};

int contact_room_create(struct contact_room *r, const struct part_places *at,
                        const struct contact_cells *solids);
void contact_room_free(struct contact_room *r);

/* dx^D */
double contact_room_cell(const struct part_places *at);
/* dx^D W(r), cut at half a spacing where W grows without bound; cell = dx^D. */
double contact_room_kernel(const struct part_places *at, double cell, double r);

/* Of solid i, counted from the first. */
struct contact_share contact_room_share(const struct contact_room *r, int i);

#endif
