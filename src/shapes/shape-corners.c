/* shape-corners.c -- polygons as a kind of shape. */
#include "shapes/shape-kind.h"

#include "shapes/layers-private.h"
#include "shapes/shape-polygon.h"

static int check(struct shape *s, const char *path, const char *where)
{
    return shape_polygon_check(&s->points, path, where);
}

static bool contains(const struct shape *s, const double *x)
{
    return shape_polygon_contains(&s->points, x);
}

static void bounds(const struct shape *s, double *low, double *high)
{
    shape_polygon_bounds(&s->points, low, high);
}

static double depth(const struct shape *s, const double *x)
{
    return shape_polygon_distance(&s->points, x);
}

static double volume(const struct shape *s)
{
    return shape_polygon_area(&s->points);
}

static double surface(const struct shape *s)
{
    return shape_polygon_length(&s->points);
}

static struct shape_rows rows(const struct shape *s, int d, double dx)
{
    double low[2], high[2];

    shape_polygon_bounds(&s->points, low, high);
    return shape_rows_cover(low[d], high[d], dx);
}

static const struct param_points *edges(const struct shape *s)
{
    return &s->points;
}

const struct shape_kind shape_corners = {
    .name = "polygon", .keys = " points ", .check = check, .contains = contains, .depth = depth,
    .bounds = bounds, .volume = volume, .rows = rows, .layers = layers_polygon,
    .surface = surface, .edges = edges,
};
