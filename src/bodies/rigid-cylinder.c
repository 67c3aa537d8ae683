/* rigid-cylinder.c -- a rigid body that is a cylinder along its third axis.
 *
 * Contacts see a prism, which stands on its ends, and, in a cylinder longer than wide, a rod with
 * round ends, on which it rolls: that is half a margin wider than the prism.  A cylinder no
 * longer than wide rolls as the corners of its prism do. */
#include "bodies/rigid-figure.h"

#include "base/status.h"
#include "shapes/layers.h"

#include <math.h>

#if DIM == 3

enum { SIDES_LONG = 12, SIDES_SHORT = 16, AROUND = 48 };

static const double slim = 0.5; /* of a margin: how far the prism is inside of the rod */
static const double pi = 3.14159265358979323846;

static int measure(const struct rigid_def *d, const char *path, struct rigid_figure *to)
{
    const double r = d->radius, h = d->height;

    (void)path;
    to->radius = r;
    to->half[0] = to->half[1] = r;
    to->half[2] = 0.5 * h;
    for (int k = 0; k < DIM; k++)
        to->span[k] = 2 * to->half[k];
    to->least = fmin(2 * r, h);
    to->reach = hypot(r, 0.5 * h);
    to->volume = pi * r * r * h;
    to->surface = 2 * pi * r * (r + h);
    to->gyration[0] = to->gyration[1] = (3 * r * r + h * h) / 12;
    to->gyration[2] = 0.5 * r * r;
    return STATUS_DONE;
}

static int skin(const struct rigid_figure *f, double spacing, int layers, struct points *to)
{
    const struct shape s = { .type = "cylinder", .kind = SHAPE_CYLINDER, .radius = f->radius,
                             .height = 2 * f->half[2], .thickness = layers * spacing };

    return layers_fill(&s, spacing, to);
}

static double depth(const struct rigid_figure *f, const double *own)
{
    return fmin(f->radius - hypot(own[0], own[1]), f->half[2] - fabs(own[2]));
}

static bool is_long(const struct rigid_figure *f)
{
    return f->half[2] > f->radius;
}

static int kernels(struct rigid_figure *f, double margin)
{
    const int sides = is_long(f) ? SIDES_LONG : SIDES_SHORT;
    const double radius = fmax(0.5 * margin, f->radius - margin * (is_long(f) ? 1 + slim : 1));
    double x[2 * SIDES_SHORT][DIM];

    for (int i = 0; i < 2 * sides; i++) {
        x[i][0] = radius * cos(2 * pi * (i / 2) / sides);
        x[i][1] = radius * sin(2 * pi * (i / 2) / sides);
        x[i][2] = (i % 2 ? 1 : -1) * fmax(0.5 * margin, f->half[2] - margin);
    }
    f->kernel = status_alloc(1, sizeof *f->kernel);
    if (!f->kernel)
        return STATUS_FAILED;
    f->kernels = 1;
    return polytope_hull((const double (*)[DIM])x, 2 * sides, f->kernel);
}

static int cores(const struct rigid_figure *f, double margin, struct core *core)
{
    if (core)
        core[0] = (struct core){ .ball = margin, .hull = f->kernel };
    if (core && is_long(f))
        core[1] = (struct core){ .ball = f->radius, .half = { 0, 0, f->half[2] - f->radius } };
    return is_long(f) ? 2 : 1;
}

/* Corners 2 i at the low end, 2 i + 1 at the high one. */
static int surface(const struct rigid_figure *f, struct surface *to)
{
    const int from = to->corners;
    int low[AROUND], high[AROUND];

    for (int i = 0; i < 2 * AROUND; i++) {
        const double turn = 2 * pi * (i / 2) / AROUND;
        TRY(surface_corner(to, (double[DIM]){ f->radius * cos(turn), f->radius * sin(turn),
                                              i % 2 ? f->half[2] : -f->half[2] }));
    }
    for (int i = 0; i < AROUND; i++) {
        const int here = from + 2 * i, next = from + 2 * ((i + 1) % AROUND);
        const int side[4] = { here, next, next + 1, here + 1 };
        high[i] = here + 1;
        low[AROUND - 1 - i] = here;
        TRY(surface_face(to, side, 4));
    }
    TRY(surface_face(to, low, AROUND));
    return surface_face(to, high, AROUND);
}

const struct rigid_form rigid_form_cylinder = { .name = "cylinder", .keys = " radius height ",
                                                .measure = measure, .skin = skin, .depth = depth,
                                                .kernels = kernels, .cores = cores,
                                                .surface = surface };

#endif
