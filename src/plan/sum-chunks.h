/* sum-chunks.h -- how the traversal is cut: chunks of SUM_CHUNK slots of one kind, in
 * groups of LANES owners, and the chunks that each thread takes. */
#ifndef PLAN_SUM_CHUNKS_H
#define PLAN_SUM_CHUNKS_H

#include "plan/sum.h"
#include "base/lanes.h"

enum {
    CHUNK_GROUPS = SUM_CHUNK / LANES,
    SUM_WORTH_THREADS = 500 /* slots whose sums repay waking the threads */
};

static inline int sum_chunks_of(const struct list *list, int kind)
{
    const int groups = list->group_from[kind + 1] - list->group_from[kind];

    return (groups + CHUNK_GROUPS - 1) / CHUNK_GROUPS;
}

static inline int sum_chunks(const struct list *list)
{
    int n = 0;

    for (int kind = 0; kind < KINDS; kind++)
        n += sum_chunks_of(list, kind);
    return n;
}

/* First group of a chunk; that of the end for the last chunk + 1. */
static inline int sum_first_group(const struct list *list, int chunk)
{
    for (int kind = 0; kind < KINDS; kind++) {
        const int n = sum_chunks_of(list, kind);

        if (chunk < n)
            return list->group_from[kind] + chunk * CHUNK_GROUPS;
        chunk -= n;
    }
    return list->groups;
}

/* Rows before a chunk, and some for the work that each group is anyway. */
static inline long sum_work_before(const struct list *list, int chunk)
{
    const int group = sum_first_group(list, chunk);

    return list->rows_before[group] + 4L * group;
}

/* First chunk of thread t of `of`: equal work, found by halving. */
static inline int sum_share(const struct list *list, int n, int t, int of)
{
    const long want = sum_work_before(list, n) / of * t;
    int low = 0, high = n;

    if (t == of)
        return n;
    while (low < high) {
        const int middle = low + (high - low) / 2;

        if (sum_work_before(list, middle) < want)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

#endif
