/* tables-water.h -- the CSV tables of the water: front, pairing, probes. */
#ifndef RUN_TABLES_WATER_H
#define RUN_TABLES_WATER_H

#include "eval/observe.h"
#include "measure/running.h"
#include "run/columns.h"

struct tables_water;

/* Makes the files in DIR, or removes them; see tables_open(). */
int tables_water_open(struct tables_water **out, const struct plan *plan, const char *dir,
                      struct columns *scratch, struct running **means);

/* A row in pairing.csv; rows of profiles.csv. */
int tables_water_pairing(struct tables_water *o, struct moment *moment, double t, const double *y);
int tables_water_profile(struct tables_water *o, struct moment *moment, double t, const double *y);

/* What a row in the others has, after observe_forces() at the same (t, y), where each has own rows alone all
 * ranks together; then the row. */
void tables_water_look(struct tables_water *o, struct moment *moment, double t, const double *y);
int tables_water_row(struct tables_water *o, double t);

/* The state after an accepted step, and at the start: readings for running means. */
int tables_water_step(struct tables_water *o, struct moment *moment, double t, const double *y);

/* Lengths of the files, output/series.h. */
int tables_water_keep(struct tables_water *o, struct archive *a);

/* NULL is welcome; *status becomes the first error. */
void tables_water_close(struct tables_water **tables, int *status);

#endif
