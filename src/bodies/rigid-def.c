/* rigid-def.c -- a rigid body as a scene gives it: parameters, refusals, derived numbers. */
#include "bodies/rigid-def.h"

#include "base/status.h"
#include "shapes/shape.h"
#include <math.h>
#include <stddef.h>
#include <string.h>

#define AT(member) .offset = offsetof(struct rigid_def, member)

static const double pi = 3.14159265358979323846;

#if DIM == 2
static const char *const shapes[] = { "box", "disc", NULL };
static const char *const directions[] = { "x", "y", "turn", NULL };
#define MASS "kg/m"
#define TURN_TYPE PARAM_NUMBER
#else
static const char *const shapes[] = { "box", "sphere", NULL };
static const char *const directions[] = { "x", "y", "z", "turn", NULL };
#define MASS "kg"
#define TURN_TYPE PARAM_VECTOR
#endif

const struct param rigid_def_params[] = {
    { .key = "shape", .unit = "", AT(shape), .type = PARAM_WORD, .words = shapes,
      .about = "a box has a size, a disc (2D) or sphere (3D) a radius" },
    { .key = "at", .unit = "m", AT(at), .min = -1e6, .max = 1e6, .type = PARAM_VECTOR,
      .required = 1, .about = "its centre at t = 0" },
    { .key = "size", .unit = "m", AT(size), .max = 1e6, .type = PARAM_VECTOR,
      .about = "sides of a box, along its own axes" },
    { .key = "radius", .unit = "m", AT(radius), .max = 1e6, .about = "of a disc or sphere" },
    { .key = "density", .unit = "kg/m^3", AT(density), .max = 1e6,
      .about = "of the material; give this or mass, 0 is not given" },
    { .key = "mass", .unit = MASS, AT(mass), .max = 1e12,
      .about = "of the whole body; give this or density, 0 is not given" },
    { .key = "angle", .unit = "deg", AT(angle), .min = -3600, .max = 3600, .type = TURN_TYPE,
      .about = "how far it is turned at t = 0: 2D to the left; 3D about the direction of these three "
               "numbers, by their length" },
    { .key = "velocity", .unit = "m/s", AT(velocity), .min = -1e6, .max = 1e6,
      .type = PARAM_VECTOR, .about = "of its centre at t = 0" },
    { .key = "spin", .unit = "rad/s", AT(spin), .min = -1e6, .max = 1e6, .type = TURN_TYPE,
      .about = "at t = 0: 3D about its own three axes, 2D positive to the left" },
    { .key = "held", .unit = "", AT(held), .type = PARAM_WORDS, .words = directions,
      .about = "what no force changes: the velocity along x, y, z, and with turn the spin" },
    { .key = "stops", .unit = "", AT(stops), .type = PARAM_WORDS, .words = shape_sides,
      .about = "sides of the domain that it lies on, slides along and bounces off, beside those "
               "of a frame; it goes through the others" },
    { .key = "restitution", .unit = "", AT(restitution), .fallback = 0.6, .min = 0.1, .max = 1,
      .about = "speed after a central impact by that before it; of two bodies the root of the product" },
    { .key = "friction", .unit = "", AT(friction), .fallback = 0.35, .max = 10,
      .about = "coefficient of friction; of two bodies the root of the product; 0 is none" },
    { .key = "margin", .unit = "m", AT(margin), .max = 1e6,
      .about = "radius that corners of a box are rounded by where they touch, and half the length that "
               "softness counts in; 0: half a spacing, without fluid a twentieth of the shortest side" },
    { .key = "softness", .unit = "", AT(softness), .max = 0.25,
      .about = "how deep it gets into a side at the reference speed U, in two margins; 0: "
               "2.7 U/(c0 + U), at which contacts ask for no shorter steps than sound; 0.25 at most" },
    { .key = "film", .unit = "", AT(film), .max = 10,
      .about = "gap that contacts keep open around it, in spacings, of two bodies the larger: particles get under "
               "a body that lies on the floor from about 1 on; 0: none" },
    { .key = "uplift", .unit = "", AT(uplift), .type = PARAM_FLAG,
      .about = "true: in gaps at faces of a box that are too narrow for particles water has the pressure "
               "that it has at their edges: under a box that lies on the floor, and between boxes" },
    { .key = "layers", .unit = "", AT(layers), .max = 100, .type = PARAM_INTEGER,
      .about = "layers of the skin; 0: as many as the kernel's support covers" },
    { .key = "slip", .unit = "", AT(slip), .type = PARAM_FLAG,
      .about = "true: viscosity does not act on the skin" },
    { 0 },
};

