/* shape-params.c -- what a scene says of a shape. */
#include "shapes/shape.h"

#include <math.h>

#if DIM == 2
#define ROUND "disc"
const char *const shape_sides[] = { "left", "right", "bottom", "top", NULL };
const char *const shape_types[] = { "box", "polygon", "disc", "frame", NULL };
#else
#define ROUND "sphere or cylinder"
const char *const shape_sides[] = { "left", "right", "bottom", "top", "front", "back", NULL };
const char *const shape_types[] = { "box", "sphere", "cylinder", "hull", "frame", NULL };
#endif

#define PLACE(member) offsetof(struct shape, member)

static const char *const fills[] = { "auto", "layers", "lattice", NULL };

const struct param shape_params[] = {
    { .key = "type", .unit = "", .offset = PLACE(type), .type = PARAM_WORD, .words = shape_types,
      .about = "shape of the region; a frame is the shell around the domain" },
    { .key = "from", .unit = "m", .offset = PLACE(from), .type = PARAM_VECTOR,
      .fallback = NAN, .min = -SHAPE_REACH, .max = SHAPE_REACH,
      .about = "lowest corner of a box, which needs it" },
    { .key = "to", .unit = "m", .offset = PLACE(to), .type = PARAM_VECTOR,
      .fallback = NAN, .min = -SHAPE_REACH, .max = SHAPE_REACH,
      .about = "highest corner of a box, which needs it" },
    { .key = "angle", .unit = "deg", .offset = PLACE(angle), .min = -360, .max = 360,
#if DIM == 2
      .about = "turns a box about its centre, anticlockwise" },
#else
      .about = "turns a box about its axis through its centre, from x towards y for the vertical" },
#endif
    { .key = "axis", .unit = "", .offset = PLACE(axis), .type = PARAM_VECTOR,
      .fallback = NAN, .min = -SHAPE_REACH, .max = SHAPE_REACH,
      .about = "3D: direction that a box is turned about, or that a cylinder has; the vertical if not "
               "given, its length means nothing" },
    { .key = "height", .unit = "m", .offset = PLACE(height), .type = PARAM_NUMBER,
      .fallback = NAN, .min = 0, .max = SHAPE_REACH,
      .about = "3D: length of a cylinder along its axis, which it needs" },
    { .key = "points", .unit = "m", .offset = PLACE(points), .type = PARAM_POINTS,
      .fallback = NAN, .min = -SHAPE_REACH, .max = SHAPE_REACH,
#if DIM == 2
      .about = "corners of a polygon, in turn either way round; the last joins the first" },
#else
      .about = "places whose convex hull a hull is, in any order" },
#endif
    { .key = "centre", .unit = "m", .offset = PLACE(centre), .type = PARAM_VECTOR,
      .fallback = NAN, .min = -SHAPE_REACH, .max = SHAPE_REACH,
      .about = "centre of a " ROUND ", which needs it" },
    { .key = "radius", .unit = "m", .offset = PLACE(radius), .type = PARAM_NUMBER,
      .fallback = NAN, .min = 0, .max = SHAPE_REACH,
      .about = "radius of a " ROUND ", which needs it" },
    { .key = "fill", .unit = "", .offset = PLACE(fill), .type = PARAM_WORD, .words = fills,
      .about = "layers follow the outline, a lattice ends in stairs; auto: layers for walls "
               "other than boxes and frames" },
    { 0 },
};
