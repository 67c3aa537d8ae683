/* shape-frame.c -- the shell around the domain. */
#include "shapes/shape-kind.h"

#include "base/status.h"
#include <math.h>

static int check(struct shape *s, const char *path, const char *where)
{
    const unsigned all = (1u << 2 * DIM) - 1;

    for (int d = 0; d < DIM; d++)
        if (!(s->low[d] < s->high[d]))
            return status_fail(STATUS_BAD_SCENE, "%s: %s: a frame goes round the domain, but the"
                               " domain reaches from %g m to %g m along %c", where, path,
                               s->low[d], s->high[d], "xyz"[d]);
    if (!(s->thickness > 0 && s->thickness <= SHAPE_REACH))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: a frame %g m thick holds nothing; it needs"
                           " one layer or more", where, path, s->thickness);
    if ((s->open & all) == all)
        return status_fail(STATUS_BAD_SCENE, "%s: %s: every side of this frame is open, nothing is"
                           " left; close a side or leave the wall out", where, path);
    return STATUS_DONE;
}

/* An open side takes with it all that lies beyond its plane, corners included. */
static void bounds(const struct shape *s, double *low, double *high)
{
    for (int d = 0; d < DIM; d++) {
        low[d] = s->low[d] - (s->open & shape_side(d, false) ? 0 : s->thickness);
        high[d] = s->high[d] + (s->open & shape_side(d, true) ? 0 : s->thickness);
    }
    high[DIM - 1] -= s->sunk;
}

static bool contains(const struct shape *s, const double *x)
{
    double low[DIM], high[DIM];

    bounds(s, low, high);
    return shape_between(low, high, x) && !shape_between(s->low, s->high, x);
}

/* Of what it is around, and of its own outer faces. */
static double depth(const struct shape *s, const double *x)
{
    double low[DIM], high[DIM], r2 = 0;

    bounds(s, low, high);
    for (int d = 0; d < DIM; d++) {
        const double out = fmax(0, fmax(s->low[d] - x[d], x[d] - s->high[d]));
        r2 += out * out;
    }
    return fmin(sqrt(r2), shape_to_faces(low, high, x));
}

static double side(const struct shape *s, int d)
{
    return s->high[d] - s->low[d];
}

static double volume(const struct shape *s)
{
    double low[DIM], high[DIM], all = 1, domain = 1;

    bounds(s, low, high);
    for (int d = 0; d < DIM; d++) {
        all *= high[d] - low[d];
        domain *= side(s, d) - (d == DIM - 1 ? s->sunk : 0);
    }
    return all - domain;
}

/* The domain's own lattice, and as many layers of it as the frame has outside. */
static struct shape_rows rows(const struct shape *s, int d, double dx)
{
    struct shape_rows r = shape_rows_spread(s->low[d], s->high[d], dx);
    double low[DIM], high[DIM];
    long before, after;

    bounds(s, low, high);
    shape_rows_fit(s->low[d] - low[d], dx, &before);
    shape_rows_fit(high[d] - s->high[d], dx, &after);
    r.origin -= before * r.pitch;
    r.n += before + after;
    return r;
}

const struct shape_kind shape_frame = {
    .name = "frame", .keys = " ", .domain = true, .check = check, .contains = contains,
    .depth = depth, .bounds = bounds, .volume = volume, .rows = rows, .side = side,
};
