/* shape-ball.c -- discs (2D) and spheres (3D), and their layers: rings, shells. */
#include "shapes/shape-kind.h"

#include "base/status.h"
#include "shapes/layers.h"
#include <math.h>
#include <string.h>

static const double core = 0.4; /* a ring smaller than this is one point [dx] */

static int check(struct shape *s, const char *path, const char *where)
{
    if (!shape_is_place(s->centre) || isnan(s->radius))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: a %s needs centre and radius", where, path,
                           s->type);
    if (!(s->radius > 0 && s->radius <= SHAPE_REACH))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: radius is %g m, but a %s needs one above 0",
                           where, path, s->radius, s->type);
    return STATUS_DONE;
}

static double square(const struct shape *s, const double *x)
{
    double r2 = 0;

    for (int d = 0; d < DIM; d++)
        r2 += (x[d] - s->centre[d]) * (x[d] - s->centre[d]);
    return r2;
}

static bool contains(const struct shape *s, const double *x)
{
    return square(s, x) < s->radius * s->radius;
}

static double depth(const struct shape *s, const double *x)
{
    return s->radius - sqrt(square(s, x));
}

static void bounds(const struct shape *s, double *low, double *high)
{
    for (int d = 0; d < DIM; d++) {
        low[d] = s->centre[d] - s->radius;
        high[d] = s->centre[d] + s->radius;
    }
}

static double surface(const struct shape *s)
{
    return DIM == 2 ? 2 * M_PI * s->radius : 4 * M_PI * s->radius * s->radius;
}

static double volume(const struct shape *s)
{
    return surface(s) * s->radius / DIM;
}

static struct shape_rows rows(const struct shape *s, int d, double dx)
{
    return shape_rows_centre(s->centre[d] - s->radius, s->centre[d] + s->radius, s->centre[d], dx);
}

/* A circle about the vertical through the centre, `up` above it. */
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

static int fill(const struct shape *s, double dx, long layers, struct points *to)
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

#define BALL .keys = " centre radius ", .check = check, .contains = contains, .depth = depth, \
             .bounds = bounds, .volume = volume, .rows = rows, .layers = fill, .surface = surface

#if DIM == 2
const struct shape_kind shape_disc = { .name = "disc", BALL };
#else
const struct shape_kind shape_sphere = { .name = "sphere", BALL };
#endif
