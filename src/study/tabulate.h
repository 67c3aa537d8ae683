/* tabulate.h -- what a comparison leaves: compare.csv, compare.json, compare.md. */
#ifndef STUDY_TABULATE_H
#define STUDY_TABULATE_H

#include "study/inside.h"

/* DIR/compare.csv: a row for each case of which a run has ended. */
int tabulate_csv(const struct study *s);

/* DIR/compare.json: reference, early time, growth of a disturbance. */
int tabulate_json(const struct study *s);

/* The cheapest runs for each decade of error, by CPU time and by pair passes, and the runs
 * that did not come to their end, as Markdown: to DIR/compare.md and, unless quiet, to
 * standard output. */
int tabulate_best(const struct study *s);

/* Median CPU time of a case over its repeats [s]. */
double tabulate_cpu(const struct study *s, int c);

/* Median and range (largest - smallest, NAN of one) of n numbers, which are sorted. */
void tabulate_spread(double *value, int n, double *median, double *range);

#endif
