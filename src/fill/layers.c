/* layers.c -- particles in layers that follow the outline of a wall: rings of a disc,
 * shells of a sphere; polygons are in layers-polygon.c.
 *
 * A wall has one value of mass, rho0 dx^D: a layer at the depth d has about as many
 * points as its length (its area) has spacings, so that layer by layer the wall is as
 * dense as the fluid, up to the rounding to whole numbers. */
#include "fill/layers-private.h"

#include "base/status.h"
#include "shapes/shape-polygon.h"
#include "fill/buckets.h"
#include <math.h>
#include <string.h>

static const double core = 0.4;  /* a ring smaller than this is one point [dx]     */
static const double cover = 1.6; /* an outline further from all points is bare [dx] */

bool layers_wanted(const struct shape *s)
{
    return s->kind != SHAPE_BOX && s->kind != SHAPE_FRAME
        && !(s->fill && strcmp(s->fill, "lattice") == 0);
}

static long count(const struct shape *s, double dx)
{
    return s->thickness > 0 ? lrint(fmin(fmax(s->thickness / dx, 1), 1e9)) : 1000000000;
}

/* A circle about the vertical through the centre of s, `up` above it. */
static int add_ring(const struct shape *s, double radius, double up, double dx,
                    struct points *to)
{
    const long n = layers_steps(2 * M_PI * radius, dx);

    TRY(points_reserve(to, n));
    for (long i = 0; i < n; i++) {
        const double angle = 2 * M_PI * i / n;
        double *x = to->x[to->n++];

        memcpy(x, s->centre, sizeof to->x[0]);
        x[0] += radius * cos(angle);
        x[1] += radius * sin(angle);
        x[DIM - 1] += up;
    }
    return STATUS_DONE;
}

/* A sphere as circles of latitude, a spacing apart. */
static int add_shell(const struct shape *s, double radius, double dx, struct points *to)
{
    const long n = layers_steps(M_PI * radius, dx);

    for (long i = 0; i < n; i++) {
        const double angle = M_PI * (i + 0.5) / n;

        TRY(add_ring(s, radius * sin(angle), radius * cos(angle), dx, to));
    }
    return STATUS_DONE;
}

static int fill_ball(const struct shape *s, double dx, long layers, struct points *to)
{
    for (long k = 0; k < layers; k++) {
        const double radius = s->radius - (k + 0.5) * dx;

        if (radius <= -core * dx)
            break;
        if (radius < core * dx)
            return points_add(to, s->centre);
        TRY(DIM == 2 ? add_ring(s, radius, 0, dx, to) : add_shell(s, radius, dx, to));
    }
    return STATUS_DONE;
}

int layers_fill(const struct shape *s, double dx, struct points *to)
{
    const long layers = count(s, dx);

    return s->kind == SHAPE_POLYGON ? layers_polygon(s, dx, layers, to)
                                    : fill_ball(s, dx, layers, to);
}

double layers_estimate(const struct shape *s, double dx)
{
    const double r = s->radius;
    double border, all; /* in spacings */

    if (s->kind == SHAPE_POLYGON) {
        border = shape_polygon_length(&s->points) / dx;
        all = shape_polygon_area(&s->points) / (dx * dx) + border;
    } else {
        border = DIM == 2 ? 2 * M_PI * r / dx : 4 * M_PI * r * r / (dx * dx);
        all = border * r / (DIM * dx);
    }
    return fmin(all, border * count(s, dx));
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
    struct buckets b;

    *bare = false;
    if (s->kind != SHAPE_POLYGON)
        return STATUS_DONE;
    TRY(buckets_create(&b, (const double (*)[DIM])p->x, (int)p->n, cover * dx));
    *bare = is_bare(&s->points, dx, &b, x);
    buckets_free(&b);
    return STATUS_DONE;
}
