/* tables-forces.h -- forces.csv and panels.csv: what the fluid does to solids and parts of
 * them. */
#ifndef RUN_TABLES_FORCES_H
#define RUN_TABLES_FORCES_H

#include "eval/observe.h"
#include "run/columns.h"

struct tables_forces;

/* Makes the files in DIR, or removes them; see tables_open(). */
int tables_forces_open(struct tables_forces **out, const struct plan *plan, const char *dir,
                       struct columns *scratch);

/* A row in each, after observe_forces() of the same t and y. */
int tables_forces_row(struct tables_forces *o, struct moment *moment, double t, const double *y);

/* Lengths of the files, output/series.h. */
int tables_forces_keep(struct tables_forces *o, struct archive *a);

/* NULL is welcome; *status becomes the first error. */
void tables_forces_close(struct tables_forces **tables, int *status);

#endif
