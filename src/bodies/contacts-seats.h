/* contacts-seats.h -- where many bodies may touch, pairs of them remember how far they are bent in
 * seats: blocks of places in y that pairs are given when they come near, and give back when they
 * have parted.  Which pair sits where is state, too.
 *
 * Seats change between two segments only. */
#ifndef BODIES_CONTACTS_SEATS_H
#define BODIES_CONTACTS_SEATS_H

#include "bodies/contacts-near.h"

/* Where pair i of the list remembers: its first place, -1: it has none.  Between open() and
 * close(), which set and clear what they know of y. */
void contacts_seats_open(const struct contacts *c, const struct contacts_moment *m);
void contacts_seats_close(const struct contacts *c, const struct contacts_moment *m);
long contacts_seats_at(const struct contacts *c, const struct contacts_work *w, int i);

/* Is a pair that has no seat nearly there, so that the segment is to end? */
bool contacts_seats_lack(const struct contacts *c, const struct contacts_moment *m);

/* Takes back seats of pairs that are far and bent no more, and gives seats to those near, in the
 * order of pairs; changes y.  STATUS_FAILED, with the reason in text [room]: too few are left. */
int contacts_seats_settle(const struct contacts *c, const struct contacts_moment *m, double *y,
                          char *text, size_t room);

/* Of pairs that are near at t = 0; `seat` [seats] gets the pairs that have them, from 1. */
int contacts_seats_first(const struct contacts *c, double *seat);

/* Takes seats without a bend out of y, puts others in the order of pairs, and closes the gap: what
 * is left does not tell how many seats there were.  Returns the numbers that are left. */
long contacts_seats_tidy(const struct contacts *c, const struct layout *l, double *y);

#endif
