/* rigid-compound.c -- a rigid body of several convex parts in space, an L or a T for instance: each of
 * them the hull of as many points, or a box between two corners.
 *
 * Parts stand face to face, so that volumes and second moments are sums.  Contacts see each part
 * by itself; a place of the body is as deep in it as in the part in which it is deepest. */
#include "bodies/rigid-figure.h"

#include "base/status.h"
#include "shapes/layers-polytope.h"
#include "shapes/shape-hull.h"

#include <math.h>
#include <stdio.h>

#if DIM == 3

enum { MOST_PARTS = 100, BOX = 2 };

static const double into = 0.02; /* of its depth that a part may be in another: rounding of a scene */

static int box_part(const double (*x)[3], struct polytope *to)
{
    double corner[8][DIM];

    for (int i = 0; i < 8; i++)
        for (int d = 0; d < DIM; d++)
            corner[i][d] = x[i >> d & 1][d];
    return polytope_hull((const double (*)[DIM])corner, 8, to);
}

static int take_part(const struct rigid_def *d, int i, const char *path, struct polytope *to)
{
    const struct param_points of = { d->corners, d->points.x + (size_t)i * (size_t)d->corners };
    char name[100];

    snprintf(name, sizeof name, "%s, part %d", path, i + 1);
    if (d->corners != BOX)
        return shape_hull_make(&of, "its shape", name, to);
    TRY(box_part((const double (*)[3])of.x, to));
    return to->corners > 0 ? STATUS_DONE
         : status_fail(STATUS_BAD_SCENE, "%s: its two points are no opposite corners of a box, as they lie in one "
                       "plane along the axes; move one of them", name);
}

static int check(const struct rigid_def *d, const char *path)
{
    if (d->points.n % d->corners == 0 && d->points.n / d->corners <= MOST_PARTS)
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "%s: %d points make no whole number of parts of %d corners each, or more "
                       "than %d parts; give each part as many points as corners says (2: a box between two "
                       "opposite corners), the same place twice where a part has fewer", path, d->points.n,
                       d->corners, MOST_PARTS);
}

/* What of a part no other may have. */
static int inner(const struct polytope *part, struct polytope *to)
{
    double deepest;

    TRY(polytope_deepest(part, &deepest));
    return polytope_shrink(part, into * deepest, to);
}

static int refuse_overlap(const struct rigid_figure *f, int i, int k, const char *path)
{
    struct polytope a = { .x = NULL }, b = { .x = NULL };
    double origin[DIM] = { 0 }, R[DIM][DIM] = { { 0 } };
    int code = inner(&f->part[i], &a);

    for (int d = 0; d < DIM; d++)
        R[d][d] = 1;
    if (code == STATUS_DONE)
        code = inner(&f->part[k], &b);
    if (code == STATUS_DONE && core_overlaps(&(struct core){ .hull = &a }, &(struct core){ .hull = &b }, origin, R))
        code = status_fail(STATUS_BAD_SCENE, "%s: its parts %d and %d overlap, and what both have would count twice; "
                           "let them touch with faces", path, i + 1, k + 1);
    polytope_free(&a);
    polytope_free(&b);
    return code;
}

static int measure(const struct rigid_def *d, const char *path, struct rigid_figure *to)
{
    TRY(check(d, path));
    const int parts = d->points.n / d->corners;
    to->part = status_alloc((size_t)parts, sizeof *to->part);
    if (!to->part)
        return STATUS_FAILED;
    for (int i = 0; i < parts; i++) {
        to->parts = i + 1;
        TRY(take_part(d, i, path, &to->part[i]));
        to->surface += polytope_surface(&to->part[i]);
        for (int k = 0; k < i; k++)
            TRY(refuse_overlap(to, i, k, path));
    }
    return rigid_figure_measure(to);
}

static int skin(const struct rigid_figure *f, double spacing, int layers, struct points *to)
{
    for (int i = 0; i < f->parts; i++)
        TRY(layers_polytope(&f->part[i], spacing, layers, to));
    return STATUS_DONE;
}

static double depth(const struct rigid_figure *f, const double *own)
{
    double most = -HUGE_VAL;

    for (int i = 0; i < f->parts; i++)
        most = fmax(most, polytope_depth(&f->part[i], own));
    return most;
}

const struct rigid_form rigid_form_compound = { .name = "compound", .keys = " points ", .may = " corners ",
                                                .measure = measure, .skin = skin, .depth = depth,
                                                .kernels = rigid_figure_kernels,
                                                .cores = rigid_figure_cores };

#endif
