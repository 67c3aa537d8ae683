/* exact-share.c -- exact sums of all ranks. */
#include "algebra/exact-sum.h"

#include "ranks/ranks.h"

#include <string.h>

enum { AT_ONCE = 32 };

static void share(int n, struct exact_sum *const *sum)
{
    int64_t word[AT_ONCE][EXACT_SUM_WORDS];

    for (int i = 0; i < n; i++) {
        exact_sum_carry(sum[i]);
        memcpy(word[i], sum[i]->word, sizeof word[i]);
    }
    ranks_add(n * EXACT_SUM_WORDS, word[0]);
    for (int i = 0; i < n; i++) {
        memcpy(sum[i]->word, word[i], sizeof word[i]);
        sum[i]->full = ranks_count();
    }
}

void exact_sum_share(int n, struct exact_sum *const *sum)
{
    for (int from = 0; from < n; from += AT_ONCE)
        share(n - from < AT_ONCE ? n - from : AT_ONCE, sum + from);
}
