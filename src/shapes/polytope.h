/* polytope.h -- convex polytopes: in the plane convex polygons, in space convex hulls.
 *
 * Corners and faces come from Qhull (Barber, Dobkin, Huhdanpaa, ACM Trans. Math. Softw. 22
 * (1996) 469-483).  A polytope without faces is a point (1 corner) or a line (2 corners). */
#ifndef SHAPES_POLYTOPE_H
#define SHAPES_POLYTOPE_H

#include "base/dim.h"
#include <stdbool.h>

struct polytope_face { /* in the plane an edge of the polygon */
    double normal[DIM]; /* outwards, of length 1                                    */
    double offset;      /* normal . x <= offset inside [m]                          */
    int first, corners; /* its part of `loop`                                       */
};

struct polytope { /* zeroed: nothing */
    int corners, faces, edges;
    double (*x)[DIM];           /* [corners] [m]; in the plane in turn, anticlockwise      */
    struct polytope_face *face; /* [faces]                                          */
    int *loop;                  /* corners of faces in turn, anticlockwise from outside */
    int (*edge)[2];             /* [edges] corners at the ends                      */
};

struct polytope_moments {
    double volume;           /* [m^3, 2D: m^2]                                      */
    double centre[DIM];      /* of the volume [m]                                   */
    double second[DIM][DIM]; /* integral of x_i x_j about the centre [m^5, 2D: m^4] */
};

/* The hull of x [n]; without corners where all of them lie in one plane (2D: on a line). */
int polytope_hull(const double (*x)[DIM], int n, struct polytope *out);

/* A line from a to b, or the point where both are one. */
int polytope_line(const double *a, const double *b, struct polytope *out);

/* What is `depth` [m] and more below all faces of p; without corners where nothing is. */
int polytope_shrink(const struct polytope *p, double depth, struct polytope *out);

/* How deep the deepest place inside is [m], to 1e-3 of that. */
int polytope_deepest(const struct polytope *p, double *depth);

int polytope_copy(const struct polytope *p, struct polytope *out);
void polytope_free(struct polytope *p);

/* Tells it in another frame: that of axes R (columns) about the place `origin` [m]. */
void polytope_tell(struct polytope *p, const double *origin, double (*const R)[DIM]);

double polytope_depth(const struct polytope *p, const double *x); /* below 0 outside [m] */
void polytope_nearest(const struct polytope *p, const double *x, double *to); /* x inside */
double polytope_surface(const struct polytope *p);                /* [m^2, 2D: m]   */
void polytope_moments(const struct polytope *p, struct polytope_moments *to);
double polytope_reach(const struct polytope *p); /* of the farthest corner from the origin [m] */
double polytope_face_area(const struct polytope *p, const struct polytope_face *f);

#endif
