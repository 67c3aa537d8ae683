/* lattice.h -- the sites of a shape, for fill.c. */
#ifndef FILL_LATTICE_H
#define FILL_LATTICE_H

#include "shapes/shape-rows.h"
#include "shapes/shape.h"

/* Rows along each of the shape's own axes, of whose sites those inside the shape count. */
struct lattice {
    const struct shape *shape;
    struct shape_rows axis[DIM];
};

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
