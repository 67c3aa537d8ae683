/* sum-pass.c -- shares of threads in a pass of sums, and their powers put together. */
#include "plan/sum-pass.h"

#include "base/status.h"
#include "base/threads.h"
#include "ranks/ranks.h"

#include <stdlib.h>
#include <string.h>

/* The pass, and what is done with each group. */
struct work {
    struct sum_pass pass;
    sum_pass_groups *groups;
};

static void sum_chunk(const void *of, int chunk, int from, int to, struct block *b)
{
    const struct work *work = of;
    const struct sum_pass *pass = &work->pass;
    const int slots = pass->job->slots;
    const size_t mine = (size_t)threads_me() * (size_t)slots;
    struct exact_cut *const cut = pass->cut + mine;
    struct chunk_power book;

    (void)chunk;
    book.n = 0;
    work->groups(pass, from, to, b, &book);
    for (int s = 0; s < slots; s++) {
        exact_rows_count(&book.rows[s], book.n);
        exact_rows_close(&book.rows[s], &cut[s], &pass->power[mine + (size_t)s]);
    }
}

/* Kinds that own nothing have rates of exactly 0. */
static void clear_idle(const struct sum_job *job)
{
    const struct list *list = job->list;

    for (int kind = 0; kind < KINDS; kind++)
        if (list->group_from[kind] == list->group_from[kind + 1])
            clear_slots(job, kind, list->start[kind],
                        list->start[kind + 1] - list->start[kind]);
}

/* Where ranks share sums, all make room at their first one, and end if one has none. */
static int make_room(struct sum_scratch *scratch, int slots, bool shared)
{
    const int threads = threads_most();
    bool made = false;
    int status;

    if (threads > scratch->threads || slots != scratch->slots) {
        free(scratch->power);
        free(scratch->cut);
        made = true;
        scratch->threads = threads;
        scratch->slots = slots;
        scratch->power = malloc((size_t)threads * (size_t)(slots + 1) * sizeof *scratch->power);
        scratch->cut = calloc((size_t)threads * (size_t)(slots + 1), sizeof *scratch->cut);
    }
    status = scratch->power && scratch->cut
                 ? STATUS_DONE : status_starved("the power of %d effects cannot be summed", slots);
    TRY(made && shared ? ranks_agree(status) : status);
    memset(scratch->power, 0, (size_t)scratch->threads * (size_t)slots * sizeof *scratch->power);
    return STATUS_DONE;
}

/* Those of all ranks, in one message: sums are words, and nothing else. */
static void add_ranks(int slots, struct exact_sum *power)
{
    int64_t word[SUM_SLOTS][EXACT_SUM_WORDS];

    for (int s = 0; s < slots; s++) {
        exact_sum_carry(&power[s]);
        memcpy(word[s], power[s].word, sizeof word[s]);
    }
    ranks_add(slots * EXACT_SUM_WORDS, word[0]);
    for (int s = 0; s < slots; s++)
        memcpy(power[s].word, word[s], sizeof word[s]);
}

/* What a row costs by the kind of its owners: it is fetched, and has laws. */
static void weigh(const struct sum_job *job, int *cost)
{
    enum { FETCHED = 7 }; /* laws */

    for (int kind = 0; kind < KINDS; kind++) {
        int most = 0;

        for (int partner = 0; partner < KINDS; partner++) {
            const int laws = job->table[kind * KINDS + partner].n;
            most = laws > most ? laws : most;
        }
        cost[kind] = FETCHED + most;
    }
}

int sum_pass_run(const struct sum_job *job, struct sum_scratch *scratch, sum_pass_groups *groups)
{
    const int slots = job->slots;
    int cost[KINDS];
    struct work work;

    if (slots > SUM_SLOTS)
        return status_fail(STATUS_FAILED, "%d effects act on pairs, %d are possible", slots,
                           SUM_SLOTS);
    TRY(make_room(scratch, slots, job->shared));
    work = (struct work){ { job, scratch->power, scratch->cut, scratch->record }, groups };
    clear_idle(job);
    weigh(job, cost);
    visit_shares(job->list, VISIT_ALL, cost, sum_chunk, &work);
    for (int s = 0; s < slots; s++)
        for (int t = 1; t < scratch->threads; t++)
            exact_sum_merge(&scratch->power[s], &scratch->power[t * slots + s]);
    if (job->parts) {
        memcpy(job->parts, scratch->power, (size_t)slots * sizeof *job->parts);
        return STATUS_DONE;
    }
    if (job->shared)
        add_ranks(slots, scratch->power);
    for (int s = 0; s < slots; s++)
        job->power[s] = exact_sum_value(&scratch->power[s]);
    return STATUS_DONE;
}
