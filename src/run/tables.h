/* tables.h -- the CSV tables of a run (SYSTEM: book, front, pairing, forces, beam, probes,
 * steps); only those that the scene has something for. */
#ifndef RUN_TABLES_H
#define RUN_TABLES_H

#include "eval/observe.h"
#include "measure/running.h"
#include "time/method.h"

struct tables;

/* Makes the files with their header lines in DIR, removes those that an earlier run
 * left and this one has nothing for.  *means: running means of probes, which are the run's:
 * made here when they are needed and not there yet.  again: goes on with the files that are
 * there, after tables_keep(). */
int tables_open(struct tables **out, const struct plan *plan, const char *dir,
                struct running **means, bool again);

/* For ranks that write none, but look with the first. */
int tables_open_none(struct tables **out, const struct plan *plan, struct running **means);

/* Makes none.  STATUS_BAD_SCENE: tables_open() would refuse, when some files were there already. */
int tables_agree(const struct plan *plan);

/* Lengths of all files, output/series.h. */
int tables_keep(struct tables *o, struct archive *a);

/* A row in pairing.csv: it costs as much as a right-hand side. */
int tables_pairing(struct tables *o, struct moment *moment, double t, const double *y);

/* What tables_rows() shows of the water, after observe_forces() that found them at the same (t, y): all ranks
 * together where each has own rows of y alone. */
void tables_look(struct tables *o, struct moment *moment, double t, const double *y);

/* A row in every other table for moment t and state y, whose sheet of the book is
 * given, with what it cannot explain [J]; in book.csv alone where `forces`, the status of
 * observe_forces() there, is one of failure, which is returned. */
int tables_rows(struct tables *o, struct moment *moment, double t, const double *y,
                const struct book_sheet *sheet, int forces);

/* Rows of profiles.csv. */
int tables_profile(struct tables *o, struct moment *moment, double t, const double *y);

/* Readings for running means, if there are any: at the start and after each accepted step,
 * before rows up to it are written. */
int tables_readings(struct tables *o, struct moment *moment, double t, const double *y);

/* A row in steps.csv. */
int tables_step(struct tables *o, const struct method_step *step);

/* A row in checkpoints.csv. */
int tables_checkpoint(struct tables *o, double t, const char *because);

/* Closes and frees, NULL is welcome; the first error is told. */
int tables_close(struct tables **tables);

#endif
