/* polygon-parts.c -- a polygon with dents as convex ones: triangles by clipping ears, made one
 * again as long as they stay convex. */
#include "shapes/polygon-parts.h"

#include "base/status.h"
#include "shapes/shape-polygon.h"

#include <stdlib.h>
#include <string.h>

struct cut {
    const struct param_points *points;
    int pieces;
    int *corners; /* [n] of each piece                        */
    int *corner;  /* [n][n] its corners in turn, anticlockwise */
    int *merged;  /* [n] scratch                              */
};

static double turn(const struct cut *c, int i, int j, int k)
{
    const double *x = c->points->x[i], *y = c->points->x[j], *z = c->points->x[k];

    return (y[0] - x[0]) * (z[1] - x[1]) - (y[1] - x[1]) * (z[0] - x[0]);
}

static int *piece(const struct cut *c, int i)
{
    return c->corner + (size_t)i * (size_t)c->points->n;
}

static bool is_in(const struct cut *c, int i, int j, int k, int at)
{
    return turn(c, i, j, at) >= 0 && turn(c, j, k, at) >= 0 && turn(c, k, i, at) >= 0;
}

/* May corner k of what is left be cut off? */
static bool is_ear(const struct cut *c, const int *left, int n, int k)
{
    const int a = left[(k + n - 1) % n], b = left[k], d = left[(k + 1) % n];

    if (!(turn(c, a, b, d) > 0))
        return false;
    for (int i = 0; i < n; i++)
        if (left[i] != a && left[i] != b && left[i] != d && is_in(c, a, b, d, left[i]))
            return false;
    return true;
}

/* A corner on a straight line is no part of any triangle; the ear beside it has it on its side. */
static bool is_straight(const struct cut *c, const int *left, int n, int k)
{
    return turn(c, left[(k + n - 1) % n], left[k], left[(k + 1) % n]) == 0;
}

static void drop(int *left, int *n, int k)
{
    memmove(left + k, left + k + 1, (size_t)(*n - k - 1) * sizeof *left);
    --*n;
}

/* What is left is in `merged`; where rounding leaves no ear, a corner that turns left goes. */
static void clip_ears(struct cut *c, int n)
{
    int *left = c->merged;

    while (n > 2) {
        int k = 0;
        while (k < n && !is_straight(c, left, n, k) && !is_ear(c, left, n, k))
            k++;
        k %= n;
        if (!is_straight(c, left, n, k)) {
            int *to = piece(c, c->pieces);
            to[0] = left[(k + n - 1) % n];
            to[1] = left[k];
            to[2] = left[(k + 1) % n];
            c->corners[c->pieces++] = 3;
        }
        drop(left, &n, k);
    }
}

/* The piece of both, where edge i of a is an edge of b, in `merged`; its corners, 0: none. */
static int join(const struct cut *c, int a, int b, int i)
{
    const int *p = piece(c, a), *q = piece(c, b), n = c->corners[a], m = c->corners[b];
    int k = 0, all = 0;

    while (k < m && !(q[k] == p[(i + 1) % n] && q[(k + 1) % m] == p[i]))
        k++;
    for (int j = 0; j < n && k < m; j++)
        c->merged[all++] = p[(i + 1 + j) % n];
    for (int j = 2; j < m && k < m; j++)
        c->merged[all++] = q[(k + j) % m];
    return all;
}

static bool is_convex(const struct cut *c, const int *corner, int n)
{
    bool convex = n > 2;

    for (int i = 0; i < n && convex; i++)
        convex = turn(c, corner[i], corner[(i + 1) % n], corner[(i + 2) % n]) >= 0;
    return convex;
}

/* Makes one of piece a and another, if any two are a convex one. */
static bool merge(struct cut *c, int a)
{
    for (int b = a + 1; b < c->pieces; b++)
        for (int i = 0; i < c->corners[a]; i++) {
            const int n = join(c, a, b, i), last = c->pieces - 1;
            if (!is_convex(c, c->merged, n))
                continue;
            memcpy(piece(c, a), c->merged, (size_t)n * sizeof *c->merged);
            c->corners[a] = n;
            memmove(piece(c, b), piece(c, last), (size_t)c->corners[last] * sizeof *c->merged);
            c->corners[b] = c->corners[last];
            c->pieces--;
            return true;
        }
    return false;
}

static int make_parts(const struct cut *c, struct polytope *part, int *parts)
{
    double (*x)[DIM] = status_alloc((size_t)c->points->n, sizeof *x);
    int code = x ? STATUS_DONE : STATUS_FAILED;

    for (int i = 0; i < c->pieces && code == STATUS_DONE; i++) {
        for (int k = 0; k < c->corners[i]; k++)
            memcpy(x[k], c->points->x[piece(c, i)[k]], 2 * sizeof **x);
        code = polytope_hull((const double (*)[DIM])x, c->corners[i], &part[*parts]);
        *parts += code == STATUS_DONE && part[*parts].corners > 0;
    }
    free(x);
    return code;
}

int polygon_parts(const struct param_points *points, struct polytope *part, int *parts)
{
    const size_t n = (size_t)points->n;
    struct cut c = { .points = points, .corners = status_alloc(n, sizeof *c.corners),
                     .corner = status_alloc(n * n, sizeof *c.corner),
                     .merged = status_alloc(2 * n, sizeof *c.merged) };
    int code = STATUS_FAILED;

    *parts = 0;
    if (c.corners && c.corner && c.merged) {
        for (int i = 0; i < points->n; i++)
            c.merged[i] = shape_polygon_turning(points) > 0 ? i : points->n - 1 - i;
        clip_ears(&c, points->n);
        for (int a = 0; a < c.pieces; a++)
            while (merge(&c, a))
                continue;
        code = make_parts(&c, part, parts);
    }
    free(c.corners);
    free(c.corner);
    free(c.merged);
    return code;
}
