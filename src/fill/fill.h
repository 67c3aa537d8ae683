/* fill.h -- turns the shapes of a scene into particles. */
#ifndef FILL_FILL_H
#define FILL_FILL_H

#include "shapes/shape.h"
#include "state/particles.h"

/* One thing to be filled.  Points that are given (skin) are taken as they are;
 * a shape has passed shape_check(). */
struct fill_item {
    char name[64];
    const char *group;          /* "fluid", "wall", "beam": for messages      */
    const char *where;          /* "FILE:LINE" for messages                   */
    enum kind kind;
    const struct shape *shape;  /* shape to fill, or NULL                     */
    int points;                 /* given points, when shape is NULL           */
    const double (*point)[DIM]; /* [points][DIM] [m]                          */
    bool (*holds)(const void *body, const double *x); /* is x inside of what has these
                                   points?  NULL: it is no wider than they are */
    const void *body;
};

/* All particles of all items, sorted by kind; within a kind in the order of
 * the items, within an item along the lattice, the first axis fastest, or layer by
 * layer from the outline inwards.  Object
 * k of *out is the k-th item in that order.  Mass rho0 dx^D for all, x
 * and x0 are the places, u and dye are 0.  *out belongs to the caller.
 *
 * Lattice sites are at low + (i + 1/2) dx, low being the lowest corner of
 *   a box      its own; the sites are spread evenly over each side, so a solid
 *              box may have any size from half a spacing on, and a turned one
 *              turns with its lattice;
 *   a polygon  the box around it;
 *   a disc     a lattice symmetric about the centre;
 *   a frame    the domain's: ..., -3/2 dx, -1/2 dx outside of it.
 * Walls that are polygons, discs or spheres stand in layers instead (layers.h) unless
 * their `fill` says "lattice".  Fluid whose own border is slanted or round loses the
 * sites that stand too near to a wall which it touches (trim.h).
 *
 * Refuses (BAD_SCENE): a fluid box, or a domain with a frame, whose sides are
 * no whole number of spacings (to 1e-6; says which spacings fit), a shape with
 * no site in it, fluid in layers, fluid that loses more than half of its sites to solids,
 * fluid nearer than 0.7 dx to a particle of another fluid or inside its shape, a skin nearer
 * than 0.7 dx to a particle of another solid or inside a wall (walls may touch
 * walls; those that fill the same space get a warning),
 * fluid outside the domain, more particles than memory has room for (so many
 * bytes for each of the fluid, of solids) or than INT_MAX/4. */
int fill_particles(const struct fill_item *item, int items, const struct scales *scales,
                   double bytes_fluid, double bytes_solid, struct particles **out);

/* How many particles there would be, about, by shapes alone. */
struct fill_counts {
    double *of;          /* [items], the caller's    */
    double fluid, solid; /* all of them              */
    bool known;          /* these are filled in      */
};

/* Counts without placing one, into zeroed counts.  Refuses what fill_particles() refuses before
 * it places any; what memory has no room for is counted and refused. */
int fill_count(const struct fill_item *item, int items, const struct scales *scales,
               double bytes_fluid, double bytes_solid, struct fill_counts *to);

#endif
