/* drift.c -- displacements compared block by block, and one by one. */
#include "space/drift.h"

#include "base/waiting.h"
#include "space/list-private.h"

#include <math.h>
#include <stdatomic.h>

enum {
    CROWD = 128, /* in a block at most, to be looked at one by one           */
    PATIENCE = 4, /* pairs looked at, per particle                           */
    SHARE = 16   /* blocks that a thread takes at a time                     */
};

/* What stands in a block. */
struct crowd {
    int n;
    double now[CROWD][DIM], was[CROWD][DIM]; /* [m] */
};

/* The position of the particle in this row. */
static inline const double *position(const struct list *list, const struct cloud *cloud, int row)
{
    const int *from = list->def.from;
    int kind = 0;

    while (row >= from[kind + 1])
        kind++;
    return cloud->x[kind] + (size_t)(row - from[kind]) * DIM;
}

/* The range of displacements in a block; false when a particle went too far.  Images go
 * where their originals do. */
static bool find_range(const struct list *list, const struct cloud *cloud, int block)
{
    const struct drift *drift = &list->own->drift;
    const double limit = DRIFT_FARTHEST * list->def.skin;
    const int *member = drift->member + drift->end[block];
    double *range = drift->range + (size_t)block * 2 * DIM;
    double least[DIM], most[DIM], farthest = 0;

    for (int d = 0; d < DIM; d++) {
        least[d] = INFINITY;
        most[d] = -INFINITY;
    }
    for (int m = -drift->count[block]; m < 0; m++) {
        const int row = list->order[member[m]];
        const double *x = position(list, cloud, row);
        const double *built = list->own->built + (size_t)row * DIM;
        double far = 0;

        for (int d = 0; d < DIM; d++) {
            const double moved = x[d] - built[d];
            least[d] = moved < least[d] ? moved : least[d];
            most[d] = moved > most[d] ? moved : most[d];
            far += moved * moved;
        }
        farthest = far > farthest ? far : farthest;
    }
    for (int d = 0; d < DIM; d++) {
        range[2 * d] = least[d];
        range[2 * d + 1] = most[d];
    }
    return farthest <= limit * limit;
}

/* The largest displacement of a particle of one block against one of the other,
 * squared [m^2]. */
static double apart(const double *a, const double *b)
{
    double far = 0;

    for (int d = 0; d < DIM; d++) {
        const double one = a[2 * d + 1] - b[2 * d], other = b[2 * d + 1] - a[2 * d];
        const double most = one > other ? one : other;
        far += most * most;
    }
    return far;
}

/* Offsets to a block and to one of each two opposite blocks that touch it. */
static int touching(const struct drift *drift, int *offset)
{
    int n = 0;

    for (int z = DIM == 3 ? -1 : 0; z <= (DIM == 3); z++)
        for (int y = -1; y <= 1; y++)
            for (int x = -1; x <= 1; x++) {
                const int to = (z * drift->n[1] + y) * drift->n[0] + x;
                if (to >= 0)
                    offset[n++] = to;
            }
    return n;
}

/* False when they are too many. */
static bool meet(const struct list *list, const struct cloud *cloud, int block,
                 struct crowd *crowd)
{
    const struct drift *drift = &list->own->drift;
    const int *member = drift->member + drift->end[block] - drift->count[block];

    crowd->n = drift->count[block];
    if (crowd->n > CROWD)
        return false;
    for (int m = 0; m < crowd->n; m++) {
        const int row = list->order[member[m]];

        drift_place(list, member[m], position(list, cloud, row), crowd->now[m]);
        drift_place(list, member[m], list->own->built + (size_t)row * DIM, crowd->was[m]);
    }
    return true;
}

static double square(const double *x, const double *y)
{
    double sum = 0;

    for (int d = 0; d < DIM; d++)
        sum += (x[d] - y[d]) * (x[d] - y[d]);
    return sum;
}

/* Two within the support now that were too far apart to be listed? */
static bool pair_missing(const struct list *list, const struct crowd *a, const struct crowd *b)
{
    const double support = list->def.support, radius = support + list->def.skin;
    bool missing = false;

    for (int i = 0; i < a->n; i++)
        for (int k = 0; k < b->n; k++)
            missing |= square(a->now[i], b->now[k]) <= support * support
                     && square(a->was[i], b->was[k]) >= radius * radius;
    return missing;
}

/* No pair missing between a block and those that touch it; looks at pairs one by
 * one as long as patience lasts. */
static bool complete(const struct list *list, const struct cloud *cloud, int block, int offsets,
                     const int *offset, atomic_long *patience)
{
    const struct drift *drift = &list->own->drift;
    const double limit = list->def.skin * list->def.skin;
    const double *range = drift->range + (size_t)block * 2 * DIM;
    struct crowd here, there;
    bool met = false;

    for (int o = 0; o < offsets; o++) {
        const int other = block + offset[o];

        if (drift->count[other] == 0 || apart(range, drift->range + (size_t)other * 2 * DIM) <= limit)
            continue;
        if (!met && !meet(list, cloud, block, &here))
            return false;
        met = true;
        if (!meet(list, cloud, other, &there))
            return false;
        const long pairs = (long)here.n * there.n;
        if (atomic_fetch_sub(patience, pairs) < pairs || pair_missing(list, &here, &there))
            return false;
    }
    return true;
}

/* Nothing depends on who finds it: patience is a sum, and one that finds harm is enough. */
bool drift_harmless(const struct list *list, const struct cloud *cloud)
{
    const struct drift *drift = &list->own->drift;
    int offset[14]; /* half of 27, and the block itself */
    const int offsets = touching(drift, offset);
    atomic_long patience = (long)PATIENCE * list->listed;
    atomic_bool harmless = true;

#pragma omp parallel if (waiting_repays(list->listed))
    {
#pragma omp for schedule(static, SHARE)
        for (int k = 0; k < drift->useds; k++)
            if (!find_range(list, cloud, drift->used[k]))
                harmless = false;
#pragma omp for schedule(static, SHARE)
        for (int k = 0; k < drift->useds; k++)
            if (harmless && !complete(list, cloud, drift->used[k], offsets, offset, &patience))
                harmless = false;
    }
    return harmless;
}
