/* sum-pass.h -- a pass of sums over all owners, with what threads need for their powers. */
#ifndef PLAN_SUM_PASS_H
#define PLAN_SUM_PASS_H

#include "plan/sum-ends.h"

struct sum_pass {
    const struct sum_job *job;
    struct exact_sum *power; /* [threads][slots] */
    struct exact_cut *cut;   /* [threads][slots] */
    const float *record;     /* in single precision; NULL: pairs are in double */
};

/* Groups from..to-1, their powers into the book. */
typedef void sum_pass_groups(const struct sum_pass *pass, int from, int to, struct block *b,
                             struct chunk_power *book);

/* All owners; 0 or STATUS_FAILED (no memory). */
#define sum_pass_run LANE_NAME(sum_pass_run)
int sum_pass_run(const struct sum_job *job, struct sum_scratch *scratch, sum_pass_groups *groups);

#endif
