/* running.h -- running means of readings that come at times of any distance.
 *
 * Between two readings a value is a straight line, and the mean at t is that of this
 * polygon over [t - window, t], exactly, however long the steps between readings are (the
 * trapezoidal rule, with cut ends).  Before so much time has passed, the mean is that since
 * the first reading.
 *
 * A checkpoint carries all that is kept here (run/past.h); it is what fits into the longest
 * window, so that a mean depends on nothing before it. */
#ifndef MEASURE_RUNNING_H
#define MEASURE_RUNNING_H

#include "base/archive.h"

struct running;

/* Columns of readings, each with its window [columns] [s], above 0. */
int running_create(int columns, const double *window, struct running **out);
void running_free(struct running **running); /* NULL is welcome */

/* All readings that are kept.  NULL is welcome and keeps nothing. */
int running_keep(struct running *running, struct archive *a);

/* The readings [columns] of the time t, which is later than any before. */
int running_add(struct running *r, double t, const double *value);

/* The mean of a column at a time t that is not before the last reading but one; after the
 * last reading it is that at the last one.  NaN without readings. */
double running_mean(const struct running *r, int column, double t);

#endif
