/* layers-merge.c -- where rows of a thin polygon meet: of two points too near to each
 * other one is left, half way, so that a plate that has room for one row gets it in its
 * middle. */
#include "shapes/layers-private.h"

#include "base/status.h"
#include "shapes/buckets.h"
#include <stdlib.h>

static const double apart = 0.65; /* least distance of points of two runs [dx]            */
static const double in_row = 0.5; /* ... in a run, which has 0.525 and more, and its ends */

enum { DROPPED = -1 };

struct merging {
    const struct points *at;
    const struct layers_tag *tag; /* [at->n] */
    double dx;                    /* [m]     */
    struct points *to;
    int *place;                   /* [at->n] where a point is in `to`, or DROPPED */
    bool *moved;                  /* [at->n] */
};

/* What stands in the way of point i: an earlier one that is in `to`. */
struct rival {
    const struct merging *m;
    int i;
};

static bool is_rival(const void *self, int j)
{
    const struct rival *w = self;
    const struct merging *m = w->m;
    const struct layers_tag a = m->tag[w->i], b = m->tag[j];
    const bool own = a.row == b.row && (a.run == b.run || a.run == 0 || b.run == 0);
    const double reach = (own ? in_row : apart) * m->dx;

    return j < w->i && m->place[j] != DROPPED
        && buckets_distance2(m->at->x[j], m->at->x[w->i]) < reach * reach;
}

/* Point j takes the place of i as well.  Corners stay where they are, and so do points
 * that meet a deeper row: the fluid is to find the first row at its depth. */
static void join(const struct merging *m, int i, int j)
{
    double *x = m->to->x[m->place[j]];

    m->place[i] = DROPPED;
    if (m->moved[j] || m->tag[j].run == 0 || m->tag[j].row != m->tag[i].row)
        return;
    m->moved[j] = true;
    for (int d = 0; d < 2; d++)
        x[d] = 0.5 * (m->at->x[i][d] + m->at->x[j][d]);
}

static int merge_all(const struct merging *m, const struct buckets *b)
{
    for (int i = 0; i < m->at->n; i++) {
        const struct rival any = { m, i };
        const int j = buckets_find(b, m->at->x[i], b->width, is_rival, &any);

        m->place[i] = (int)m->to->n;
        if (j >= 0)
            join(m, i, j);
        else
            TRY(points_add(m->to, m->at->x[i]));
    }
    return STATUS_DONE;
}

int layers_merge(const struct points *at, const struct layers_tag *tag, double dx,
                 struct points *to)
{
    struct merging m = { .at = at, .tag = tag, .dx = dx, .to = to };
    struct buckets b;
    int code = STATUS_FAILED;

    m.place = status_alloc(at->n + 1, sizeof *m.place);
    m.moved = status_alloc(at->n + 1, sizeof *m.moved);
    if (m.place && m.moved
        && !buckets_create(&b, (const double (*)[DIM])at->x, (int)at->n, apart * dx)) {
        code = merge_all(&m, &b);
        buckets_free(&b);
    }
    free(m.place);
    free(m.moved);
    return code;
}
