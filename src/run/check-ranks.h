/* check-ranks.h -- what ranks that share a run will need of memory, and tell each other. */
#ifndef RUN_CHECK_RANKS_H
#define RUN_CHECK_RANKS_H

#include "run/inside.h"

/* At a start that can be evaluated, shared between ranks already; all of them ask together.
 * Bytes: of `program` this one holds before there is a scene, `writing` takes the one that has the
 * outputs in any case.  STATUS_FAILED: no memory. */
int check_ranks_print(struct run *r, double program, double writing);

#endif
