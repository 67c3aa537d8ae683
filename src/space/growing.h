/* growing.h -- a box that grows around particles, and how many they are. */
#ifndef SPACE_GROWING_H
#define SPACE_GROWING_H

#include "space/coords.h"

#include <math.h>

struct growing {
    coords low, high; /* [m]                                                 */
    double n;
};

static inline struct growing growing_none(void)
{
    static const double far_off[3] = { INFINITY, INFINITY, INFINITY }, nothing[3] = { 0 };
    const coords far = coords_at(far_off);

    return (struct growing){ far, less(coords_at(nothing), far), 0 };
}

/* One that is at x. */
static inline void growing_take(struct growing *b, coords x)
{
    b->low = lesser(x, b->low);
    b->high = larger(x, b->high);
    b->n++;
}

static inline void growing_join(struct growing *b, const struct growing *other)
{
    b->low = lesser(other->low, b->low);
    b->high = larger(other->high, b->high);
    b->n += other->n;
}

#endif
