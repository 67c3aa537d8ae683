/* ranks.h -- a run that several processes share: the first of them writes all files and says
 * all words, all go through the same steps. */
#ifndef RUN_RANKS_H
#define RUN_RANKS_H

#include "run/inside.h"

/* Rows of y that each rank has: this run's method, or its norm, may want all, as sums in an order do. */
enum moment_rows run_ranks_rows(const struct run *r);

/* Once it is shared: can what this run's method keeps follow particles that change their rank? */
void run_ranks_begin(struct run *r);

/* After a step: ranks that have more work than others give particles away.  Before there is a method, once
 * r->y was evaluated, too: then vectors of a method have memory for rows of a cut that knows pairs. */
int run_ranks_balance(struct run *r);

/* Status of all ranks that read their scenes; refused, with the first setting that differs, where these are not
 * the same.  ranks_agree_after() knows of it. */
int run_ranks_same(const struct run *r, int status);

/* Is this the rank that writes? */
bool run_ranks_writes(void);

/* Before a step: a signal that came to any rank, and what a rank alone has met, go along with right-hand
 * sides and end the run of all after a step; where these do not ask all, that is asked after it. */
void run_ranks_wish(struct run *r);
int run_ranks_stopped(const struct run *r); /* the signal */

/* After a step: what this rank alone has met, which it keeps until all have heard of it; the status
 * itself where all ask each other after each step. */
int run_ranks_met(struct run *r, int status);

/* Then: has a rank met something?  status: what all alike have, or else are to be asked about. */
int run_ranks_heard(struct run *r, int status);

/* As ranks_agree(), with what this rank has met before. */
int run_ranks_agree(struct run *r, int status);

#endif
