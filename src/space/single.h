/* single.h -- pairs in single precision: records, and rows of neighbours from them.
 *
 * The list stays that of double precision.  A register holds twice as many numbers, so two
 * groups of owners stand side by side: LANES here is twice the width of the list.
 *
 * A record has 32 bytes, but in 3D 48 where masses differ:
 *
 *   2D  {x,y,vx,vy,rho,p2,m,irho}     3D  {x,y,z,rho,vx,vy,vz,p2, m,irho,-,-}
 *
 * Where all masses are the same the last four are left out, and 1/rho is formed anew.
 *
 * Positions are whole numbers of counts, modulo 2^32, of which SINGLE_SUPPORTS supports make
 * the whole circle: what two of them differ by is exact, wherever in the domain they are, and
 * exactly opposite from either side.  The dummy and what has left the domain are near to
 * something on that circle, so they have the mass 0: all that a law adds has it as a factor.
 * In the short record of 3D, which has no mass, their density has the wrong sign instead.
 */
#ifndef SPACE_SINGLE_H
#define SPACE_SINGLE_H

#include "space/list.h"

enum { SINGLE_SUPPORTS = 64 };

/* Floats of a record; mass: that of all particles [kg, 2D: kg/m], 0: they differ. */
static inline int single_floats(double mass)
{
    return DIM == 3 && mass == 0 ? 12 : 8;
}

/* The length of a count [m]. */
static inline double single_count(const struct list *list)
{
    return SINGLE_SUPPORTS * list->def.support / 4294967296.0;
}

#endif
