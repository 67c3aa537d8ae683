/* outputs.h -- the files of a run that grow while it goes. */
#ifndef RUN_OUTPUTS_H
#define RUN_OUTPUTS_H

#include "run/home.h"
#include "run/past.h"
#include "time/method.h"

struct outputs;

/* Makes the home's directory (and its files with their header lines).  What rows show, and readings of
 * probes that have running means, are kept in *past.  home->again: goes on with the files that
 * are there, after outputs_keep(). */
int outputs_open(struct outputs **out, const struct moment *moment, const struct home *home,
                 struct run_past *past);

/* What there is of files; loading cuts them back to it. */
int outputs_keep(struct outputs *o, struct archive *a);

/* The state at which a run begins; before any row. */
int outputs_start(struct outputs *o, struct moment *moment, double t, const double *y);

/* A row in every table for this moment, after observe_forces(), whose status is `forces`: where that
 * is none, book.csv alone has one.  At own rows of y, all ranks together, where each has these alone; else y is
 * whole, and the first alone calls it. */
int outputs_rows(struct outputs *o, struct moment *moment, double t, const double *y, int forces);

/* A row in steps.csv; y [size] is the state after the step. */
int outputs_step(struct outputs *o, struct moment *moment, const struct method_step *step,
                 const double *y);

/* Does outputs_step() look at y? */
bool outputs_reads(const struct plan *plan);

/* A row in checkpoints.csv, because of simulated "time" or of the "clock". */
int outputs_checkpoint(struct outputs *o, double t, const char *because);

/* Each point of the probes that have a profile. */
int outputs_profile(struct outputs *o, struct moment *moment, double t, const double *y);

/* A row of how near particles of the fluid are to each other: with each field. */
int outputs_pairing(struct outputs *o, struct moment *moment, double t, const double *y);

/* All particles, for viewers (output fields) or for pictures (snapshots).  At own rows of y, all ranks
 * together, where each has these alone; else y is whole, and others than the first do nothing. */
int outputs_field(struct outputs *o, struct moment *moment, double t, const double *y);
int outputs_snapshot(struct outputs *o, struct moment *moment, double t, const double *y);

/* The book at the last row, the first row's, and the largest defect [J]. */
const struct book_sheet *outputs_sheet(const struct outputs *o);
double outputs_energy_initial(const struct outputs *o);
double outputs_defect(const struct outputs *o);
double outputs_defect_max(const struct outputs *o);
double outputs_energy_made(const struct outputs *o); /* largest defect above 0 [J] */
/* The most energy the book explains: all of it, counted from the lowest corner of the
 * domain, or the kinetic and elastic one; no less than that of fluid at a hundredth of the
 * reference speed [J]. */
double outputs_energy_most(const struct outputs *o);
double outputs_momentum_defect(const struct outputs *o);

/* The row that had most fluid in solids. */
const struct observe_sunk *outputs_sunk(const struct outputs *o);

/* Closes and frees, NULL is welcome; the first error is told. */
int outputs_close(struct outputs **outputs);

#endif
