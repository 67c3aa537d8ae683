/* drift.c -- displacements compared block by block, and one by one. */
#include "space/drift.h"

#include "space/list-private.h"

#include <math.h>

enum {
    CROWD = 128, /* in a block at most, to be looked at one by one           */
    PATIENCE = 4 /* pairs looked at, per particle                            */
};

/* What stands in a block. */
struct crowd {
    int n;
    double now[CROWD][DIM], was[CROWD][DIM]; /* [m] */
};

static bool at_rest(const struct list *list, const struct cloud *cloud, int kind)
{
    const size_t from = (size_t)list->def.from[kind] * DIM;
    const size_t n = (size_t)list->def.from[kind + 1] * DIM - from;
    const double *built = list->own->built + from;

    for (size_t k = 0; k < n; k++)
        if (cloud->x[kind][k] != built[k] && built[k] < INFINITY)
            return false;
    return true;
}

/* Nothing yet, or only what did not move. */
static void start_ranges(const struct drift *drift, unsigned resting)
{
    for (int k = 0; k < drift->useds; k++) {
        const int b = drift->used[k];
        const double least = drift->kinds[b] & resting ? 0 : INFINITY;
        double *range = drift->range + (size_t)b * 2 * DIM;

        for (int d = 0; d < DIM; d++) {
            range[2 * d] = least;
            range[2 * d + 1] = -least;
        }
    }
}

/* Range of a block and one more displacement in it. */
static void widen_range(const struct drift *drift, int block, const double *x,
                        const double *built)
{
    double *range = drift->range + (size_t)block * 2 * DIM;

    for (int d = 0; d < DIM; d++) {
        const double moved = x[d] - built[d];
        range[2 * d] = moved < range[2 * d] ? moved : range[2 * d];
        range[2 * d + 1] = moved > range[2 * d + 1] ? moved : range[2 * d + 1];
    }
}

/* Those of images are those of their originals. */
static void widen_images(const struct list *list, const struct cloud *cloud, int kind)
{
    const struct drift *drift = &list->own->drift;

    for (int s = list->image[kind]; s < list->image[kind + 1]; s++) {
        const int i = list->order[s];
        widen_range(drift, drift->block[drift_number(list, s)],
                    cloud->x[kind] + (size_t)(i - list->def.from[kind]) * DIM,
                    list->own->built + (size_t)i * DIM);
    }
}

/* False when a particle went too far. */
static bool widen_ranges(const struct list *list, const struct cloud *cloud, int kind)
{
    const struct drift *drift = &list->own->drift;
    const double limit = DRIFT_FARTHEST * list->def.skin;
    const double *x = cloud->x[kind], *built = list->own->built;
    bool near = true;

    for (int i = list->def.from[kind]; i < list->def.from[kind + 1]; i++, x += DIM) {
        if (drift->block[i] < 0)
            continue;
        double *range = drift->range + (size_t)drift->block[i] * 2 * DIM, far = 0;
        for (int d = 0; d < DIM; d++) {
            const double moved = x[d] - built[(size_t)i * DIM + (size_t)d];
            range[2 * d] = moved < range[2 * d] ? moved : range[2 * d];
            range[2 * d + 1] = moved > range[2 * d + 1] ? moved : range[2 * d + 1];
            far += moved * moved;
        }
        near &= far <= limit * limit;
    }
    widen_images(list, cloud, kind);
    return near;
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

    crowd->n = 0;
    for (int m = drift->head[block]; m >= 0; m = drift->next[m], crowd->n++) {
        const int slot = m < list->n ? list->slot[m] : list->image[0] + m - list->n;
        const int i = list->order[slot];
        int kind = 0;

        if (crowd->n == CROWD)
            return false;
        while (i >= list->def.from[kind + 1])
            kind++;
        drift_place(list, slot, cloud->x[kind] + (size_t)(i - list->def.from[kind]) * DIM,
                    crowd->now[crowd->n]);
        drift_place(list, slot, list->own->built + (size_t)i * DIM, crowd->was[crowd->n]);
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
                     const int *offset, long *patience)
{
    const struct drift *drift = &list->own->drift;
    const double limit = list->def.skin * list->def.skin;
    const double *range = drift->range + (size_t)block * 2 * DIM;
    struct crowd here, there;
    bool met = false;

    for (int o = 0; o < offsets; o++) {
        const int other = block + offset[o];

        if (!drift->kinds[other] || apart(range, drift->range + (size_t)other * 2 * DIM) <= limit)
            continue;
        if (!met && !meet(list, cloud, block, &here))
            return false;
        met = true;
        if (!meet(list, cloud, other, &there))
            return false;
        *patience -= (long)here.n * there.n;
        if (*patience < 0 || pair_missing(list, &here, &there))
            return false;
    }
    return true;
}

bool drift_harmless(const struct list *list, const struct cloud *cloud)
{
    const struct drift *drift = &list->own->drift;
    int offset[14]; /* half of 27, and the block itself */
    const int offsets = touching(drift, offset);
    long patience = (long)PATIENCE * list->listed;
    unsigned resting = 0;

    for (int kind = 0; kind < KINDS; kind++)
        resting |= at_rest(list, cloud, kind) ? KIND_BIT(kind) : 0;
    start_ranges(drift, resting);
    for (int kind = 0; kind < KINDS; kind++)
        if (!(resting & KIND_BIT(kind)) && !widen_ranges(list, cloud, kind))
            return false;
    for (int k = 0; k < drift->useds; k++)
        if (!complete(list, cloud, drift->used[k], offsets, offset, &patience))
            return false;
    return true;
}
