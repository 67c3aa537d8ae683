/* rigid-hull.c -- a rigid body that is the convex hull of points. */
#include "bodies/rigid-figure.h"

#include "base/status.h"
#include "shapes/layers-polytope.h"

#include <string.h>

#if DIM == 3

enum { MOST_FACES = 1000 }; /* a contact looks at all of them */

static int measure(const struct rigid_def *d, const char *path, struct rigid_figure *to)
{
    to->part = status_alloc(1, sizeof *to->part);
    if (!to->part)
        return STATUS_FAILED;
    TRY(polytope_hull((const double (*)[DIM])d->points.x, d->points.n, to->part));
    if (to->part->corners == 0)
        return status_fail(STATUS_BAD_SCENE, "%s: its %d points lie in one plane, or nearly so, and "
                           "have no hull; give four or more that do not", path, d->points.n);
    to->parts = 1;
    if (to->part->faces > MOST_FACES)
        return status_fail(STATUS_BAD_SCENE, "%s: the hull of its %d points has %d faces, and at most %d "
                           "are allowed; leave out points that lie near to others", path, d->points.n,
                           to->part->faces, MOST_FACES);
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

static int cores(const struct rigid_figure *f, double margin, struct core *core)
{
    if (core)
        *core = rigid_figure_core(f, 0, margin);
    return 1;
}

const struct rigid_form rigid_form_hull = { .name = "hull", .keys = " points ", .measure = measure,
                                            .skin = skin, .depth = depth,
                                            .kernels = rigid_figure_kernels, .cores = cores };

#endif
