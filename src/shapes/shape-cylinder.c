/* shape-cylinder.c -- cylinders of any direction (3D), and their layers.
 *
 * In its own axes, along which its lattice stands, a cylinder goes upwards through the origin:
 *   x = m + own_0 e + own_1 k x e + own_2 k
 * with m the centre, k the axis and e across it, beside that axis of space of which k has
 * least: whole quarters stay exact. */
#include "shapes/shape-kind.h"

#if DIM == 3

#include "base/status.h"
#include "shapes/layers.h"
#include <math.h>

static const double core = 0.4; /* a ring smaller than this is one point [dx] */

static int check(struct shape *s, const char *path, const char *where)
{
    if (!shape_is_place(s->centre) || isnan(s->radius) || isnan(s->height))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: a cylinder needs centre, radius and height",
                           where, path);
    if (!(s->radius > 0 && s->radius <= SHAPE_REACH))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: radius is %g m, but a cylinder needs one"
                           " above 0", where, path, s->radius);
    if (!(s->height > 0 && s->height <= SHAPE_REACH))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: height is %g m, but a cylinder needs one"
                           " above 0; axis says where it goes", where, path, s->height);
    return shape_check_axis(s, path, where);
}

/* The own axes as rows: e, k x e, k. */
static void axes(const struct shape *s, double to[3][3])
{
    double *k = to[2], length = 0;
    int least = 0;

    shape_axis(s, k);
    for (int d = 1; d < 3; d++)
        least = fabs(k[d]) < fabs(k[least]) ? d : least;
    for (int d = 0; d < 3; d++) {
        to[0][d] = (d == least) - k[least] * k[d];
        length += to[0][d] * to[0][d];
    }
    for (int d = 0; d < 3; d++)
        to[0][d] /= sqrt(length);
    for (int d = 0; d < 3; d++) {
        const int e = (d + 1) % 3, f = (d + 2) % 3;
        to[1][d] = k[e] * to[0][f] - k[f] * to[0][e];
    }
}

static void place(const struct shape *s, const double *own, double *x)
{
    const double from[3] = { own[0], own[1], own[2] };
    double axis[3][3];

    axes(s, axis);
    for (int d = 0; d < 3; d++)
        x[d] = s->centre[d] + axis[0][d] * from[0] + axis[1][d] * from[1] + axis[2][d] * from[2];
}

static void own_of(const struct shape *s, const double *x, double *own)
{
    const double arm[3] = { x[0] - s->centre[0], x[1] - s->centre[1], x[2] - s->centre[2] };
    double axis[3][3];

    axes(s, axis);
    for (int k = 0; k < 3; k++)
        own[k] = axis[k][0] * arm[0] + axis[k][1] * arm[1] + axis[k][2] * arm[2];
}

static bool contains(const struct shape *s, const double *x)
{
    double own[3];

    own_of(s, x, own);
    return -0.5 * s->height <= own[2] && own[2] < 0.5 * s->height
        && own[0] * own[0] + own[1] * own[1] < s->radius * s->radius;
}

static double depth(const struct shape *s, const double *x)
{
    double own[3];

    own_of(s, x, own);
    return fmin(s->radius - hypot(own[0], own[1]), 0.5 * s->height - fabs(own[2]));
}

/* The ends are discs: across them a disc reaches r sqrt(1 - k_d^2) along d. */
static void bounds(const struct shape *s, double *low, double *high)
{
    double k[3];

    shape_axis(s, k);
    for (int d = 0; d < 3; d++) {
        const double reach = 0.5 * s->height * fabs(k[d])
                           + s->radius * sqrt(fmax(0, 1 - k[d] * k[d]));
        low[d] = s->centre[d] - reach;
        high[d] = s->centre[d] + reach;
    }
}

static double volume(const struct shape *s)
{
    return M_PI * s->radius * s->radius * s->height;
}

static double surface(const struct shape *s)
{
    return 2 * M_PI * s->radius * (s->radius + s->height);
}

static double side(const struct shape *s, int d)
{
    return d == 2 ? s->height : 0;
}

static struct shape_rows rows(const struct shape *s, int d, double dx)
{
    return d == 2 ? shape_rows_spread(-0.5 * s->height, 0.5 * s->height, dx)
                  : shape_rows_centre(-s->radius, s->radius, 0, dx);
}

static int add(const struct shape *s, double a, double b, double up, struct points *to)
{
    double x[3];

    place(s, (double[3]){ a, b, up }, x);
    return points_add(to, x);
}

static int add_ring(const struct shape *s, double radius, double up, double dx,
                    struct points *to)
{
    const long n = layers_steps(2 * M_PI * radius, dx);

    if (radius < core * dx)
        return add(s, 0, 0, up, to);
    for (long i = 0; i < n; i++)
        TRY(add(s, radius * cos(2 * M_PI * i / n), radius * sin(2 * M_PI * i / n), up, to));
    return STATUS_DONE;
}

/* Rings a spacing apart, down to the middle. */
static int add_plate(const struct shape *s, double radius, double up, double dx,
                     struct points *to)
{
    for (; radius > -core * dx; radius -= dx)
        TRY(add_ring(s, radius, up, dx, to));
    return STATUS_DONE;
}

/* A plate at either end and rings between them, at one depth. */
static int add_layer(const struct shape *s, double deep, double dx, struct points *to)
{
    const double half = 0.5 * s->height - deep, radius = s->radius - deep;
    const long n = layers_steps(2 * half, dx);

    if (half < core * dx)
        return add_plate(s, radius, 0, dx, to);
    TRY(add_plate(s, radius, -half, dx, to));
    TRY(add_plate(s, radius, half, dx, to));
    for (long i = 1; i < n; i++)
        TRY(add_ring(s, radius, half * (2.0 * i / n - 1), dx, to));
    return STATUS_DONE;
}

static int fill(const struct shape *s, double dx, long layers, struct points *to)
{
    for (long k = 0; k < layers; k++) {
        const double deep = (k + 0.5) * dx;

        if (s->radius - deep <= -core * dx || 0.5 * s->height - deep <= -core * dx)
            break;
        TRY(add_layer(s, deep, dx, to));
        if (s->radius - deep < core * dx || 0.5 * s->height - deep < core * dx)
            break;
    }
    return STATUS_DONE;
}

const struct shape_kind shape_cylinder = {
    .name = "cylinder", .keys = " centre radius height axis ", .check = check,
    .contains = contains, .depth = depth, .bounds = bounds, .volume = volume, .rows = rows,
    .place = place, .own = own_of, .side = side, .layers = fill, .surface = surface,
};

#endif
