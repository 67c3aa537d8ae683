/* shape-hull.c -- convex hulls of points (3D), and their layers. */
#include "shapes/shape-hull.h"

#include "base/status.h"
#include "shapes/layers-polytope.h"
#include "shapes/shape-kind.h"

#include <math.h>

#if DIM == 3

enum { MOST_FACES = 1000 }; /* a site or a contact looks at all of them */

int shape_hull_make(const struct param_points *points, const char *path, const char *where,
                    struct polytope *out)
{
    for (int i = 0; i < points->n; i++)
        if (!shape_is_place(points->x[i]))
            return status_fail(STATUS_BAD_SCENE, "%s: %s: point %d of points is no place", where, path,
                               i + 1);
    if (points->n < 4)
        return status_fail(STATUS_BAD_SCENE, "%s: %s: a hull needs points, four or more; %d given", where,
                           path, points->n);
    TRY(polytope_hull((const double (*)[DIM])points->x, points->n, out));
    if (out->corners == 0)
        return status_fail(STATUS_BAD_SCENE, "%s: %s: its %d points lie in one plane, or nearly so, and "
                           "have no hull; give four or more that do not", where, path, points->n);
    if (out->faces > MOST_FACES)
        return status_fail(STATUS_BAD_SCENE, "%s: %s: the hull of its %d points has %d faces, and at most "
                           "%d are allowed; leave out points that lie near to others", where, path,
                           points->n, out->faces, MOST_FACES);
    return STATUS_DONE;
}

static int check(struct shape *s, const char *path, const char *where)
{
    s->hull = status_alloc(1, sizeof *s->hull);
    if (!s->hull)
        return STATUS_FAILED;
    return shape_hull_make(&s->points, path, where, s->hull);
}

/* Of a face that two shapes share, a point is in the one that lies on its upper side. */
static bool points_up(const double *normal)
{
    for (int d = 0; d < DIM; d++)
        if (normal[d] != 0)
            return normal[d] > 0;
    return false;
}

static bool contains(const struct shape *s, const double *x)
{
    for (int i = 0; i < s->hull->faces; i++) {
        const struct polytope_face *f = &s->hull->face[i];
        double over = -f->offset;

        for (int d = 0; d < DIM; d++)
            over += f->normal[d] * x[d];
        if (over > 0 || (over == 0 && points_up(f->normal)))
            return false;
    }
    return true;
}

static double depth(const struct shape *s, const double *x)
{
    return fmax(0, polytope_depth(s->hull, x));
}

static void bounds(const struct shape *s, double *low, double *high)
{
    for (int d = 0; d < DIM; d++) {
        low[d] = HUGE_VAL;
        high[d] = -HUGE_VAL;
    }
    for (int i = 0; i < s->hull->corners; i++)
        for (int d = 0; d < DIM; d++) {
            low[d] = fmin(low[d], s->hull->x[i][d]);
            high[d] = fmax(high[d], s->hull->x[i][d]);
        }
}

static double volume(const struct shape *s)
{
    struct polytope_moments m;

    polytope_moments(s->hull, &m);
    return m.volume;
}

static double surface(const struct shape *s)
{
    return polytope_surface(s->hull);
}

static struct shape_rows rows(const struct shape *s, int d, double dx)
{
    double low[DIM], high[DIM];

    bounds(s, low, high);
    return shape_rows_cover(low[d], high[d], dx);
}

static int fill(const struct shape *s, double dx, long layers, struct points *to)
{
    return layers_polytope(s->hull, dx, layers, to);
}

const struct shape_kind shape_hull = {
    .name = "hull", .keys = " points ", .check = check, .contains = contains, .depth = depth,
    .bounds = bounds, .volume = volume, .rows = rows, .layers = fill, .surface = surface,
};

#endif
