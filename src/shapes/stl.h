/* stl.h -- corners of the triangles of an STL file, as CAD programs write them. */
#ifndef SHAPES_STL_H
#define SHAPES_STL_H

#include "base/dim.h"
#include "shapes/points.h"

/* Adds the corners of all triangles of a file, in words or in bytes, in its order and as often as
 * they are named; its numbers have no unit.  STATUS_IO: it cannot be read; STATUS_BAD_SCENE: it is
 * no STL file, ends early, or has a corner that is no place.  In 3D. */
int stl_read(const char *path, struct points *to);

#endif
