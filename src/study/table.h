/* table.h -- numbers of a CSV file: lines that start with #, a line of names, rows. */
#ifndef STUDY_TABLE_H
#define STUDY_TABLE_H

#include <stdbool.h>

struct table {
    int columns, rows;
    char **name;   /* [columns] */
    double *value; /* [rows][columns]; what is no number is NAN */
    char *names;   /* the line that name points into */
};

/* Reads path.  False when it cannot be read or has no line of names: that a run left no
 * such table is no failure. */
bool table_read(struct table *t, const char *path);
void table_free(struct table *t); /* one that was not read is fine */

int table_column(const struct table *t, const char *name); /* -1: none */

#endif
