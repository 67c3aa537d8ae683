/* columns.h -- names and units of a table on their way to a file. */
#ifndef RUN_COLUMNS_H
#define RUN_COLUMNS_H

#include "output/series.h"

/* Columns of a table, letters of a name. */
enum { COLUMNS_MOST = 8192, COLUMNS_NAME = 80 };

struct columns {
    bool again; /* files are there: rows go on behind those that series_keep() leaves */
    bool tried; /* no files: whether there could be */
    int n; /* asked for; columns_open() refuses more than there is room for */
    char name[COLUMNS_MOST][COLUMNS_NAME], unit[COLUMNS_MOST][16];
};

/* The first column: t. */
void columns_start(struct columns *c);

/* One more, its name as of printf. */
void columns_add(struct columns *c, const char *unit, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Makes DIR/FILE with its header lines, or opens it again, or neither; a table of t alone is none.
 * STATUS_BAD_SCENE: too many columns. */
int columns_open(const struct columns *c, struct series **out, const char *dir, const char *file);

/* Closes what columns_open() opened; *status becomes the first error. */
void columns_close(struct series **s, int *status);

#endif
