/* shape.h -- regions of space that a scene names, and their parameters. */
#ifndef SHAPES_SHAPE_H
#define SHAPES_SHAPE_H

#include "base/dim.h"
#include "base/param.h"
#include <stdbool.h>

#define SHAPE_REACH 1e6 /* largest coordinate a scene may use [m] */

enum shape_type { SHAPE_BOX, SHAPE_POLYGON, SHAPE_DISC, SHAPE_SPHERE, SHAPE_FRAME };

/* As a scene gives it (keys of shape_params); a frame is the shell of
 * `layers` spacings around the domain, with the corners between two closed
 * sides.  Vectors and radius that a scene did not give are NaN. */
struct shape {
    const char *type;           /* "box", "polygon", "disc" | "sphere", "frame" */
    double from[3], to[3];      /* box: lowest and highest corner   [m]       */
    struct param_points points; /* polygon: corners in turn         [m]       */
    double centre[3], radius;   /* disc, sphere                     [m]       */
    double angle;               /* box: turned anticlockwise about its centre,
                                   in 3D about the vertical through it [deg]  */
    const char *fill;           /* "auto" (or NULL), "layers", "lattice"      */
    enum shape_type kind;       /* set by shape_check                         */
    double thickness;           /* set by the caller: of a frame's shell, and of
                                   a wall in layers (0: filled to its middle) [m] */
    /* set by the caller for a frame */
    double low[3], high[3];     /* the domain                       [m]       */
    unsigned open;              /* sides left out, SHAPE_SIDE bits            */
};

/* Sides: left right bottom top in 2D, and front back in 3D; up is the last
 * coordinate in 3D too: left/right are x, front/back y, bottom/top z. */
extern const char *const shape_sides[];
unsigned shape_side(int axis, bool high); /* bit as in shape_sides            */

/* type, from, to, angle, points, centre, radius, fill */
extern const struct param shape_params[];
extern const char *const shape_types[];   /* allowed in this dimension        */

/* Sets kind; refuses what makes no sense (to below from, fewer than three
 * corners, crossing edges, radius 0, a disc in 3D, keys of another type).
 * path is the object ("wall.block"), where is "FILE:LINE". */
int shape_check(struct shape *s, const char *path, const char *where);

/* Half-open: a point on the border of two shapes is in one of them only (turned
 * boxes up to rounding). */
bool shape_contains(const struct shape *s, const double *x);
double shape_depth(const struct shape *s, const double *x); /* to its outline; 0: outside [m] */
void shape_bounds(const struct shape *s, double *low, double *high); /* [DIM] */

#endif
