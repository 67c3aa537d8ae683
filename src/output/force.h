/* force.h -- forces that a table of impulses tells. */
#ifndef OUTPUT_FORCE_H
#define OUTPUT_FORCE_H

#include "output/table.h"

/* The largest force [N, 2D: N/m] on the object whose first impulse (NAME.ix) is in this column, as
 * a mean over `window' [s], or over a row of the table where rows are further apart. */
double force_peak(const struct table *t, int column, double window);

/* A fiftieth of the time that the table spans [s]. */
double force_window(const struct table *t);

#endif
