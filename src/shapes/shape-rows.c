/* shape-rows.c -- rows of sites along an axis of a shape. */
#include "shapes/shape-rows.h"

#include <math.h>

static const double most = 1e15; /* sites along an axis: beyond all memory, below LONG_MAX */

bool shape_rows_fit(double side, double dx, long *n)
{
    const double count = side / dx;

    *n = lrint(fmin(count, most));
    return fabs(count - *n) <= 1e-6 * *n;
}

struct shape_rows shape_rows_spread(double low, double high, double dx)
{
    struct shape_rows r = { .origin = low };

    shape_rows_fit(high - low, dx, &r.n);
    r.pitch = r.n > 0 ? (high - low) / r.n : dx;
    return r;
}

struct shape_rows shape_rows_cover(double low, double high, double dx)
{
    struct shape_rows r = shape_rows_spread(low, high, dx);

    if (shape_rows_fit(high - low, dx, &r.n))
        return r;
    r.pitch = dx;
    r.n = lrint(fmin(ceil((high - low) / dx), most));
    return r;
}

struct shape_rows shape_rows_centre(double low, double high, double middle, double dx)
{
    struct shape_rows r = { .pitch = dx };

    shape_rows_fit(high - low, dx, &r.n);
    r.origin = middle - 0.5 * r.n * dx;
    return r;
}
