/* shape.h -- regions of space that a scene names, and their parameters. */
#ifndef SHAPES_SHAPE_H
#define SHAPES_SHAPE_H

#include "base/dim.h"
#include "base/param.h"
#include <stdbool.h>

#define SHAPE_REACH 1e6 /* largest coordinate a scene may use [m] */

enum shape_type { SHAPE_BOX, SHAPE_POLYGON, SHAPE_DISC, SHAPE_SPHERE, SHAPE_FRAME, SHAPE_CYLINDER,
                  SHAPE_HULL };

struct polytope; /* shapes/polytope.h */

/* As a scene gives it (keys of shape_params); a frame is the shell of
 * `layers` spacings around the domain, with the corners between two closed
 * sides.  Vectors and radius that a scene did not give are NaN. */
struct shape {
    const char *type;           /* "box", "polygon", "disc" | "sphere", "cylinder", "hull", "frame" */
    double from[3], to[3];      /* box: lowest and highest corner   [m]       */
    struct param_points points; /* polygon: corners in turn; hull: it is theirs [m] */
    double centre[3], radius;   /* disc, sphere, cylinder           [m]       */
    double height;              /* cylinder: length along its axis  [m]       */
    double axis[3];             /* 3D: direction that a box is turned about, or
                                   of a cylinder; 0 or NaN: the vertical      */
    double angle;               /* box: turned about its centre, anticlockwise
                                   for who looks against the axis   [deg]     */
    const char *fill;           /* "auto" (or NULL), "layers", "lattice"      */
    enum shape_type kind;       /* set by shape_check                         */
    struct polytope *hull;      /* of a hull, likewise; shape_free() frees it  */
    double thickness;           /* set by the caller: of a frame's shell, and of
                                   a wall in layers (0: filled to its middle) [m] */
    /* set by the caller for a frame */
    double low[3], high[3];     /* the domain                       [m]       */
    unsigned open;              /* sides left out, SHAPE_SIDE bits            */
    double sunk;                /* how far below an open top its sides end  [m] */
};

/* Sides: left right bottom top in 2D, and front back in 3D; up is the last
 * coordinate in 3D too: left/right are x, front/back y, bottom/top z. */
extern const char *const shape_sides[];
unsigned shape_side(int axis, bool high); /* bit as in shape_sides            */

/* type, from, to, angle, axis, points, centre, radius, height, fill */
extern const struct param shape_params[];
extern const char *const shape_types[];   /* allowed in this dimension        */

/* Sets kind; refuses what makes no sense (to below from, fewer than three
 * corners, crossing edges, radius 0, a disc in 3D, keys of another type).
 * path is the object ("wall.block"), where is "FILE:LINE". */
int shape_check(struct shape *s, const char *path, const char *where);
void shape_free(struct shape *s); /* what shape_check() took, also after a refusal */

/* Half-open: a point on the border of two shapes is in one of them only (turned
 * boxes up to rounding). */
bool shape_contains(const struct shape *s, const double *x);
double shape_depth(const struct shape *s, const double *x); /* to its outline; 0: outside [m] */
void shape_bounds(const struct shape *s, double *low, double *high); /* [DIM] */
bool shape_goes_round(const struct shape *s); /* the domain: is it a frame?     */

/* Is it thinner than `width` [m] between flat faces across its own axis d? */
bool shape_is_thin(const struct shape *s, int d, double width);
void shape_own(const struct shape *s, const double *x, double *own); /* x in its own axes */

#endif
