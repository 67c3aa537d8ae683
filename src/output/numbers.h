/* numbers.h -- the main numbers of a run, each with what it is to be held against, from the
 * files in its directory. */
#ifndef OUTPUT_NUMBERS_H
#define OUTPUT_NUMBERS_H

#include <stdbool.h>
#include <stdio.h>

enum { NUMBERS_MOST = 40 };

struct numbers {
    int n;
    struct numbers_row {
        char what[80], value[200], against[200];
        bool wrong; /* it is not as it should be */
    } row[NUMBERS_MOST];
};

/* Of DIR/run.json and the tables beside it; what is not there is left out. */
void numbers_read(struct numbers *n, const char *run);

/* A line each, with ! before what is not as it should be. */
void numbers_print(const struct numbers *n, FILE *to);

#endif
