/* looks-file.h -- surfaces of rigid bodies as plain CSV, for gnuplot and spreadsheets. */
#ifndef OUTPUT_LOOKS_FILE_H
#define OUTPUT_LOOKS_FILE_H

#include "output/aside.h"
#include "output/cloud.h"

/* All corners of a face in turn and the first once more, then a blank line, and two behind each
 * body:
 *
 *     x,y,body                      in the plane
 *     x,y,z,nx,ny,nz,body           in space, with the normal of the face, outwards */
int looks_file_write(const char *path, int dim, double t, const struct cloud_looks *looks);

/* All that a picture with depth shows, in space: points on the faces and along the sharp edges, no
 * farther apart than `step` [m], then particles of fluid and walls, with velocities for normals:
 *
 *     x,y,z,nx,ny,nz,what,body      what 0: on a face, 1: on an edge, 2: fluid, 3: wall
 *
 * Opened with what is seen of bodies; then particles are added, part by part, and it is closed. */
int looks_file_open_points(struct aside *a, const char *path, double step,
                           const struct cloud_frame *frame);
void looks_file_add_points(FILE *to, const struct cloud_frame *part);

/* Where the plane y = `at` [m] cuts the bodies, in space: outlines as above, x,y,z,body. */
int looks_file_write_cut(const char *path, double t, double at, const struct cloud_looks *looks);

#endif
