/* contacts-place.h -- where a corner or an edge of one solid touches another, its partner, in
 * whose frame all is told; and what pushes both there. */
#ifndef BODIES_CONTACTS_PLACE_H
#define BODIES_CONTACTS_PLACE_H

#include "bodies/bodies.h"
#include "bodies/solid.h"
#include "bodies/touch.h"

struct contacts_guest { /* a solid in the frame of its partner                            */
    const struct solid *guest, *partner;
    const struct solid_place *partner_at;
    double touching;            /* distance of cores at which they touch [m]       */
    struct solid_place in;      /* the guest in that frame; v less that of the partner */
    double base[DIM];           /* velocity of the partner's centre [m/s]          */
};

struct contacts_spot {
    double depth;               /* of the overlap; <= 0: none [m]                  */
    double point[DIM];          /* where they touch [m]                            */
    double normal[DIM];         /* out of the partner                              */
    double share;               /* of the law's force [1]                          */
    double carried;             /* of the mass that a push meets here alone: what damping goes by [1] */
};

/* apart [DIM]: from the partner's centre to the guest's, in space [m]. */
void contacts_guest_make(struct contacts_guest *g, const struct solid *guest,
                         const struct solid_place *guest_at, const struct solid *partner,
                         const struct solid_place *partner_at, const double *apart);

/* A place of the guest, own [DIM] in its frame, in that of the partner. */
void contacts_guest_place(const struct contacts_guest *g, const double *own, double *to);

/* Adds a force on that place, in the guest's frame, and the opposite one to the pushes on both, and
 * what they give to bodies to power [W]. */
void contacts_guest_press(const struct contacts_guest *g, const double *own, const double *force,
                          struct body_push *on_guest, struct body_push *on_partner,
                          double *power);

/* Corner i of the guest at the partner's core.  STATUS_FAILED: it is inside of that. */
int contacts_corner(const struct contacts_guest *g, int i, struct contacts_spot *to);

/* Edge i of the guest at edge k of the partner, where they cross between their ends:
 *   share = sin^2(e, f) S(s) S(t),  S: smoothstep of the way to the nearer end by 2 balls (CT2) */
void contacts_edges(const struct contacts_guest *g, int i, int k, struct contacts_spot *to);

double contacts_place_speed(const double *v); /* by its components, [DIM] */

/* Moments of a push of 1 N along the normal on the guest, and on the partner as if it were that, each in its own
 * frame [TURNING_SPINS] [m]. */
void contacts_spot_levers(const struct contacts_guest *g, const struct contacts_spot *s,
                          double *guest, double *partner);

/* How fast the overlap grows there [m/s]. */
double contacts_spot_closing(const struct contacts_guest *g, const struct contacts_spot *s);

/* Sets the rate of xi; adds to the pushes on both, and what they give to bodies to power [2]. */
void contacts_spot_push(const struct contacts_guest *g, const struct touch_law *law,
                        const struct contacts_spot *s, const double *xi, double *xi_rate,
                        struct body_push *on_guest, struct body_push *on_partner,
                        double power[2]);

#endif
