/* drift-blocks.c -- which particles stood in which block when the list was made. */
#include "space/drift.h"

#include "base/pages.h"
#include "base/status.h"
#include "base/threads.h"
#include "base/waiting.h"
#include "space/list-private.h"

#include <stdlib.h>
#include <string.h>

static int make_room(const struct list *list, struct drift *drift, size_t blocks)
{
    const size_t all = (size_t)list->listed + 1;

    if (list_grow((void **)&drift->block, &drift->room.block, all, sizeof *drift->block)
        && list_grow((void **)&drift->run, &drift->room.run, all, sizeof *drift->run)
        && list_grow((void **)&drift->member, &drift->room.member, all, sizeof *drift->member)
        && list_grow((void **)&drift->row, &drift->room.row, all, sizeof *drift->row)
        && list_grow((void **)&drift->was, &drift->room.was, all, sizeof *drift->was)
        && list_grow((void **)&drift->end, &drift->room.end, blocks, sizeof *drift->end)
        && list_grow((void **)&drift->count, &drift->room.count, blocks, sizeof *drift->count)
        && list_grow((void **)&drift->first, &drift->room.first, blocks, sizeof *drift->first)
        && list_grow((void **)&drift->moving, &drift->room.moving, blocks, sizeof *drift->moving)
        && list_grow((void **)&drift->thread, &drift->room.thread, blocks, sizeof *drift->thread)
        && list_grow((void **)&drift->used, &drift->room.used, blocks + 1, sizeof *drift->used)
        && list_grow((void **)&drift->range, &drift->room.range, blocks,
                     2 * DIM * sizeof *drift->range))
        return STATUS_DONE;
    return list_no_memory(list);
}

static int block_of(const struct drift *drift, const double *x)
{
    int block = 0;

    for (int d = DIM - 1; d >= 0; d--)
        block = block * drift->n[d] + 1 + (int)((x[d] - drift->low[d]) * drift->per_metre[d]);
    return block;
}

void drift_place(const struct list *list, int slot, const double *x, double *to)
{
    memcpy(to, x, DIM * sizeof *to);
    for (int d = 0; d < DIM && list->offset; d++)
        to[d] += list->offset[slot][d];
}

/* Of places of particles. */
static void find_own(const struct list *list, struct drift *drift)
{
    const double *stand = list->own->stand;

#pragma omp for schedule(static) nowait
    for (int s = 0; s < list->start[KINDS]; s++)
        drift->block[s] = block_of(drift, stand + (size_t)list->order[s] * DIM);
}

/* Which block each place is in. */
static void find_blocks(const struct list *list, const struct cloud *cloud, struct drift *drift)
{
    THREADS(waiting_repays(list->n), find_own(list, drift));
    for (int kind = 0; kind < KINDS; kind++)
        for (int s = list->image[kind]; s < list->image[kind + 1]; s++) {
            const int i = list->order[s] - list->def.from[kind];
            double at[DIM];

            drift_place(list, s, cloud->x[kind] + (size_t)i * DIM, at);
            drift->block[s] = block_of(drift, at);
        }
}

/* The n places from `from` on become members of block b. */
static void add_run(const struct list *list, struct drift *drift, int b, int from, int n)
{
    const int m = drift->end[b];

    drift->end[b] += n;
    for (int k = 0; k < n; k++) {
        drift->member[m + k] = from + k;
        drift->row[m + k] = list->order[from + k];
        memcpy(drift->was[m + k], list->own->built + (size_t)drift->row[m + k] * DIM, sizeof *drift->was);
    }
}

/* Runs of a kind, those of this thread. */
static void add_runs(const struct list *list, struct drift *drift, int kind, bool moves)
{
    const int me = threads_me();

    for (int r = drift->run_from[kind]; r < drift->run_from[kind + 1]; r++) {
        const int from = drift->run[r], n = drift->run[r + 1] - from, b = drift->block[from];

        if (drift->thread[b] != me)
            continue;
        drift->first[b] += kind == 0 ? n : 0;
        drift->moving[b] += moves ? n : 0;
        add_run(list, drift, b, from, n);
    }
}

