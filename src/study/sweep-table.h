/* sweep-table.h -- what a sweep found, a row a run. */
#ifndef STUDY_SWEEP_TABLE_H
#define STUDY_SWEEP_TABLE_H

#include "study/sweep-outputs.h"

struct sweep {
    struct study study;            /* points and their keys                   */
    struct member *run;            /* [points]                                */
    struct result *result;         /* [points]                                */
    struct sweep_outputs outputs;
};

/* DIR/sweep.csv: keys, costs, main outputs, the others. */
int sweep_table_csv(const struct sweep *s);

/* DIR/sweep.md, and on the screen: the same without the others. */
int sweep_table_words(const struct sweep *s);

#endif
