/* contact-reach.h -- which solids a right-hand side asks for.
 *
 * Fluid meets but a part of the solids, those by whose q_w it is pushed; these are means of
 * pi_w around them, and those of r_w around these.  Slices of the mean that take no part are
 * left out: no bit of a force depends on it.  One of many ranks likewise asks for its own. */
#ifndef WALLS_CONTACT_REACH_H
#define WALLS_CONTACT_REACH_H

#include "walls/contact-mean.h"

enum contact_stage { CONTACT_R, CONTACT_PI, CONTACT_Q, CONTACT_STAGES }; /* in this order */

/* Slices whose r, pi, q are evaluated, ascending. */
struct contact_slices {
    int n[CONTACT_STAGES];
    int *slice[CONTACT_STAGES];
};

/* Those that some solids need. */
struct contact_chosen {
    struct contact_slices slices;
    unsigned char *in; /* [slices] bits of their stages */
};

struct contact_reach {
    const struct contact_mean *mean;
    struct contact_chosen met, own;  /* of the last choose(), with what was added to `met` */
    struct contact_slices all;       /* there are */
    long made;                       /* times that `met` has become another */
};

int contact_reach_create(struct contact_reach *r, const struct contact_mean *mean);
void contact_reach_free(struct contact_reach *r);
double contact_reach_memory(const struct contact_mean *mean); /* [bytes] */

/* q of these only, solid [solids] by id from the first one, where `which` are asked for. */
void contact_reach_choose(struct contact_reach *r, enum part_solids which, const bool *solid);

/* What is to be evaluated then. */
const struct contact_slices *contact_reach_of(const struct contact_reach *r, enum part_solids which);

/* q of these, too, of those that are met, until the next choose(): also [n of the mean]. */
void contact_reach_widen(struct contact_reach *r, const bool *also);

#endif
