/* series.h -- CSV files that grow by a row at a time.
 *
 * First a comment line with the units, then a line with the names, then rows:
 *
 *     # units: s,m,m
 *     t,x,height
 *     0.005,0.146,0.29
 *
 * A run that is killed leaves whole lines, at most a second old; so does a
 * disk that is full.  Numbers have 10 digits, the first column 12. */
#ifndef OUTPUT_SERIES_H
#define OUTPUT_SERIES_H

#include "base/archive.h"

struct series;

/* Makes the file; name and unit [columns] are only read here ("" or "1" for a
 * column without unit). */
int series_open(struct series **out, const char *path, int columns, const char *const *name,
                const char *const *unit);

/* Opens a file that is there to add rows behind those that series_keep() leaves: to be called
 * before the first one. */
int series_open_again(struct series **out, const char *path, int columns);

/* The length of the file as an archive's entry `name`.  Saving: its rows are on the disk.
 * Loading: what came later is cut off; STATUS_IO when the file has become shorter.  NULL is
 * welcome and keeps nothing. */
int series_keep(struct series *s, struct archive *a, const char *name);

/* Adds a row of value [columns]. */
int series_row(struct series *s, const double *value);

/* The same; where text[i] is not NULL it stands in column i instead. */
int series_text_row(struct series *s, const double *value, const char *const *text);

/* Writes down what is held back; for a moment when others will read. */
int series_flush(struct series *s);

/* Closes and frees, NULL is welcome; an error of the last rows is told here. */
int series_close(struct series **series);

#endif
