/* drift.c -- displacements compared block by block, and one by one. */
#include "space/drift.h"

#include "base/threads.h"
#include "base/waiting.h"
#include "space/list-private.h"
#include "space/reach.h"

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
    const double *x = of->kind == 0 && is_beyond(&of->cloud->beyond, row) ? of->cloud->beyond.x
                                                                           : of->cloud->x[of->kind];
    return x + (size_t)(row - from[of->kind]) * DIM;
}

static inline void take_one(struct reach *r, const double *x, const double *was)
{
    reach_take(r, less(coords_at(x), coords_at(was)));
}

/* Of n members of the first kind.  `some`, a constant: some rows stand beyond. */
static inline void take_first(const struct cloud *cloud, bool some, const int *row, const double (*was)[DIM],
                              int n, struct reach *r)
{
    for (int m = 0; m < n; m++)
        take_one(r, (some && row[m] >= cloud->beyond.from ? cloud->beyond.x : cloud->x[0])
                        + (size_t)row[m] * DIM, was[m]);
}

/* Of one by one, seldom asked: did any go too far, or nowhere? */
static enum drift_harm look_closer(const struct list *list, const struct cloud *cloud, int block)
{
    const struct drift *drift = &list->own->drift;
    const double limit = DRIFT_FARTHEST * list->def.skin;
    struct positions all = { list, cloud, 0 };
    double most = 0, all_of = 0;

    for (int m = drift->end[block] - drift->count[block]; m < drift->end[block]; m++) {
        const double far = length2(less(coords_at(position(&all, drift->row[m])), coords_at(drift->was[m])));
        most = fmax(most, far);
        all_of += far; /* no number where one is none */
    }
    return !isfinite(all_of) ? DRIFT_NOWHERE : most <= limit * limit ? DRIFT_NONE : DRIFT_MISSING;
}

/* The range of displacements in a block, and whether a particle went too far, or nowhere.
 * Images go where their originals do.  Only where all together are not within the limit need each be
 * asked. */
static enum drift_harm find_range(const struct list *list, const struct cloud *cloud, int block)
{
    const struct drift *drift = &list->own->drift;
    const double limit = DRIFT_FARTHEST * list->def.skin;
    const int from = drift->end[block] - drift->count[block];
    const int *row = drift->row;
    const double (*was)[DIM] = (const double (*)[DIM])drift->was;
    double *range = drift->range + (size_t)block * 2 * DIM;
    struct positions others = { list, cloud, 0 };
    struct reach r = reach_none();

    if (drift->moving[block] < drift->count[block]) /* others stand still */
        r.least = r.most = r.sum;
    if (cloud->beyond.x && drift->thread[block] & DRIFT_HAS)
        take_first(cloud, true, row + from, was + from, drift->first[block], &r);
    else
        take_first(cloud, false, row + from, was + from, drift->first[block], &r);
    for (int m = from + drift->first[block]; m < from + drift->moving[block]; m++)
        take_one(&r, position(&others, row[m]), was[m]);
    coords_put(r.least, range);
    coords_put(r.most, range + DIM);
    return reach_within(&r, limit) ? DRIFT_NONE : look_closer(list, cloud, block);
}

/* The largest displacement of one within the first range against one within the other,
 * squared [m^2]. */
static inline double apart(const double *a, const double *b)
{
    const coords one = less(coords_at(a + DIM), coords_at(b));
    const coords other = less(coords_at(b + DIM), coords_at(a));

    return length2(larger(one, other));
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
        const coords moved = less(coords_at(x), coords_at(drift->was[m]));
        double its[2 * DIM]; /* a range of one */

        coords_put(moved, its);
        coords_put(moved, its + DIM);
        if (apart(its, range) < limit)
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

/* What the threads look at together. */
struct search {
    const struct list *list;
    const struct cloud *cloud;
    int offset[DRIFT_TOUCHING];
    int offsets;
    atomic_long patience;
    _Atomic(enum drift_harm) harm;
};

/* No pair missing between a block and those that touch it; looks at pairs one by
 * one as long as patience lasts. */
static bool complete(struct search *s, int block)
{
    const struct list *list = s->list;
    const struct drift *drift = &list->own->drift;
    const double limit = list->def.skin * list->def.skin;
    const double *range = drift->range + (size_t)block * 2 * DIM;
    struct crowd here, there;

    for (int o = 0; o < s->offsets; o++) {
        const int other = block + s->offset[o];
        const double *others = drift->range + (size_t)other * 2 * DIM;

        if (drift->count[other] == 0 || apart(range, others) <= limit)
            continue;
        if (!meet(list, s->cloud, block, others, &here)
            || !meet(list, s->cloud, other, range, &there))
            return false;
        const long pairs = (long)drift->count[block] * drift->count[other];
        if (atomic_fetch_sub(&s->patience, pairs) < pairs || pair_missing(list, &here, &there))
            return false;
    }
    return true;
}

/* The worst that any thread finds. */
static void tell(struct search *s, enum drift_harm harm)
{
    for (enum drift_harm old = s->harm; harm > old;)
        if (atomic_compare_exchange_weak(&s->harm, &old, harm))
            break;
}

static void look(struct search *s)
{
    const struct drift *drift = &s->list->own->drift;

#pragma omp for schedule(static, SHARE) nowait
    for (int k = 0; k < drift->useds; k++)
        if (drift->moving[drift->used[k]] > 0)
            tell(s, find_range(s->list, s->cloud, drift->used[k]));
    threads_meet();
#pragma omp for schedule(static, SHARE) nowait
    for (int k = 0; k < drift->mines; k++)
        if (s->harm == DRIFT_NONE && !complete(s, drift->used[k]))
            tell(s, DRIFT_MISSING);
}

double drift_patience(const struct list *list)
{
    return PATIENCE * list_known(list);
}

/* Nothing depends on who finds it: patience is a sum, and one that finds harm is enough. */
static enum drift_harm find(const struct list *list, const struct cloud *cloud, double *pairs)
{
    const long patience = (long)drift_patience(list);
    struct search s = { .list = list, .cloud = cloud, .patience = patience, .harm = DRIFT_NONE };

    s.offsets = drift_touching(&list->own->drift, s.offset);
    THREADS(waiting_repays(list->listed), look(&s));
    *pairs += (double)(patience - s.patience);
    return s.harm;
}

bool drift_harmless(const struct list *list, const struct cloud *cloud)
{
    double pairs = 0;

    return find(list, cloud, &pairs) == DRIFT_NONE;
}

enum drift_harm drift_harms(const struct list *list, const struct cloud *cloud, double *pairs)
{
    return list->listed > 0 ? find(list, cloud, pairs) : DRIFT_NONE;
}
