/* drift-used.c -- which blocks are compared, and which have places of others. */
#include "space/drift.h"

#include "space/list-private.h"

enum { MINE = 1, OTHERS = 2 }; /* a block that this rank compares; one that it compares another with */

/* Is there something that can move in this block, or in one that is compared with it? */
static bool stirs_near(const struct drift *drift, int block, const int *offset, int offsets)
{
    bool stirs = false;

    for (int o = 0; o < offsets; o++)
        stirs |= drift->moving[block + offset[o]] > 0;
    return stirs;
}

/* Of many ranks one compares a block with those around it: it owns the first member, and so knows all of
 * them. */
static bool is_mine(const struct list *list, int block)
{
    const struct drift *drift = &list->own->drift;

    return !list->whole || list->mine[drift->row[drift->end[block] - drift->count[block]]];
}

/* Marks blocks that this rank compares, and those that it compares them with. */
static void mark_mine(const struct list *list, struct drift *drift, const int *offset, int offsets)
{
    for (int k = 0; k < drift->useds; k++)
        drift->thread[drift->used[k]] = 0;
    for (int k = 0; k < drift->useds; k++)
        if (is_mine(list, drift->used[k]))
            for (int o = 0; o < offsets; o++)
                drift->thread[drift->used[k] + offset[o]] |= offset[o] == 0 ? MINE : OTHERS;
}

void drift_choose(struct list *list)
{
    struct drift *drift = &list->own->drift;
    int offset[DRIFT_TOUCHING], n = 0;
    const int offsets = drift_touching(drift, offset);

    mark_mine(list, drift, offset, offsets);
    for (int k = 0; k < drift->useds; k++) {
        const int b = drift->used[k];
        if (drift->thread[b] && stirs_near(drift, b, offset, offsets))
            drift->used[n++] = b;
    }
    drift->useds = n;
    drift->mines = 0;
    for (int k = 0; k < n; k++) {
        const int b = drift->used[k];
        if (drift->thread[b] & MINE) {
            drift->used[k] = drift->used[drift->mines];
            drift->used[drift->mines++] = b;
        }
    }
}

void drift_mark(const struct list *list, const bool *of)
{
    const struct drift *drift = &list->own->drift;
    int *mark = drift->thread, offset[DRIFT_TOUCHING];
    const int offsets = drift_touching(drift, offset);

    for (int s = 0; s < list->listed; s++)
        mark[drift->block[s]] = 0;
    for (int s = 0; s < list->listed; s++) {
        const int b = drift->block[s];

        if (!of[s] || mark[b] & DRIFT_HAS)
            continue;
        for (int o = 0; o < offsets; o++) {
            mark[b + offset[o]] |= DRIFT_TOUCHES;
            mark[b - offset[o]] |= DRIFT_TOUCHES;
        }
        mark[b] |= DRIFT_HAS;
    }
}

bool drift_is_near(const struct list *list, int place)
{
    const struct drift *drift = &list->own->drift;

    return drift->thread[drift->block[place]] != 0;
}

bool drift_near_group(const struct list *l, int g)
{
    const int from = l->group_slot[g], end = l->start[l->group_kind[g] + 1];
    bool near = false;

    for (int s = from; s < from + l->lanes && s < end; s++)
        near |= drift_is_near(l, s);
    return near;
}
