/* rigid-hull.c -- a rigid body that is the convex hull of points. */
#include "bodies/rigid-figure.h"

#include "base/status.h"
#include "shapes/layers-polytope.h"
#include "shapes/shape-hull.h"

#if DIM == 3

static int measure(const struct rigid_def *d, const char *path, struct rigid_figure *to)
{
    to->part = status_alloc(1, sizeof *to->part);
    if (!to->part)
        return STATUS_FAILED;
    to->parts = 1;
    TRY(shape_hull_make(&d->points, "its shape", path, to->part));
    to->surface = polytope_surface(to->part);
    return rigid_figure_measure(to);
}

static int skin(const struct rigid_figure *f, double spacing, int layers, struct points *to)
{
    return layers_polytope(f->part, spacing, layers, to);
}

static double depth(const struct rigid_figure *f, const double *own)
{
    return polytope_depth(f->part, own);
}

const struct rigid_form rigid_form_hull = { .name = "hull", .keys = " points ", .measure = measure,
                                            .skin = skin, .depth = depth,
                                            .kernels = rigid_figure_kernels, .cores = rigid_figure_cores };

#endif
