/* reach.h -- how far some particles went, without a question for each.
 *
 *     struct reach r = reach_none();
 *     reach_take(&r, displacement);            of each
 *     if (!reach_within(&r, limit))            one went further, or nowhere, or only the box is too large
 *
 * or, of n from where they were, !reach_all_within(x, was, n, limit).
 */
#ifndef SPACE_REACH_H
#define SPACE_REACH_H

#include "space/coords.h"

#include <math.h>
#include <stdbool.h>

/* Of some displacements the least and the largest along each axis, and the sum of all [m]. */
struct reach {
    coords least, most, sum;
};

static inline struct reach reach_none(void)
{
    static const double nothing[3] = { 0 }, far_off[3] = { INFINITY, INFINITY, INFINITY };
    const coords none = coords_at(nothing), far = coords_at(far_off);

    return (struct reach){ far, less(none, far), none };
}

static inline void reach_take(struct reach *r, coords moved)
{
    r->least = lesser(moved, r->least);
    r->most = larger(moved, r->most);
    r->sum = plus(r->sum, moved);
}

/* Is a displacement made of the largest of all along each axis no longer than the limit, and the sum of
 * all a number? */
static inline bool reach_within(const struct reach *r, double limit)
{
    return length2(larger(less(reach_none().sum, r->least), r->most)) <= limit * limit && length2(r->sum) >= 0;
}

/* x, was: [n][DIM]. */
static inline bool reach_all_within(const double *x, const double *was, int n, double limit)
{
    struct reach r = reach_none();

    for (int i = 0; i < n * DIM; i += DIM)
        reach_take(&r, less(coords_at(x + i), coords_at(was + i)));
    return reach_within(&r, limit);
}

#endif
