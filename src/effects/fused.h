/* fused.h -- all laws of a table in one loop, with the gradient of the kernel.
 *
 * One law after the other waits for the division of the kernel's loop and loads each
 * row anew; in one loop the laws hide behind the division.  The numbers added, and
 * their order, are those of the laws one after the other, to the bit: a fused loop is
 * made of the same functions of a row (the headers of the laws). */
#ifndef EFFECTS_FUSED_H
#define EFFECTS_FUSED_H

#include "space/pairs.h"

/* One loop for all laws of this table, or NULL: there is none for these laws in this
 * order and with this kernel. */
#define fused_laws LANE_NAME(fused_laws)
pairs_laws *fused_laws(const struct pairs_table *table);

/* The same with rows from the list, for widths at which to form a row takes less time than
 * to store it and read it: single precision with 32 registers.  With 16 the parts of a
 * loop that does both wait for each other (a whole run takes 1.06 with four lanes). */
#ifdef SINGLE
#define fused_straight LANE_NAME(fused_straight)
pairs_straight *fused_straight(const struct pairs_table *table);
#endif

#endif
