/* frames.h -- all particles at chosen times: files for viewers and for pictures. */
#ifndef RUN_FRAMES_H
#define RUN_FRAMES_H

#include "base/archive.h"
#include "eval/moment.h"

struct frames;

/* Files go to DIR, again: on with those that are there, after frames_keep().  dir NULL: of a rank that has
 * no files, but brings its part of the particles. */
int frames_open(struct frames **out, const struct moment *moment, const char *dir, bool again);

int frames_keep(struct frames *f, struct archive *a);

/* A moment more, see outputs_field(). */
int frames_field(struct frames *f, struct moment *moment, double t, const double *y);
int frames_snapshot(struct frames *f, struct moment *moment, double t, const double *y);

/* Closes and frees, NULL is welcome; the first error is told. */
int frames_close(struct frames **frames);

#endif
