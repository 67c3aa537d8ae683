/* sum-field.c -- the traversal for fields: what neighbours add up to before there are
 * forces. */
#include "plan/sum-chunks.h"

#include "space/gather.h"

/* What one field adds up for one group of owners. */
static void field_group(const struct sum_field_job *job, int g, struct block *b)
{
    const struct list *list = job->list;
    const int first = list->group_slot[g], kind = list->group_kind[g];
    const int end = list->start[kind + 1];
    gather_rows *const gather = gather_choose(job->needs);
    struct field_sum sum = { 0 };
    struct side a;

    gather_side(job->record, first, end, list->listed, &a);
    for (int s = list->segment_from[g]; s < list->segment_from[g + 1]; s++) {
        const struct list_segment *segment = &list->segment[s];

        for (int row = 0; row < segment->rows; row += PAIRS_ROWS) {
            const int left = segment->rows - row;

            if (!(job->meets[kind] & KIND_BIT(segment->partner)))
                break;
            b->n = left < PAIRS_ROWS ? left : PAIRS_ROWS;
            gather(job->record, segment->j + (size_t)row * LANES, b->n, &a, b);
            gather_kernel(job->needs, job->kernel, b);
            job->gather(job->self, &a, b, &sum);
        }
    }
    for (int l = 0; l < LANES && first + l < end; l++)
        for (int i = 0; i < PAIRS_FIELD; i++)
            job->sum[first + l][i] = sum.s[i][l];
}

void LANE_NAME(sum_field)(const struct sum_field_job *job)
{
    const struct list *list = job->list;

    for (int kind = 0; kind < KINDS; kind++) {
        const int from = list->group_from[kind], to = list->group_from[kind + 1];

        if (!job->meets[kind])
            continue;
#pragma omp parallel if (to - from > SUM_WORTH_THREADS / LANES)
        {
            struct block b;

#pragma omp for schedule(static)
            for (int g = from; g < to; g++)
                field_group(job, g, &b);
        }
    }
}
