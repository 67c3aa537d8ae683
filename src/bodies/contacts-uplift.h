/* contacts-uplift.h -- the pressure of water in gaps too narrow for its particles: under a box
 * that lies on the floor, and between boxes.
 *
 * Engineers of dams call it uplift.  In a gap of even width the pressure of a thin film obeys
 * Laplace's equation (Reynolds 1886), so what it is at the edges decides it. */
#ifndef BODIES_CONTACTS_UPLIFT_H
#define BODIES_CONTACTS_UPLIFT_H

#include "bodies/contacts-place.h"
#include "bodies/contacts.h"
#include "state/scales.h"

enum { UPLIFT_FACES = 2 * DIM }; /* of a box: two a direction, the lower one first */

struct contacts_uplift;

struct uplift_faces { /* of a box, at a moment                                    */
    double edge[UPLIFT_FACES][UPLIFT_FACES]; /* of a face at another, where water has its
                                                pressure [Pa]                     */
    double closed[UPLIFT_FACES];             /* shares that lie at other solids [1] */
};

/* Of a box with a skin that stands as `b` says at the start; lends the solid. */
int contacts_uplift_create(const struct solid *solid, const struct contacts_body *b,
                           const struct scales *scales, struct contacts_uplift **out);
void contacts_uplift_free(struct contacts_uplift **u);

/* Pressures at edges by the forces on its skin, force [points][DIM] [N]; no face is closed. */
void contacts_uplift_read(const struct contacts_uplift *u, const struct solid_place *at,
                          const double (*force)[DIM], struct uplift_faces *to);

/* Adds to the shares that are closed what this partner closes. */
void contacts_uplift_close(const struct contacts_uplift *u, const struct contacts_guest *g,
                           struct uplift_faces *to);

/* Adds (UP2) to the pushes on both, and what it gives to bodies to power [W]; all partners
 * have closed what they close. */
void contacts_uplift_push(const struct contacts_uplift *u, const struct contacts_guest *g,
                          const struct uplift_faces *faces, struct body_push *on_guest,
                          struct body_push *on_partner, double *power);

#endif
