/* lattice.h -- the sites of a shape, for fill.c. */
#ifndef FILL_LATTICE_H
#define FILL_LATTICE_H

#include "shapes/shape.h"

/* Sites at origin + (i + 1/2) pitch, i = 0 .. n-1 along each axis (of a turned box:
 * its own axes), of which those inside the shape count. */
struct lattice {
    const struct shape *shape;
    long n[DIM];
    double origin[DIM], pitch[DIM]; /* [m] */
};

/* Is side a whole number of spacings, to 1e-6 of that number?  *n is the
 * nearest number in any case, limited to 1e15. */
bool lattice_fits(double side, double dx, long *n);

/* The lattice of a shape.  Boxes, which turn with their lattice, and frames are filled
 * evenly: the pitch is side / round(side/dx).  Balls are filled symmetrically about the
 * centre. */
struct lattice lattice_make(const struct shape *shape, double dx);

/* About how many sites, in no time, for shapes of any size. */
double lattice_estimate(const struct lattice *l);

/* Writes the sites to x [count][DIM], the first axis fastest, unless x is
 * NULL; returns the count. */
long lattice_sites(const struct lattice *l, double (*x)[DIM]);

#endif
