/* surface.h -- the surface of a solid, for pictures: in the plane closed outlines, in space flat
 * faces that close.
 *
 *     struct surface s = { 0 };
 *     TRY(surface_corner(&s, x));            its number is s.corners - 1
 *     TRY(surface_face(&s, ids, n));         anticlockwise, in space from outside
 *     surface_free(&s); */
#ifndef SHAPES_SURFACE_H
#define SHAPES_SURFACE_H

#include "base/dim.h"
#include "shapes/polytope.h"

struct surface { /* zeroed: nothing */
    int corners, faces, ends; /* ends: numbers in loop                                  */
    int corner_room, face_room, loop_room;
    double (*x)[DIM];         /* [corners] [m]                                          */
    int *first;               /* [faces + 1]: face i is loop[first[i]] up to first[i+1] */
    int *loop;                /* [ends] corners of the faces in turn                    */
};

/* Each may get no memory, STATUS_FAILED. */
int surface_corner(struct surface *s, const double *x);
int surface_face(struct surface *s, const int *corner, int corners);

/* All faces of a convex polytope, or a box of these half sides about the origin. */
int surface_polytope(struct surface *s, const struct polytope *p);
int surface_box(struct surface *s, const double *half);

/* What it encloses, by the divergence theorem: integral of n . x over it, by DIM [m^3, 2D: m^2]. */
double surface_volume(const struct surface *s);

/* Of all faces, by Newell's formula; 0 in the plane, where there are outlines only [m^2]. */
double surface_area(const struct surface *s);

void surface_free(struct surface *s);

#endif
