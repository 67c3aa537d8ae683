/* bundle.h -- the same table of several runs, and the band that they make. */
#ifndef STUDY_BUNDLE_H
#define STUDY_BUNDLE_H

#include "study/member.h"
#include "study/sample.h"
#include "output/table.h"

struct bundle {
    int runs, rows, columns;
    struct table *table; /* [runs], all with the same names and times */
};

/* Reads FILE of those of the members [n] that are done.  False, and a bundle of no runs, when
 * one of them has no such table, or another one than the first.  Free it in any case. */
bool bundle_read(struct bundle *b, const struct member_home *h, const struct member *m, int n,
                 const char *file);
void bundle_free(struct bundle *b);

double bundle_time(const struct bundle *b, int row);
void bundle_sample(const struct bundle *b, int row, int column, struct sample *s);

/* Largest size of the mean of a column [its unit]; `change': of its change since the first
 * row; `vector': together with the columns whose names differ from its own only in x, y or z
 * at the end. */
double bundle_size(const struct bundle *b, int column, bool change, bool vector);

/* First time at which the band, largest - least, is wider than `width'; NAN: never. */
double bundle_lost(const struct bundle *b, int column, double width);

/* What one run shows in a column, all but the last within the times window[0] to window[1]. */
enum bundle_scalar {
    BUNDLE_PEAK,    /* largest value, downwards where the mean goes further down than up */
    BUNDLE_WHEN,    /* its time [s]                                                       */
    BUNDLE_AVERAGE, /* mean over time                                                     */
    BUNDLE_END,     /* last value of the run                                              */
    BUNDLE_SCALARS
};

/* That, over the runs. */
void bundle_scalar(const struct bundle *b, int column, enum bundle_scalar what,
                   const double window[2], struct sample *s);

#endif
