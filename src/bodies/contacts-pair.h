/* contacts-pair.h -- two solids that may touch: corners of each at the other, and edges of
 * both at each other, each such place with a bend xi of its own. */
#ifndef BODIES_CONTACTS_PAIR_H
#define BODIES_CONTACTS_PAIR_H

#include "bodies/bodies.h"
#include "bodies/contacts-rules.h"
#include "bodies/contacts-together.h"
#include "bodies/solid.h"
#include "bodies/touch.h"

struct contacts_pair {
    const struct solid *a, *b; /* b may be a wall                                  */
    int first, second;         /* which these are                                  */
    struct touch_law law;
    double depth, rate;        /* d_U [m]; the fastest [1/s]                       */
    double slow, always;       /* of the softest law; without a contact, too [1/s] */
    double share;              /* of a corner, where corners of both meet [1]      */
    long from;                 /* its first place, -1: in a seat                   */
    int places;
};

/* Where both are. */
struct contacts_stand {
    const struct solid_place *a, *b;
    double apart[DIM];         /* from b to a, by the nearest image, in space [m]  */
};

/* All but first, second and from.  alone: no water bounds the steps, so that they could be as long
 * as a fall through the other. */
void contacts_pair_make(struct contacts_pair *p, const struct solid *a, const struct solid *b,
                        const struct contacts_rub *rub, bool alone);

/* BAD_SCENE: by the law of materials they get deeper into each other than contacts can bear. */
int contacts_pair_check(const struct contacts_pair *p);

/* The middle of the ball around a solid, in space [m]. */
void contacts_pair_middle(const struct solid *s, const struct solid_place *at, double *to);

/* Are they more than `gap` [m] apart, by the balls around them? */
bool contacts_pair_far(const struct contacts_pair *p, const struct contacts_stand *s, double gap);

/* How far apart they are [m], below 0 where they overlap; HUGE_VAL: more than `most`. */
double contacts_pair_gap(const struct contacts_pair *p, const struct contacts_stand *s, double most);

/* Sets rates of xi [places][DIM], which were those of touch_forget() before, and adds to what pushes both, b's with the same force and
 * the other sign, and to what pressing and rubbing give to bodies, power [2] [W]; *deepest [m] grows
 * to the deepest overlap; room: as many spots as it has places.  STATUS_FAILED: a corner is inside the other's core. */
int contacts_pair_meet(const struct contacts_pair *p, const struct contacts_stand *s,
                       const double *xi, double *xi_rate, struct contacts_spots *room,
                       struct body_push *on_a, struct body_push *on_b, double power[2],
                       double *deepest);

/* The fastest rate that a step from here meets: that of the law, or that of coming close. */
double contacts_pair_rate(const struct contacts_pair *p, const struct contacts_stand *s);

/* How deep they are in each other [m], not below 0; HUGE_VAL: their cores are. */
double contacts_pair_depth(const struct contacts_pair *p, const struct contacts_stand *s);

#endif