/* Of kinds that move, or of those that do not. */
static void add_kinds(const struct list *list, struct drift *drift, bool moves)
{
    for (int k = 0; k < 2 * KINDS; k++)
        if (list_is_still(list, k % KINDS) != moves)
            add_runs(list, drift, k, moves);
}

/* Shares blocks out to threads, by members; tells each where its members begin. */
static void begin_blocks(const struct list *list, struct drift *drift, int threads)
{
    int next = 0;

    for (int k = 0; k < drift->useds; k++) {
        const int b = drift->used[k];
        drift->thread[b] = (int)((long)next * threads / list->listed);
        drift->end[b] = next;
        drift->first[b] = 0;
        memset(drift->range + (size_t)b * 2 * DIM, 0, 2 * DIM * sizeof *drift->range);
        next += drift->count[b];
    }
}

static void add_all(const struct list *list, struct drift *drift)
{
#pragma omp single nowait
    begin_blocks(list, drift, threads_all());
    threads_meet();
    add_kinds(list, drift, true);
    add_kinds(list, drift, false);
}

/* Of the places from..to-1: runs, and how many members each block has. */
static void count_range(struct drift *drift, int from, int to, int *runs)
{
    const int *block = drift->block;

    for (int s = from; s < to;) {
        const int b = block[s], first = s;

        while (++s < to && block[s] == b)
            ;
        drift->run[(*runs)++] = first;
        drift->used[drift->useds] = b;
        drift->useds += drift->count[b] == 0; /* else written over */
        drift->count[b] += s - first;
    }
}

/* Places follow each other in space, so a block is named by some in a row.  These are found once:
 * if places were counted and added one by one, each would wait for the one before. */
static void count_members(const struct list *list, struct drift *drift)
{
    int runs = 0;

    for (int k = 0; k < 2 * KINDS; k++) {
        const int *start = k < KINDS ? list->start + k : list->image + k - KINDS;
        drift->run_from[k] = runs;
        count_range(drift, start[0], start[1], &runs);
    }
    drift->run_from[2 * KINDS] = runs;
    drift->run[runs] = list->listed;
}

/* Members of each block, one block after the other, each in the order of places: what is near
 * in space is near in memory. */
static void gather_members(const struct list *list, struct drift *drift)
{
    count_members(list, drift);
    THREADS(waiting_repays(list->listed / 4), add_all(list, drift));
}

int drift_note(struct list *list, const struct cloud *cloud)
{
    struct drift *drift = &list->own->drift;

    drift->useds = drift->mines = 0;
    drift->far = false;
    if (list->listed == 0)
        return STATUS_DONE;
    const size_t blocks = drift_shape(list, list->own->cells, list->own->image_cells, drift);
    TRY(make_room(list, drift, blocks));
    memset(drift->count, 0, blocks * sizeof *drift->count);
    memset(drift->moving, 0, blocks * sizeof *drift->moving);
    find_blocks(list, cloud, drift);
    gather_members(list, drift);
    drift_choose(list);
    return STATUS_DONE;
}

double drift_written(const struct list *list)
{
    const struct drift *d = &list->own->drift;
    double blocks = 1;

    for (int k = 0; k < DIM; k++)
        blocks *= d->n[k];
    return list->listed * (3.0 * sizeof(int) + DIM * sizeof(double)) + (5 * blocks + d->useds) * sizeof(int)
           + 1.5 * pages_bytes(0, list->listed, d->block, 2 * DIM * sizeof *d->range);
}

void drift_free(struct drift *drift)
{
    free(drift->block);
    free(drift->run);
    free(drift->member);
    free(drift->row);
    free(drift->thread);
    free(drift->was);
    free(drift->end);
    free(drift->count);
    free(drift->first);
    free(drift->moving);
    free(drift->used);
    free(drift->range);
    *drift = (struct drift){ 0 };
}
