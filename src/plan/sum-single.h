/* sum-single.h -- sums of laws over pairs in single precision, of up to two groups of owners
 * side by side.  The laws' parts of single precision are compiled from the same files. */
#ifndef PLAN_SUM_SINGLE_H
#define PLAN_SUM_SINGLE_H

#include "plan/sum.h"

struct sum_single {
    void (*arrange)(struct pairs_table *table, bool fuse); /* as that of struct sum_engine */

    /* What laws add up for groups g and, with both, g + 1: for column s of the book
     * sum[s][0..DIM-1] force [N] and sum[s][DIM] mass times rate of density, each
     * [2 lanes of the list], 64-byte aligned.  record: space/single.h. */
    void (*groups)(const struct sum_job *job, const float *record, int g, bool both,
                   float *sum);
};

extern const struct sum_single sum_single_single4, sum_single_single8, sum_single_single16;

#endif
