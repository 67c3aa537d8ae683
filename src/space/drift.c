/* drift.c -- displacements compared block by block, and one by one. */
#include "space/drift.h"

#include "base/threads.h"
#include "base/waiting.h"
#include "space/list-private.h"

#include <math.h>
#include <stdatomic.h>

enum {
    CROWD = 128, /* in a block at most, to be looked at one by one           */
    PATIENCE = 4, /* pairs looked at, per particle                           */
    SHARE = 16   /* blocks that a thread takes at a time                     */
};

/* Of a block, those that may have come near to one of another. */
struct crowd {
    int n;
    double now[CROWD][DIM], was[CROWD][DIM]; /* [m] */
};

/* Positions of the particles in rows one after the other: rows of a kind mostly follow rows
 * of the same. */
struct positions {
    const struct list *list;
    const struct cloud *cloud;
    int kind;
};

static inline const double *position(struct positions *of, int row)
{
    const int *from = of->list->def.from;

    while (row >= from[of->kind + 1])
        of->kind++;
    while (row < from[of->kind])
        of->kind--;
    return of->cloud->x[of->kind] + (size_t)(row - from[of->kind]) * DIM;
}

/* Of some particles: least and largest displacement [m]. */
struct reach {
    double least[DIM], most[DIM];
    bool good; /* none is nowhere, nor too far */
};

static inline void take_one(struct reach *r, const double *x, const double *was, double most2)
{
    double far = 0;

    for (int d = 0; d < DIM; d++) {
        const double moved = x[d] - was[d];
        r->least[d] = moved < r->least[d] ? moved : r->least[d];
        r->most[d] = moved > r->most[d] ? moved : r->most[d];
        far += moved * moved;
    }
    r->good &= far <= most2;
}

/* The range of displacements in a block; false when a particle went too far, or nowhere.
 * Images go where their originals do. */
static bool find_range(const struct list *list, const struct cloud *cloud, int block)
{
    const struct drift *drift = &list->own->drift;
    const double limit = DRIFT_FARTHEST * list->def.skin, most2 = limit * limit;
    const int end = drift->end[block], from = end - drift->count[block];
    const int *row = drift->row;
    const double *x = cloud->x[0], (*was)[DIM] = (const double (*)[DIM])drift->was;
    double *range = drift->range + (size_t)block * 2 * DIM;
    struct positions others = { list, cloud, 0 };
    struct reach r = { .good = true };
    int m = from;

    for (int d = 0; d < DIM; d++) {
        r.least[d] = INFINITY;
        r.most[d] = -INFINITY;
    }
    for (; m < from + drift->first[block]; m++)
        take_one(&r, x + (size_t)row[m] * DIM, was[m], most2);
    for (; m < end; m++)
        take_one(&r, position(&others, row[m]), was[m], most2);
    for (int d = 0; d < DIM; d++) {
        range[2 * d] = r.least[d];
        range[2 * d + 1] = r.most[d];
    }
    return r.good;
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

/* The largest displacement against one of a block with this range, squared [m^2]. */
static inline double apart_of(const double *moved, const double *range)
{
    double far = 0;

    for (int d = 0; d < DIM; d++) {
        const double one = moved[d] - range[2 * d], other = range[2 * d + 1] - moved[d];
        const double most = one > other ? one : other;
        far += most * most;
    }
    return far;
}

/* Those of a block that moved against one of a block with this range by the margin, but for
 * roundings: no pair of others can be missing.  False when the block has too many. */
static bool meet(const struct list *list, const struct cloud *cloud, int block,
                 const double *range, struct crowd *crowd)
{
    const struct drift *drift = &list->own->drift;
    const double limit = list->def.skin * list->def.skin * (1 - 1e-6);
    const int end = drift->end[block];
    struct positions all = { list, cloud, 0 };

    crowd->n = 0;
    if (drift->count[block] > CROWD)
        return false;
    for (int m = end - drift->count[block]; m < end; m++) {
        const double *x = position(&all, drift->row[m]);
        double moved[DIM];

        for (int d = 0; d < DIM; d++)
            moved[d] = x[d] - drift->was[m][d];
        if (apart_of(moved, range) < limit)
            continue;
        drift_place(list, drift->member[m], x, crowd->now[crowd->n]);
        drift_place(list, drift->member[m], drift->was[m], crowd->was[crowd->n++]);
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

    for (int o = 0; o < offsets; o++) {
        const int other = block + offset[o];
        const double *others = drift->range + (size_t)other * 2 * DIM;

        if (drift->count[other] == 0 || apart(range, others) <= limit)
            continue;
        if (!meet(list, cloud, block, others, &here) || !meet(list, cloud, other, range, &there))
            return false;
        const long pairs = (long)drift->count[block] * drift->count[other];
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
#pragma omp for schedule(static, SHARE) nowait
        for (int k = 0; k < drift->useds; k++)
            if (!find_range(list, cloud, drift->used[k]))
                harmless = false;
        threads_meet();
#pragma omp for schedule(static, SHARE) nowait
        for (int k = 0; k < drift->useds; k++)
            if (harmless && !complete(list, cloud, drift->used[k], offsets, offset, &patience))
                harmless = false;
    }
    return harmless;
}
