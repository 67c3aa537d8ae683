/* tables-bodies.h -- the CSV tables of beams and of rigid bodies. */
#ifndef RUN_TABLES_BODIES_H
#define RUN_TABLES_BODIES_H

#include "eval/observe.h"
#include "run/columns.h"

struct tables_bodies;
struct archive;

int tables_bodies_open(struct tables_bodies **out, const struct plan *plan, const char *dir,
                       struct columns *scratch);
int tables_bodies_keep(struct tables_bodies *tables, struct archive *a);

/* Forces are those of the last observe_forces(). */
int tables_bodies_row(struct tables_bodies *tables, struct moment *moment, double t,
                      const double *y);

/* Frees, NULL is welcome; an error goes to *status. */
void tables_bodies_close(struct tables_bodies **tables, int *status);

#endif
