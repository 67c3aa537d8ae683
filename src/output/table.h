/* table.h -- numbers of a CSV file: lines that start with #, of which "# units: " has the
 * units, a line of names, rows.  And cells of such a file, for those who write one. */
#ifndef OUTPUT_TABLE_H
#define OUTPUT_TABLE_H

#include <stdbool.h>
#include <stdio.h>

struct table {
    int columns, rows;
    char **name;   /* [columns] */
    double *value; /* [rows][columns]; what is no number is NAN */
    char *names;   /* the line that name points into */
    char *units;   /* as they stand in the file; NULL: none */
};

/* Reads path.  False when it cannot be read or has no line of names: that a run left no
 * such table is no failure. */
bool table_read(struct table *t, const char *path);
void table_free(struct table *t); /* one that was not read is fine */

int table_column(const struct table *t, const char *name); /* -1: none */
double table_at(const struct table *t, int row, int column);

/* The unit of a column into to [size]; "": it has none. */
void table_unit(const struct table *t, int column, char *to, unsigned long size);

/* Same names and as many rows, at least one: the same objects at the same times. */
bool table_alike(const struct table *a, const struct table *b);
bool table_same_times(const struct table *a, const struct table *b); /* of such two */

/* Cells behind the first of a row: a number, NAN as "nan"; a text in quotes, where commas may
 * stand but quotes and line ends may not; a word without its quotes and with ; for commas.  So no
 * cell but a text has quotes: gnuplot, which ends quoted cells at their first comma, can tell
 * texts by them. */
void table_put(FILE *to, double value);
void table_put_text(FILE *to, const char *what);
void table_put_word(FILE *to, const char *what);
void table_put_first(FILE *to, const char *what); /* a word that begins a row */

#endif
