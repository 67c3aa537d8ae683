/* contact-reach.h -- which solids a right-hand side asks for.
 *
 * Fluid meets but a part of the solids, those by whose q_w it is pushed; these are means of
 * pi_w around them, and those of r_w around these.  Slices of the mean that take no part are
 * left out: no bit of a force depends on it. */
#ifndef WALLS_CONTACT_REACH_H
#define WALLS_CONTACT_REACH_H

#include "walls/contact-mean.h"

enum contact_stage { CONTACT_R, CONTACT_PI, CONTACT_Q, CONTACT_STAGES }; /* in this order */

/* Slices whose r, pi, q are evaluated, ascending. */
struct contact_slices {
    int n[CONTACT_STAGES];
    int *slice[CONTACT_STAGES];
};

struct contact_reach {
    const struct contact_mean *mean;
    struct contact_slices near, all; /* the last narrow() with what was added, all there are */
    unsigned char *in;               /* [slices] bits of stages of `near`                      */
    long made;                       /* times that `near` has become another                   */
};

int contact_reach_create(struct contact_reach *r, const struct contact_mean *mean);
void contact_reach_free(struct contact_reach *r);
double contact_reach_memory(const struct contact_mean *mean); /* [bytes] */

/* q of these only, met [solids] by id from the first solid. */
void contact_reach_narrow(struct contact_reach *r, const bool *met);

/* q of these, too, until the next narrow(): also [n of the mean]. */
void contact_reach_widen(struct contact_reach *r, const bool *also);

#endif
