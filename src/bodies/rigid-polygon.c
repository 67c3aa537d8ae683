/* rigid-polygon.c -- a rigid body that is a polygon, with dents or without: contacts see the
 * convex parts of it. */
#include "bodies/rigid-figure.h"

#include "base/status.h"
#include "shapes/layers.h"
#include "shapes/polygon-parts.h"
#include "shapes/shape-polygon.h"

#include <stdlib.h>
#include <string.h>

#if DIM == 2

enum { MOST_CORNERS = 1000 }; /* cutting it up takes their square */

static int take(const struct param_points *points, struct rigid_figure *to)
{
    const int n = points->n;
    const bool back = shape_polygon_turning(points) < 0;

    to->outline.x = status_alloc((size_t)n, sizeof *to->outline.x);
    to->part = status_alloc((size_t)n, sizeof *to->part);
    if (!to->outline.x || !to->part)
        return STATUS_FAILED;
    to->outline.n = n;
    for (int i = 0; i < n; i++)
        memcpy(to->outline.x[i], points->x[back ? n - 1 - i : i], sizeof *points->x);
    return polygon_parts(points, to->part, &to->parts);
}

static int measure(const struct rigid_def *d, const char *path, struct rigid_figure *to)
{
    TRY(shape_polygon_check(&d->points, "its shape", path));
    if (d->points.n > MOST_CORNERS)
        return status_fail(STATUS_BAD_SCENE, "%s: a polygon that bodies touch may have %d corners, and it "
                           "has %d; leave out those that lie near to others, or make it of several", path,
                           MOST_CORNERS, d->points.n);
    TRY(take(&d->points, to));
    to->surface = shape_polygon_length(&d->points);
    return rigid_figure_measure(to);
}

static int skin(const struct rigid_figure *f, double spacing, int layers, struct points *to)
{
    const struct shape s = { .type = "polygon", .kind = SHAPE_POLYGON, .points = f->outline,
                             .thickness = layers * spacing };

    return layers_fill(&s, spacing, to);
}

static double depth(const struct rigid_figure *f, const double *own)
{
    const double away = shape_polygon_distance(&f->outline, own);

    return shape_polygon_contains(&f->outline, own) ? away : -away;
}

/* With its dents, which no convex part knows. */
static int surface(const struct rigid_figure *f, struct surface *to)
{
    const int n = f->outline.n;
    int *corner = status_alloc((size_t)n, sizeof *corner), code = corner ? STATUS_DONE : STATUS_FAILED;

    for (int i = 0; code == STATUS_DONE && i < n; i++) {
        corner[i] = to->corners;
        code = surface_corner(to, f->outline.x[i]);
    }
    if (code == STATUS_DONE)
        code = surface_face(to, corner, n);
    free(corner);
    return code;
}

const struct rigid_form rigid_form_polygon = { .name = "polygon", .keys = " points ",
                                               .measure = measure, .skin = skin, .depth = depth,
                                               .kernels = rigid_figure_kernels,
                                               .cores = rigid_figure_cores, .surface = surface };

#endif
