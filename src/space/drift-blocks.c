/* drift-blocks.c -- which particles stood in which block when the list was made. */
#include "space/drift.h"

#include "base/status.h"
#include "space/list-private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Widens low..high by the grids of all kinds. */
static void widen(const struct cells cells[KINDS], double *low, double *high)
{
    for (int d = 0; d < DIM; d++)
        for (int kind = 0; kind < KINDS; kind++) {
            if (cells[kind].n[d] == 0)
                continue;
            low[d] = fmin(low[d], cells[kind].low[d]);
            high[d] = fmax(high[d], cells[kind].low[d]
                                        + cells[kind].n[d] / cells[kind].per_metre[d]);
        }
}

/* Blocks over the grids of all kinds, an empty one around them; coarser until
 * there are not many more than particles. */
static size_t make_grid(const struct list *list, struct drift *drift)
{
    const double edge = list->def.support + 2 * DRIFT_FARTHEST * list->def.skin;
    double high[DIM];

    for (int d = 0; d < DIM; d++) {
        drift->low[d] = INFINITY;
        high[d] = -INFINITY;
    }
    widen(list->own->cells, drift->low, high);
    widen(list->own->image_cells, drift->low, high);
    for (double coarse = 1;; coarse *= 1.25) {
        double blocks = 1;

        for (int d = 0; d < DIM; d++) {
            drift->per_metre[d] = 1 / (coarse * edge);
            blocks *= floor((high[d] - drift->low[d]) * drift->per_metre[d]) + 3;
        }
        if (blocks > 8.0 * list->listed + 4096)
            continue;
        for (int d = 0; d < DIM; d++)
            drift->n[d] = (int)((high[d] - drift->low[d]) * drift->per_metre[d]) + 3;
        return (size_t)blocks;
    }
}

static int make_room(const struct list *list, struct drift *drift, size_t blocks)
{
    const size_t all = (size_t)(list->n + list->listed - list->image[0]) + 1;

    if (list_grow((void **)&drift->block, &drift->block_room, all, sizeof *drift->block)
        && list_grow((void **)&drift->next, &drift->next_room, all, sizeof *drift->next)
        && list_grow((void **)&drift->head, &drift->head_room, blocks, sizeof *drift->head)
        && list_grow((void **)&drift->used, &drift->used_room, blocks, sizeof *drift->used)
        && list_grow((void **)&drift->kinds, &drift->kinds_room, blocks, sizeof *drift->kinds)
        && list_grow((void **)&drift->range, &drift->range_room, blocks,
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

int drift_number(const struct list *list, int slot)
{
    return list->n + slot - list->image[0];
}

void drift_place(const struct list *list, int slot, const double *x, double *to)
{
    memcpy(to, x, DIM * sizeof *to);
    for (int d = 0; d < DIM && list->offset; d++)
        to[d] += list->offset[slot][d];
}

/* A particle of this kind, which stands at x. */
static void enter(struct drift *drift, int number, int kind, const double *x)
{
    const int b = drift->block[number] = block_of(drift, x);

    drift->next[number] = drift->kinds[b] ? drift->head[b] : -1;
    drift->head[b] = number;
    if (drift->kinds[b] == 0)
        drift->used[drift->useds++] = b;
    drift->kinds[b] |= (unsigned char)KIND_BIT(kind);
}

int drift_note(struct list *list, const struct cloud *cloud)
{
    struct drift *drift = &list->own->drift;

    drift->useds = 0;
    if (list->listed == 0)
        return STATUS_DONE;
    const size_t blocks = make_grid(list, drift);
    TRY(make_room(list, drift, blocks));
    memset(drift->kinds, 0, blocks);
    for (int kind = 0; kind < KINDS; kind++) {
        double at[DIM];

        for (int i = list->def.from[kind]; i < list->def.from[kind + 1]; i++)
            if (list->slot[i] >= 0)
                enter(drift, i, kind, list->own->stand + (size_t)i * DIM);
            else
                drift->block[i] = -1;
        for (int s = list->image[kind]; s < list->image[kind + 1]; s++) {
            const int i = list->order[s] - list->def.from[kind];
            drift_place(list, s, cloud->x[kind] + (size_t)i * DIM, at);
            enter(drift, drift_number(list, s), kind, at);
        }
    }
    return STATUS_DONE;
}

void drift_free(struct drift *drift)
{
    free(drift->block);
    free(drift->next);
    free(drift->head);
    free(drift->used);
    free(drift->kinds);
    free(drift->range);
    *drift = (struct drift){ 0 };
}
