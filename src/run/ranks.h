/* ranks.h -- a run that several processes share: the first of them writes all files and says
 * all words, all go through the same steps. */
#ifndef RUN_RANKS_H
#define RUN_RANKS_H

#include "run/inside.h"

/* Rows of y that each rank has: this run's method, or its norm, may want all, as sums in an order do. */
enum moment_rows run_ranks_rows(const struct run *r);

/* Once the method is there: can what it keeps follow particles that change their rank? */
void run_ranks_begin(struct run *r);

/* After a step: ranks that have more work than others give particles away. */
int run_ranks_balance(struct run *r);

/* Is this the rank that writes? */
bool run_ranks_writes(void);

/* The signal that came, to any rank; all ask together. */
int run_ranks_stopped(void);

#endif
