/* layers.c -- particles in layers that follow the outline of a wall: its kind lays them.
 *
 * A wall has one value of mass, rho0 dx^D: a layer at the depth d has about as many
 * points as its length (its area) has spacings, so that layer by layer the wall is as
 * dense as the fluid, up to the rounding to whole numbers. */
#include "shapes/layers.h"

#include "base/status.h"
#include "shapes/buckets.h"
#include "shapes/shape-kind.h"
#include <math.h>
#include <string.h>

static const double cover = 1.6; /* an outline further from all points is bare [dx] */

bool layers_wanted(const struct shape *s)
{
    return shape_kind(s)->layers && !(s->fill && strcmp(s->fill, "lattice") == 0);
}

static long count(const struct shape *s, double dx)
{
    return s->thickness > 0 ? lrint(fmin(fmax(s->thickness / dx, 1), 1e9)) : 1000000000;
}

int layers_fill(const struct shape *s, double dx, struct points *to)
{
    return shape_kind(s)->layers(s, dx, count(s, dx), to);
}

double layers_estimate(const struct shape *s, double dx)
{
    const struct shape_kind *kind = shape_kind(s);
    const double cell = pow(dx, DIM), border = kind->surface(s) * dx / cell;
    const double tips = kind->edges ? border : 0; /* too thin for their points */

    return fmin(kind->volume(s) / cell + tips, border * count(s, dx));
}

static bool is_bare(const struct param_points *points, double dx, const struct buckets *b,
                    double *x)
{
    for (int i = 0; i < points->n; i++) {
        const double *from = points->x[i], *to = points->x[(i + 1) % points->n];
        const long steps = layers_steps(2 * hypot(to[0] - from[0], to[1] - from[1]), dx);

        for (long k = 0; k < steps; k++) {
            for (int d = 0; d < 2; d++)
                x[d] = from[d] + (to[d] - from[d]) * k / steps;
            if (buckets_find(b, x, cover * dx, NULL, NULL) < 0)
                return true;
        }
    }
    return false;
}

int layers_bare(const struct shape *s, double dx, const struct points *p, double *x, bool *bare)
{
    const struct shape_kind *kind = shape_kind(s);
    struct buckets b;

    *bare = false;
    if (!kind->edges)
        return STATUS_DONE;
    TRY(buckets_create(&b, (const double (*)[DIM])p->x, (int)p->n, cover * dx));
    *bare = is_bare(kind->edges(s), dx, &b, x);
    buckets_free(&b);
    return STATUS_DONE;
}
