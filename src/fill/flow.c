/* flow.c -- flows that a fluid may start with. */
#include "fill/flow.h"

#include "base/status.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { UP = DIM - 1 };

static double across(const struct flow *f, const double *x)
{
    return x[0] - f->centre[0];
}

static double above(const struct flow *f, const double *x)
{
    return x[UP] - f->centre[UP];
}

static void rotation_velocity(const struct flow *f, const double *x, double *u)
{
    u[0] -= f->rate * above(f, x);
    u[UP] += f->rate * across(f, x);
}

static const struct flow_kind rotation = {
    .name = "rotation", .about = "turns as a stiff body, anticlockwise",
    .source = "u = -flow_rate (z - centre), w = flow_rate (x - centre)", .keys = "flow_rate",
    .velocity = rotation_velocity
};

static void strain_velocity(const struct flow *f, const double *x, double *u)
{
    u[0] += f->rate * across(f, x);
    u[UP] -= f->rate * above(f, x);
}

/* A parabola, 0 at the drop's edge: exact for a round drop, with or without a force
 * to its middle. */
static double strain_pressure(const struct flow *f, const double *x)
{
    const double r2 = across(f, x) * across(f, x) + above(f, x) * above(f, x);

    if (isnan(f->pressure) || isnan(f->size) || r2 > f->size * f->size)
        return 0;
    return f->pressure * (1 - r2 / (f->size * f->size));
}

static const struct flow_kind strain = {
    .name = "strain", .about = "is drawn out in x and pressed flat; with flow_pressure and "
    "flow_size a round drop's pressure",
    .source = "u = flow_rate (x - centre), w = -flow_rate (z - centre); Monaghan (1994), "
    "J. Comput. Phys. 110, 399", .keys = "flow_rate", .may = "flow_pressure flow_size",
    .velocity = strain_velocity, .pressure = strain_pressure
};

static void shear_velocity(const struct flow *f, const double *x, double *u)
{
    u[0] += f->rate * above(f, x);
}

static const struct flow_kind shear = {
    .name = "shear", .about = "runs along x, faster with height",
    .source = "u = flow_rate (z - centre)", .keys = "flow_rate", .velocity = shear_velocity
};

static void vortices_velocity(const struct flow *f, const double *x, double *u)
{
    const double k = 2 * M_PI / f->size;

    u[0] -= f->speed * cos(k * across(f, x)) * sin(k * above(f, x));
    u[UP] += f->speed * sin(k * across(f, x)) * cos(k * above(f, x));
}

static double vortices_pressure(const struct flow *f, const double *x)
{
    const double k = 4 * M_PI / f->size;

    return -f->rho0 * f->speed * f->speed / 4
           * (cos(k * across(f, x)) + cos(k * above(f, x)));
}

static const struct flow_kind vortices = {
    .name = "taylor-green", .about = "vortices that turn against each other, two to a period",
    .source = "Taylor, Green (1937), Proc. R. Soc. A 158, 499", .keys = "flow_speed flow_size",
    .velocity = vortices_velocity, .pressure = vortices_pressure
};

static void wave_velocity(const struct flow *f, const double *x, double *u)
{
    const double k = 2 * M_PI / f->size, depth = f->high[UP] - f->low[UP];
    const double omega = sqrt(f->gravity * k * tanh(k * depth));
    const double most = f->amplitude * f->gravity * k / omega / cosh(k * depth);

    u[0] += most * cosh(k * (above(f, x) + depth)) * sin(k * across(f, x));
    u[UP] -= most * sinh(k * (above(f, x) + depth)) * cos(k * across(f, x));
}

static const struct flow_kind wave = {
    .name = "standing-wave", .about = "a standing wave at the moment when its surface is flat",
    .source = "linear theory: potential -(A g/omega) cosh(k(z + H))/cosh(kH) cos(kx), omega^2 = "
    "g k tanh(kH), k = 2 pi/flow_size, H the fluid's height", .keys = "flow_amplitude flow_size",
    .velocity = wave_velocity
};

const struct flow_kind *const flow_table[] = { &rotation, &strain, &shear, &vortices, &wave, NULL };

static const char *const words[] = { "still", "rotation", "strain", "shear", "taylor-green",
                                     "standing-wave", NULL };

#define AT(member) .offset = offsetof(struct flow, member)
const struct param flow_params[] = {
    { .key = "flow", .unit = "", .type = PARAM_WORD, AT(type), .words = words,
      .about = "how it moves at the start, added to velocity (see `list flows`)" },
    { .key = "flow_rate", .unit = "1/s", AT(rate), .fallback = NAN, .min = -1e6, .max = 1e6,
      .about = "needed by rotation, strain and shear" },
    { .key = "flow_speed", .unit = "m/s", AT(speed), .fallback = NAN, .min = -1e5, .max = 1e5,
      .about = "largest speed, needed by taylor-green" },
    { .key = "flow_size", .unit = "m", AT(size), .fallback = NAN, .min = 1e-9, .max = 1e6,
      .about = "length of a standing-wave or of a pair of taylor-green vortices, needed by them; "
               "radius of a drop in strain" },
    { .key = "flow_amplitude", .unit = "m", AT(amplitude), .fallback = NAN, .min = -1e3,
      .max = 1e3, .about = "height above the level, needed by standing-wave" },
    { .key = "flow_pressure", .unit = "Pa", AT(pressure), .fallback = NAN, .min = -1e12,
      .max = 1e12, .about = "in the middle of a drop in strain" },
    { .key = "flow_centre", .unit = "m", .type = PARAM_VECTOR, AT(centre), .fallback = NAN,
      .min = -1e6, .max = 1e6, .about = "where formulas have their origin; computed: the middle "
      "of the shape, for a standing-wave the left end of its surface" },
    { 0 },
};

const struct flow_kind *flow_find(const struct flow *f)
{
    for (int i = 0; flow_table[i]; i++)
        if (strcmp(flow_table[i]->name, f->type) == 0)
            return flow_table[i];
    return NULL;
}

/* Was the key given, if the kind needs it? */
static int need(const struct flow_kind *kind, const char *key, double value, const char *path,
                const char *where)
{
    if (!strstr(kind->keys, key) || !isnan(value))
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "%s: %s: flow = \"%s\" needs %s; `explain fluid` shows "
                       "the keys of flows", where, path, kind->name, key);
}

int flow_check(struct flow *f, const char *path, const char *where)
{
    const struct flow_kind *kind = flow_find(f);

    if (!kind)
        return STATUS_DONE;
    TRY(need(kind, "flow_rate", f->rate, path, where));
    TRY(need(kind, "flow_speed", f->speed, path, where));
    TRY(need(kind, "flow_size", f->size, path, where));
    TRY(need(kind, "flow_amplitude", f->amplitude, path, where));
    if (kind == &wave && !(f->gravity > 0))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: flow = \"%s\" is a wave under gravity, and "
                           "there is none downwards; give `gravity`", where, path, kind->name);
    for (int d = 0; d < DIM; d++)
        if (isnan(f->centre[d]))
            f->centre[d] = kind != &wave ? (f->low[d] + f->high[d]) / 2
                           : d == UP     ? f->high[d]
                                         : f->low[d];
    return STATUS_DONE;
}
