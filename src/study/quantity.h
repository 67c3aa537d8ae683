/* quantity.h -- which tables of a run have bands, and what is told of their columns. */
#ifndef STUDY_QUANTITY_H
#define STUDY_QUANTITY_H

#include <stdbool.h>

struct quantity {
    int table;      /* number in quantity_tables                                          */
    const char *end; /* of names of columns; "": all others                               */
    bool change;    /* its size is that of its change: where it starts is a matter of axes */
    unsigned tells; /* bits 1 << enum bundle_scalar, for the screen; 0: only in files     */
};

/* Names of the tables without ".csv", NULL-ended. */
extern const char *const quantity_tables[];

/* The first row that a column of a table fits. */
const struct quantity *quantity_find(int table, const char *name);

#endif
