/* ranks.h -- a run that several processes share: the first of them writes all files and says
 * all words, all go through the same steps. */
#ifndef RUN_RANKS_H
#define RUN_RANKS_H

#include "run/inside.h"

/* Does this run's method, or its norm, want all rows of y on each rank?  Sums in an order do. */
bool run_ranks_full(const struct run *r);

/* Is this the rank that writes? */
bool run_ranks_writes(void);

/* The signal that came, to any rank; all ask together. */
int run_ranks_stopped(void);

#endif
