/* contacts.h -- what bodies do to each other: a pass over all of them, between move(), which
 * places their skins, and load(), which takes the forces on these.
 *
 * Forces act on the points of skins, and these are there in a tank only: bodies in a scene
 * without fluid do not meet.  What contacts remember is state, in rows of y of their own. */
#ifndef BODIES_CONTACTS_H
#define BODIES_CONTACTS_H

#include "bodies/bodies.h"

enum { CONTACTS_COLUMNS = 4 }; /* of the book, at most                             */

struct contacts; /* what they know of the scene; const once their rows are known   */

struct contacts_body { /* where a body stands, and what pushes it                       */
    int points;               /* of its skin; without one 0                        */
    const double (*x)[DIM];   /* [points] [m]                                      */
    const double (*u)[DIM];   /* [points] [m/s]                                    */
    double (*force)[DIM];     /* [points] by the fluid so far [N], to be added to  */
};

struct body_contacts {
    const char *about;
    const char *const *column; /* names of works of the book, NULL-ended           */

    int (*create)(const struct scales *s, int bodies, struct contacts **out);
    void (*free)(struct contacts **contacts); /* a pointer to NULL is welcome       */

    /* Adds their rows, of class LAYOUT_OTHER, after those of bodies; y at t = 0.  NULL: they
     * have none. */
    int (*rows)(struct contacts *c, struct layout *l);
    void (*start)(const struct contacts *c, const struct layout *l, double *y);

    /* Adds forces to bodies, equal and opposite ones, sets the rates of its rows of ydot, and
     * says what it gives to bodies, power [columns] [W].  That is booked with velocities of y
     * by all methods: by those that step halves (struct ask, `ahead`) to the first order. */
    void (*meet)(const struct contacts *c, const struct layout *l, double t, const double *y,
                 int bodies, const struct contacts_body *body, double *ydot, double *power);

    /* The fastest rate of meet(); `where` is a body.  NULL: they never limit a step. */
    void (*limit)(const struct contacts *c, struct limit *out);
};

/* Of the scenes of this program; NULL: bodies do not meet. */
extern const struct body_contacts *const bodies_contacts;

#endif
