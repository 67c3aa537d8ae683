/* shape-polygon.c -- flat polygons: is a point inside, how far from the outline, is it sound. */
#include "shapes/shape-polygon.h"

#include "base/status.h"
#include <math.h>

static const double *corner(const struct param_points *points, int i)
{
    return points->x[i % points->n];
}

/* Twice the area of the triangle a b c, positive when it turns left. */
static double turn(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Positive when the corners go round anticlockwise. */
static double signed_area(const struct param_points *points)
{
    double twice = 0;

    for (int i = 1; i + 1 < points->n; i++)
        twice += turn(points->x[0], points->x[i], points->x[i + 1]);
    return 0.5 * twice;
}

double shape_polygon_area(const struct param_points *points)
{
    return fabs(signed_area(points));
}

double shape_polygon_turning(const struct param_points *points)
{
    return signed_area(points) < 0 ? -1 : 1;
}

void shape_polygon_bounds(const struct param_points *points, double *low, double *high)
{
    for (int d = 0; d < 2; d++) {
        low[d] = high[d] = points->x[0][d];
        for (int i = 1; i < points->n; i++) {
            low[d] = fmin(low[d], points->x[i][d]);
            high[d] = fmax(high[d], points->x[i][d]);
        }
    }
}

/* Does a ray from x to the right cross the edge a b?  The end with the lower
 * second coordinate comes first, so that two polygons with a common edge
 * compute the same crossing, and a point on it is inside exactly one of them. */
static bool ray_crosses(const double *x, const double *a, const double *b)
{
    const double *low = a[1] <= b[1] ? a : b, *high = a[1] <= b[1] ? b : a;

    if (!(low[1] <= x[1] && x[1] < high[1]))
        return false;
    return x[0] < low[0] + (x[1] - low[1]) / (high[1] - low[1]) * (high[0] - low[0]);
}

bool shape_polygon_contains(const struct param_points *points, const double *x)
{
    bool inside = false;

    for (int i = 0; i < points->n; i++)
        if (ray_crosses(x, corner(points, i), corner(points, i + 1)))
            inside = !inside;
    return inside;
}

double shape_polygon_length(const struct param_points *points)
{
    double sum = 0;

    for (int i = 0; i < points->n; i++) {
        const double *a = corner(points, i), *b = corner(points, i + 1);

        sum += hypot(b[0] - a[0], b[1] - a[1]);
    }
    return sum;
}

static double distance_to_edge(const double *x, const double *a, const double *b)
{
    const double e[2] = { b[0] - a[0], b[1] - a[1] }, r[2] = { x[0] - a[0], x[1] - a[1] };
    const double along = (r[0] * e[0] + r[1] * e[1]) / (e[0] * e[0] + e[1] * e[1]);
    const double part = fmin(fmax(along, 0), 1);

    return hypot(r[0] - part * e[0], r[1] - part * e[1]);
}

double shape_polygon_distance(const struct param_points *points, const double *x)
{
    double least = HUGE_VAL;

    for (int i = 0; i < points->n; i++)
        least = fmin(least, distance_to_edge(x, corner(points, i), corner(points, i + 1)));
    return least;
}

/* Is c, known to lie on the line through a and b, between them? */
static bool between(const double *a, const double *b, const double *c)
{
    return fmin(a[0], b[0]) <= c[0] && c[0] <= fmax(a[0], b[0])
        && fmin(a[1], b[1]) <= c[1] && c[1] <= fmax(a[1], b[1]);
}

/* Have the edges a b and c d a point in common? */
static bool edges_meet(const double *a, const double *b, const double *c, const double *d)
{
    const double ac = turn(a, b, c), ad = turn(a, b, d);
    const double ca = turn(c, d, a), cb = turn(c, d, b);

    if (((ac > 0 && ad < 0) || (ac < 0 && ad > 0)) && ((ca > 0 && cb < 0) || (ca < 0 && cb > 0)))
        return true;
    return (ac == 0 && between(a, b, c)) || (ad == 0 && between(a, b, d))
        || (ca == 0 && between(c, d, a)) || (cb == 0 && between(c, d, b));
}

static int check_corners(const struct param_points *points, const char *path, const char *where)
{
    const int n = points->n;

    for (int i = 0; i < n; i++) {
        const double *a = corner(points, i), *b = corner(points, i + 1);

        if (!isfinite(a[0]) || !isfinite(a[1]))
            return status_fail(STATUS_BAD_SCENE, "%s: %s: corner %d of points is not a number",
                               where, path, i + 1);
        if (a[0] == b[0] && a[1] == b[1])
            return status_fail(STATUS_BAD_SCENE, "%s: %s: corners %d and %d of points are both"
                               " (%g, %g); leave one out, the polygon closes itself", where, path,
                               i + 1, (i + 1) % n + 1, a[0], a[1]);
    }
    return STATUS_DONE;
}

static int check_edges(const struct param_points *points, const char *path, const char *where)
{
    const int n = points->n;

    for (int i = 0; i < n; i++)
        for (int k = i + 2; k < n && k < i + n - 1; k++)
            if (edges_meet(corner(points, i), corner(points, i + 1),
                           corner(points, k), corner(points, k + 1)))
                return status_fail(STATUS_BAD_SCENE, "%s: %s: the edge from corner %d to %d crosses"
                                   " or touches the edge from corner %d to %d; points must go"
                                   " round the shape in turn", where, path, i + 1, i + 2, k + 1,
                                   (k + 1) % n + 1);
    return STATUS_DONE;
}

int shape_polygon_check(const struct param_points *points, const char *path,
                        const char *where)
{
    double low[2], high[2];

    if (points->n < 3)
        return status_fail(STATUS_BAD_SCENE, "%s: %s: a polygon needs points, three corners or"
                           " more; %d given", where, path, points->n);
    TRY(check_corners(points, path, where));
    TRY(check_edges(points, path, where));
    shape_polygon_bounds(points, low, high);
    if (!(shape_polygon_area(points) > 1e-12 * (high[0] - low[0]) * (high[1] - low[1])))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: the points of this polygon enclose no area",
                           where, path);
    return STATUS_DONE;
}
