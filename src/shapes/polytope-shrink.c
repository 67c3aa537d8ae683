/* polytope-shrink.c -- what is left of a polytope below a depth.
 *
 * The half spaces n_i . x <= b_i about a place inside of all have as their common part the dual
 * of the hull of n_i/b_i: a facet m . a = 1 of that hull is a corner m (Preparata, Shamos,
 * Computational Geometry, 1985, 7.3). */
#include "shapes/polytope.h"

#include "base/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double part = 0.9;  /* of the depth of a centre that one step takes      */
static const double thin = 1e-9; /* of its reach: a polytope so thin is none          */
static const double near = 1e-4; /* of the depth: no deeper place is looked for       */

/* How deep its centre is [m]. */
static double centre_depth(const struct polytope *p, double *centre)
{
    struct polytope_moments m;

    polytope_moments(p, &m);
    memcpy(centre, m.centre, sizeof m.centre);
    return polytope_depth(p, centre);
}

/* As its faces say, which are `depth` deeper than those of p; `centre` is in. */
static int cut(const struct polytope *p, double depth, const double *centre, struct polytope *out)
{
    double (*x)[DIM] = status_alloc((size_t)p->faces + 1, sizeof *x);
    struct polytope dual = { .x = NULL };
    int code = x ? STATUS_DONE : STATUS_FAILED;

    *out = (struct polytope){ .x = NULL };
    for (int i = 0; i < p->faces && x; i++) {
        double b = p->face[i].offset - depth;
        for (int d = 0; d < DIM; d++)
            b -= p->face[i].normal[d] * centre[d];
        for (int d = 0; d < DIM; d++)
            x[i][d] = p->face[i].normal[d] / b;
    }
    if (code == STATUS_DONE)
        code = polytope_hull((const double (*)[DIM])x, p->faces, &dual);
    free(x);
    x = code == STATUS_DONE ? status_alloc((size_t)dual.faces + 1, sizeof *x) : NULL;
    for (int i = 0; i < dual.faces && x; i++)
        for (int d = 0; d < DIM; d++)
            x[i][d] = centre[d] + dual.face[i].normal[d] / dual.face[i].offset;
    if (code == STATUS_DONE)
        code = x ? polytope_hull((const double (*)[DIM])x, dual.faces, out) : STATUS_FAILED;
    free(x);
    polytope_free(&dual);
    return code;
}

/* One step towards the deepest place; *done: how deep below p's faces it went. */
static int step(struct polytope *p, double most, double *done)
{
    struct polytope smaller;
    double centre[DIM];
    const double deep = centre_depth(p, centre), reach = polytope_reach(p);

    *done = 0;
    if (!(deep > thin * reach)) {
        polytope_free(p);
        return STATUS_DONE;
    }
    *done = most < deep ? most : part * deep;
    TRY(cut(p, *done, centre, &smaller));
    polytope_free(p);
    *p = smaller;
    return STATUS_DONE;
}

int polytope_shrink(const struct polytope *p, double depth, struct polytope *out)
{
    double done, left = depth;
    int code = polytope_copy(p, out);

    while (code == STATUS_DONE && out->faces > 0 && left > 0) {
        code = step(out, left, &done);
        left = done < left ? left - done : 0;
    }
    if (code != STATUS_DONE)
        polytope_free(out);
    return code;
}

int polytope_deepest(const struct polytope *p, double *depth)
{
    struct polytope left;
    double done;

    *depth = 0;
    TRY(polytope_copy(p, &left));
    while (left.faces > 0) {
        const int code = step(&left, HUGE_VAL, &done);
        if (code != STATUS_DONE) {
            polytope_free(&left);
            return code;
        }
        *depth += done;
        if (done < near * *depth)
            break;
    }
    polytope_free(&left);
    return STATUS_DONE;
}
