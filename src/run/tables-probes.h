/* tables-probes.h -- probes.csv and profiles.csv: what the probes of a scene read. */
#ifndef RUN_TABLES_PROBES_H
#define RUN_TABLES_PROBES_H

#include "measure/crowd.h"
#include "measure/running.h"
#include "plan/facts.h"
#include "run/columns.h"

struct tables_probes;

/* Makes the files in DIR, or removes them; see tables_open(). */
int tables_probes_open(struct tables_probes **out, const struct plan *plan, const char *dir,
                       struct columns *scratch, struct running **means);

/* Has any probe a running mean?  Then it wants to see every accepted step. */
bool tables_probes_step(const struct tables_probes *o);

/* Of the crowd as it was at t: readings for running means; each point of the probes that have a
 * profile; readings for a row, all ranks together where the crowd has some rows of the fluid alone. */
int tables_probes_read(struct tables_probes *o, const struct crowd *c, double t);
void tables_probes_look(struct tables_probes *o, const struct crowd *c);

/* The row, at a time that is not before the last step but one. */
int tables_probes_row(struct tables_probes *o, double t);
int tables_probes_profile(struct tables_probes *o, const struct crowd *c, double t);

/* Lengths of the files, output/series.h. */
int tables_probes_keep(struct tables_probes *o, struct archive *a);

/* NULL is welcome; *status becomes the first error. */
void tables_probes_close(struct tables_probes **tables, int *status);

#endif
