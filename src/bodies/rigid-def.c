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
static const char *const shapes[] = { "box", "disc", "polygon", "clump", NULL };
static const char *const solids[] = { "box", "disc", "polygon", NULL };
static const char *const directions[] = { "x", "y", "turn", NULL };
#define MASS "kg/m"
#define TURN_TYPE PARAM_NUMBER
#else
static const char *const shapes[] = { "box", "sphere", "cylinder", "hull", "compound", "clump", NULL };
static const char *const solids[] = { "box", "sphere", "cylinder", "hull", NULL };
static const char *const directions[] = { "x", "y", "z", "turn", NULL };
#define MASS "kg"
#define TURN_TYPE PARAM_VECTOR
#endif

const struct param rigid_def_params[] = {
    { .key = "shape", .unit = "", AT(shape), .type = PARAM_WORD, .words = shapes,
      .about = "a box has a size, a disc (2D) or sphere (3D) a radius, a cylinder (3D) that and a height, "
               "a polygon (2D) or convex hull (3D) points, a compound of convex parts (3D) points and corners, a clump of discs (2D) or balls (3D) the radius of these, and points, "
               "or pitch and the keys of the shape `of`" },
    { .key = "at", .unit = "m", AT(at), .min = -1e6, .max = 1e6, .type = PARAM_VECTOR,
      .required = 1, .about = "its centre at t = 0; of a body with points where the origin of these is" },
    { .key = "size", .unit = "m", AT(size), .max = 1e6, .type = PARAM_VECTOR,
      .about = "sides of a box, along its own axes; of a clump: its balls lie below the surface of that box" },
    { .key = "radius", .unit = "m", AT(radius), .max = 1e6, .about = "of a disc, sphere or cylinder, or of each ball of a clump" },
    { .key = "height", .unit = "m", AT(height), .max = 1e6,
      .about = "3D: of a cylinder, along its own third axis" },
    { .key = "points", .unit = "m", AT(points), .min = -1e6, .max = 1e6, .type = PARAM_POINTS,
      .fallback = NAN,
      .about = "2D: corners of a polygon in turn, either way round; 3D: points whose convex hull it is; "
               "from `at`, before it is turned; of a clump the centres of its balls" },
    { .key = "corners", .unit = "", AT(corners), .type = PARAM_INTEGER, .fallback = RIGID_DEF_CORNERS, .min = 2, .max = 1000,
      .about = "3D: of a compound, how many of its points in turn make each of its parts: their convex hull, or with 2 a box "
               "between them as opposite corners; parts touch with their faces" },
    { .key = "of", .unit = "", AT(of), .type = PARAM_WORD, .words = solids,
      .about = "of a clump without a list of balls: the shape that these lie below the surface of; its size, height "
               "or points are those of that, and so are mass and inertia" },
    { .key = "body_radius", .unit = "m", AT(body_radius), .max = 1e6,
      .about = "of a clump of a disc, sphere or cylinder: the radius of that, as radius is that of its balls" },
    { .key = "pitch", .unit = "m", AT(pitch), .max = 1e6,
      .about = "of a clump that is made from a shape: how far apart centres of its balls are, nearly; those of two clumps "
               "interlock unless radius is some pitches or more" },
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
#if DIM == 3
    double about[4];

    memcpy(about, q, sizeof about);
    if (turning_known(d->frame))
        turning_product(about, d->frame, q);
#endif
}

void rigid_def_tell(const struct rigid_def *d, const double *q, const double *spin,
                    double *told_q, double *told_spin)
{
    memcpy(told_q, q, TURNING_NUMBERS * sizeof *q);
    memcpy(told_spin, spin, TURNING_SPINS * sizeof *spin);
#if DIM == 2
    (void)d;
#else
    double back[4] = { d->frame[0], -d->frame[1], -d->frame[2], -d->frame[3] }, R[3][3];

    if (!turning_known(d->frame))
        return;
    turning_product(q, back, told_q);
    turning_matrix(d->frame, R);
    for (int i = 0; i < 3; i++) {
        told_spin[i] = 0;
        for (int k = 0; k < 3; k++)
            told_spin[i] += R[i][k] * spin[k];
    }
#endif
}

int rigid_def_check(const struct rigid_def *d, double volume, const char *path)
{
    if (d->density > 0 && d->mass > 0)
        return status_fail(STATUS_BAD_SCENE, "%s: both density = %g kg/m^3 and mass = %g " MASS
                           " are given, and density times volume is %g " MASS "; leave one of "
                           "them out", path, d->density, d->mass, d->density * volume);
    if (!(d->density > 0 || d->mass > 0))
        return status_fail(STATUS_BAD_SCENE, "%s: neither density nor mass is given, so the body "
                           "has no inertia; set density (kg/m^3, wood is 500, PVC 1350) or mass "
                           "(of the whole body, " MASS ")", path);
    return STATUS_DONE;
}