void rigid_def_turned(const struct rigid_def *d, double *q)
{
    double angle[TURNING_SPINS];

    for (int i = 0; i < TURNING_SPINS; i++)
        angle[i] = d->angle[i] * pi / 180;
    turning_about(angle, q);
}

bool rigid_def_round(const struct rigid_def *d)
{
    return strcmp(d->shape, "box") != 0;
}

static int check_size(const struct rigid_def *d, const char *path)
{
    double least = HUGE_VAL, most = 0;

    for (int i = 0; i < DIM; i++) {
        least = fmin(least, d->size[i]);
        most = fmax(most, d->size[i]);
    }
    if (rigid_def_round(d) && most > 0)
        return status_fail(STATUS_BAD_SCENE, "%s: a %s has no size; leave it out, and set radius",
                           path, d->shape);
    if (rigid_def_round(d) && !(d->radius > 0))
        return status_fail(STATUS_BAD_SCENE, "%s: radius = %g m makes no %s; set a radius above 0",
                           path, d->radius, d->shape);
    if (rigid_def_round(d) && d->uplift)
        return status_fail(STATUS_BAD_SCENE, "%s: uplift is for the flat faces of a box, and a %s has "
                           "none; leave it out", path, d->shape);
    if (!rigid_def_round(d) && d->radius > 0)
        return status_fail(STATUS_BAD_SCENE, "%s: a box has no radius; leave it out, and set size, "
                           "or set shape = \"%s\"", path, shapes[1]);
    if (!rigid_def_round(d) && !(least > 0))
        return status_fail(STATUS_BAD_SCENE, "%s: a side of %g m makes no box; set size, %d numbers "
                           "above 0 (m)", path, least, DIM);
    return STATUS_DONE;
}

int rigid_def_check(const struct rigid_def *d, const char *path)
{
    TRY(check_size(d, path));
    if (d->density > 0 && d->mass > 0)
        return status_fail(STATUS_BAD_SCENE, "%s: both density = %g kg/m^3 and mass = %g " MASS
                           " are given, and density times volume is %g " MASS "; leave one of "
                           "them out", path, d->density, d->mass,
                           d->density * rigid_def_volume(d));
    if (!(d->density > 0 || d->mass > 0))
        return status_fail(STATUS_BAD_SCENE, "%s: neither density nor mass is given, so the body "
                           "has no inertia; set density (kg/m^3, wood is 500, PVC 1350) or mass "
                           "(of the whole body, " MASS ")", path);
    return STATUS_DONE;
}

double rigid_def_volume(const struct rigid_def *d)
{
    double sides = 1;

    if (rigid_def_round(d))
        return DIM == 2 ? pi * d->radius * d->radius : 4 * pi / 3 * pow(d->radius, 3);
    for (int i = 0; i < DIM; i++)
        sides *= d->size[i];
    return sides;
}

double rigid_def_surface(const struct rigid_def *d)
{
    double faces = 0;

    if (rigid_def_round(d))
        return DIM * rigid_def_volume(d) / d->radius;
    for (int i = 0; i < DIM; i++)
        faces += 2 * rigid_def_volume(d) / d->size[i];
    return faces;
}

double rigid_def_mass(const struct rigid_def *d)
{
    return d->mass > 0 ? d->mass : d->density * rigid_def_volume(d);
}

double rigid_def_reach(const struct rigid_def *d)
{
    double square = 0;

    for (int i = 0; i < DIM; i++)
        square += 0.25 * d->size[i] * d->size[i];
    return rigid_def_round(d) ? d->radius : sqrt(square);
}

void rigid_def_inertia(const struct rigid_def *d, double *to)
{
    const double m = rigid_def_mass(d);

    for (int i = 0; i < TURNING_SPINS; i++) {
        const double a = d->size[(i + 1) % DIM], b = d->size[DIM == 2 ? 0 : (i + 2) % DIM];
        if (rigid_def_round(d))
            to[i] = (DIM == 2 ? 1 / 2.0 : 2 / 5.0) * m * d->radius * d->radius;
        else
            to[i] = m / 12 * (a * a + b * b);
    }
}
