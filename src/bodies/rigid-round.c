/* rigid-round.c -- a rigid body that is a disc or sphere. */
#include "bodies/rigid-form.h"

#include "base/status.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

static int measure(const struct rigid_def *d, const char *path, struct rigid_figure *to)
{
    (void)path;
    to->radius = to->reach = d->radius;
    to->least = 2 * d->radius;
    to->volume = DIM == 2 ? pi * d->radius * d->radius : 4 * pi / 3 * pow(d->radius, 3);
    to->surface = DIM * to->volume / d->radius;
    for (int i = 0; i < DIM; i++)
        to->span[i] = 2 * d->radius;
    for (int i = 0; i < TURNING_SPINS; i++)
        to->gyration[i] = (DIM == 2 ? 1 / 2.0 : 2 / 5.0) * d->radius * d->radius;
    return STATUS_DONE;
}

/* Point i of n on a circle, from its lowest on and back by the mirror image, to the last bit: a disc
 * that floats has no side that it would rather drift to.  On a sphere along a spiral of equal areas (Swinbank, Purser,
 * Q. J. Roy. Meteorol. Soc. 132 (2006) 1769-1793). */
static void around(int i, int n, double radius, double *to)
{
#if DIM == 2
    const bool left = 2 * i > n;
    const double turn = 2 * pi * (left ? n - i : i) / n;
    to[0] = (left ? -radius : radius) * (2 * i == n ? 0 : sin(turn));
    to[1] = -radius * cos(turn);
#else
    const double up = 1 - (2 * i + 1.0) / n, across = sqrt(1 - up * up);
    const double turn = pi * (3 - sqrt(5)) * i;
    to[0] = radius * across * cos(turn);
    to[1] = radius * across * sin(turn);
    to[2] = radius * up;
#endif
}

/* Rings or shells. */
static int skin(const struct rigid_figure *f, double spacing, int layers, struct points *to)
{
    for (int k = 0; k < layers; k++) {
        const double radius = f->radius - (k + 0.5) * spacing;
        const double q = radius / spacing;
        if (radius <= -0.5 * spacing)
            break;
        const bool middle = q < 0.25;
        const int m = middle ? 1 : (int)round(DIM == 2 ? 2 * pi * q : 4 * pi * q * q);
        for (int i = 0; i < m; i++) {
            double x[DIM];
            around(i, m, middle ? 0 : radius, x);
            TRY(points_add(to, x));
        }
    }
    return STATUS_DONE;
}

static double depth(const struct rigid_figure *f, const double *own)
{
    double square = 0;

    for (int d = 0; d < DIM; d++)
        square += own[d] * own[d];
    return f->radius - sqrt(square);
}

/* A point. */
static int cores(const struct rigid_figure *f, double margin, struct core *core)
{
    (void)margin;
    if (core)
        *core = (struct core){ .ball = f->radius };
    return 1;
}

enum { AROUND = DIM == 2 ? 64 : 40, RINGS = 20 };

#if DIM == 2
static int surface(const struct rigid_figure *f, struct surface *to)
{
    int corner[AROUND];

    for (int i = 0; i < AROUND; i++) {
        double x[DIM];
        around(i, AROUND, f->radius, x);
        corner[i] = to->corners;
        TRY(surface_corner(to, x));
    }
    return surface_face(to, corner, AROUND);
}
#else
/* Corner i of ring k of a sphere, 0 and RINGS its poles: corners of rings from `from` on. */
static int ring_corner(int from, int k, int i)
{
    return k == 0 ? from : k == RINGS ? from + 1 : from + 2 + (k - 1) * AROUND + i % AROUND;
}

static int ring_faces(int from, int k, struct surface *to)
{
    for (int i = 0; i < AROUND; i++) {
        const int low[2] = { ring_corner(from, k, i), ring_corner(from, k, i + 1) };
        const int high[2] = { ring_corner(from, k + 1, i), ring_corner(from, k + 1, i + 1) };
        const int four[4] = { low[0], low[1], high[1], high[0] };
        const int bottom[3] = { low[0], high[1], high[0] }, top[3] = { low[0], low[1], high[0] };
        TRY(k == 0 ? surface_face(to, bottom, 3) : k + 1 == RINGS ? surface_face(to, top, 3)
                   : surface_face(to, four, 4));
    }
    return STATUS_DONE;
}

static int surface(const struct rigid_figure *f, struct surface *to)
{
    const int from = to->corners;

    TRY(surface_corner(to, (double[DIM]){ 0, 0, -f->radius }));
    TRY(surface_corner(to, (double[DIM]){ 0, 0, f->radius }));
    for (int k = 1; k < RINGS; k++)
        for (int i = 0; i < AROUND; i++) {
            const double across = f->radius * sin(pi * k / RINGS), turn = 2 * pi * i / AROUND;
            TRY(surface_corner(to, (double[DIM]){ across * cos(turn), across * sin(turn),
                                                  -f->radius * cos(pi * k / RINGS) }));
        }
    for (int k = 0; k < RINGS; k++)
        TRY(ring_faces(from, k, to));
    return STATUS_DONE;
}
#endif

const struct rigid_form rigid_form_round = { .name = DIM == 2 ? "disc" : "sphere",
                                             .keys = " radius ", .rounds = true,
                                             .measure = measure, .skin = skin,
                                             .depth = depth, .cores = cores,
                                             .surface = surface };
