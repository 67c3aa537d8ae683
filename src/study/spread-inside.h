/* spread-inside.h -- an error bar in the making; for the files of this room. */
#ifndef STUDY_SPREAD_INSIDE_H
#define STUDY_SPREAD_INSIDE_H

#include "study/bundle.h"
#include "study/facts.h"
#include "study/spread.h"

enum { SPREAD_INSIDE_PICTURES = 50, SPREAD_INSIDE_TABLES = 4 };

/* How far particles of the runs are apart: at picture 0, 1, ... */
struct spread_apart {
    int n;                                    /* pictures that all runs have; 0: no fluid */
    double t[SPREAD_INSIDE_PICTURES + 1];     /* [s]                                      */
    double rms[SPREAD_INSIDE_PICTURES + 1];   /* [spacings], as spread_apart_read() says  */
    double worst[SPREAD_INSIDE_PICTURES + 1]; /* of one particle [spacings]               */
    double lost;                              /* when rms is above the share [s]; NAN: never */
};

struct spread {
    const struct spread_order *order;
    struct member_home home;
    struct facts facts;
    double window[2];
    struct member *member; /* [order->runs]                                               */
    int done;              /* of them                                                     */
    struct bundle bundle[SPREAD_INSIDE_TABLES]; /* as quantity_tables; of no runs: not there */
    struct spread_apart apart;
};

/* Positions of each particle over the runs: its standard deviation sqrt(sum_d var(x_d)), of
 * which rms is the root mean square over all particles of the fluid, worst the largest. */
void spread_apart_read(struct spread *s);
int spread_apart_write(const struct spread *s); /* DIR/spread-positions.csv */

/* DIR/spread-TABLE.csv: at each time mean, least, largest, standard deviation and half the
 * 95 % interval of each column. */
int spread_bands_write(const struct spread *s);

/* DIR/spread.csv: the same of peak, its time, mean and end of each column. */
int spread_scalars_write(const struct spread *s);

/* DIR/spread.json */
int spread_json_write(const struct spread *s);

/* What to make of it, as Markdown, with the scalars that are asked for most: to DIR/spread.md
 * and, unless quiet, to standard output. */
int spread_words_write(const struct spread *s);

/* When the band of a column became wider than the share of its size [s]; NAN: never. */
double spread_lost(const struct spread *s, int table, int column);

#endif
