/* sum-field.c -- sums of fields: what neighbours add up to before there are forces. */
#include "plan/sum.h"

#include "space/visit.h"

static void field_group(const struct sum_field_job *job, int g, struct block *b)
{
    struct visit v = visit_group(job->list, g);
    struct field_sum sum = { 0 };
    struct side a;

    if (!visit_is_idle(&v))
        gather_side(job->record, v.first, v.end, job->list->listed, &a);
    while (visit_segment(&v, job->meets[v.kind]))
        while (visit_rows(&v, job->record, job->needs, job->kernel, &a, b))
            job->gather(job->self, &a, b, &sum);
    visit_write(&v, PAIRS_FIELD, sum.s, job->sum[0]);
}

static void field_groups(const void *of, int chunk, int from, int to, struct block *b)
{
    (void)chunk;
    for (int g = from; g < to; g++)
        field_group(of, g, b);
}

void LANE_NAME(sum_field)(const struct sum_field_job *job)
{
    unsigned kinds = 0;

    for (int kind = 0; kind < KINDS; kind++)
        kinds |= job->meets[kind] ? KIND_BIT(kind) : 0;
    visit_chunks(job->list, kinds, field_groups, job);
    list_complete(job->list, kinds, PAIRS_FIELD, job->sum[0]);
}
