/* sum.c -- sums of laws over pairs, and their powers; lanes are particles.
 *
 * Rates are added in an order that slots alone decide: a lane its own neighbours, laws in
 * table order.  Powers are exact sums, which have no order. */
#include "plan/sum-pass.h"

#include "effects/fused.h"

/* Laws one after the other, each on all rows. */
static void laws_in_turn(const struct pairs_table *table, const struct side *a,
                         struct block *b, struct sum *sum)
{
    for (int i = 0; i < table->n; i++) {
        const struct pairs_work *w = &table->work[i];

        gather_kernel(w->needs, w->kernel, b);
        w->law(w->self, a, b, &sum[w->slot]);
    }
}

static void arrange(struct pairs_table *table, bool fuse)
{
    pairs_laws *const fused = fuse ? fused_laws(table) : NULL;

    table->laws = fused ? fused : laws_in_turn;
    table->straight = NULL;
}

LANES_INLINE struct sum sum_of(const void *sums, int s)
{
    return ((const struct sum *)sums)[s];
}

static void sum_group(const struct sum_job *job, int g, struct block *b,
                      struct chunk_power *book)
{
    struct visit v = visit_group(job->list, g);
    const struct pairs_table *tables = job->table + (size_t)v.kind * KINDS;
    const int owners = visit_owners(&v);
    struct sum part[SUM_SLOTS];
    struct side a;

    if (visit_is_idle(&v)) {
        clear_slots(job, v.kind, v.first, owners);
        return;
    }
    expect_rates(job, v.kind, v.first, owners);
    gather_side(job->record, v.first, v.end, job->list->listed, &a);
    memset(part, 0, (size_t)job->slots * sizeof *part);
    while (visit_segment(&v, VISIT_ALL)) {
        const struct pairs_table *table = &tables[v.segment->partner];

        while (table->n > 0 /* the list also serves summed densities */
               && visit_rows(&v, job->record, table->needs, NULL, &a, b))
            table->laws(table, &a, b, part);
    }
    finish_group(job, v.kind, v.first, owners, &a, sum_of, part, book);
}

static void sum_groups(const struct sum_pass *pass, int from, int to, struct block *b,
                       struct chunk_power *book)
{
    for (int g = from; g < to; g++)
        sum_group(pass->job, g, b, book);
}

static int sum_pairs(const struct sum_job *job, struct sum_scratch *scratch)
{
    return sum_pass_run(job, scratch, sum_groups);
}

const struct sum_engine LANE_NAME(sum_engine) = {
    .lanes = LANES, .list = &LANE_NAME(list_engine), .pack = LANE_NAME(record_pack),
    .densities = LANE_NAME(record_densities),
    .arrange = arrange, .pairs = sum_pairs,
    .field = LANE_NAME(sum_field),
};
