/* core.h -- the core of a solid, for contacts: a smaller body, a ball around each of whose
 * points makes the solid, so that distances to it have normals that never jump.
 *
 * A core is a box about the centre, or a convex polytope.  A box without sides is a point, that
 * of a disc or sphere, one with one side the line of a rod. */
#ifndef BODIES_CORE_H
#define BODIES_CORE_H

#include "shapes/polytope.h"
#include "space/kinds.h"

struct core {
    double ball;      /* radius of the ball [m]                              */
    double half[DIM]; /* half of its sides, all 0: a point [m]               */
    const struct polytope *hull; /* NULL: it is that box; lent               */
};

bool core_point(const struct core *c);
double core_reach(const struct core *c); /* from the centre to the farthest of the solid [m] */

/* The ball around the solid: its middle [DIM], in the frame of the core, and radius [m]. */
double core_around(const struct core *c, double *middle);

/* Corners and, in space, edges; both without the ball, in the frame of the core [m]. */
int core_corners(const struct core *c);
int core_edges(const struct core *c);
void core_corner(const struct core *c, int i, double *to);
void core_edge(const struct core *c, int i, double *from, double *to);

/* The point of the core that is nearest to x, x itself when it is inside; all [DIM] [m]. */
void core_nearest(const struct core *c, const double *x, double *to);

/* Do two cores have a point in common?  The second stands at x, turned by R, both in the
 * frame of the first: separating axes, Gottschalk, Lin, Manocha, SIGGRAPH 1996, 171-180. */
bool core_overlaps(const struct core *a, const struct core *b, const double *x,
                   double (*const R)[DIM]);

#endif
