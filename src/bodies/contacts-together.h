/* contacts-together.h -- two solids that press at several places at once: what mass each of them meets.
 *
 * A push at one place alone meets m_c, but where a box lies on its face, all corners push it at
 * once, and what one corner accelerates is what all of them do:
 *   1/m_i = sum_j E_j W_ij/E_i,   E = share k d^(3/2)                       (RT9)
 * with W_ij what a unit push at place j accelerates place i along its normal.  With that mass the damping of (RT2)
 * gives a face the restitution that a corner has, and a place with a share of the law, too. */
#ifndef BODIES_CONTACTS_TOGETHER_H
#define BODIES_CONTACTS_TOGETHER_H

#include "bodies/contacts-place.h"

struct contacts_spots { /* places of a pair that touch; lent by who asks */
    struct contacts_spot *spot; /* [n] */
    int *which, *place;         /* [n] which of both is the guest there; number among places */
    int n;
};

/* Sets `carried` of all of them; guest as of contacts-pair.c, one way round and the other. */
void contacts_together(const struct contacts_guest guest[2], struct contacts_spots *of);

#endif
