/* single.h -- pairs in single precision: records, and rows of neighbours from them.
 *
 * The list stays that of double precision.  A register holds twice as many numbers, so two
 * groups of owners stand side by side: LANES here is twice the width of the list.
 *
 * A record has 32 bytes in 2D and 48 in 3D:
 *
 *   {x,y,vx,vy,rho,p2,m,irho}     {x,y,z,rho,vx,vy,vz,p2, m,irho,-,-}
 *
 * Positions are whole numbers of counts, modulo 2^32, of which SINGLE_SUPPORTS supports make
 * the whole circle: what two of them differ by is exact, wherever in the domain they are, and
 * exactly opposite from either side.  The dummy and what has left the domain are near to
 * something on that circle, so they have the mass 0: all that a law adds has it as a factor.
 *
 * This header knows no lanes but those of its struct block, which only hot rooms look into. */
#ifndef SPACE_SINGLE_H
#define SPACE_SINGLE_H

#include "space/list.h"

enum {
    SINGLE_RECORD = DIM == 2 ? 8 : 12, /* floats                             */
    SINGLE_SUPPORTS = 64
};

/* Fills record [list->listed + 1][SINGLE_RECORD], 64-byte aligned, from records in double
 * precision (space/record.h). */
void single_pack(const struct list *list, const double *from, float *record);

/* The length of a count [m]. */
double single_count(const struct list *list);

#endif
