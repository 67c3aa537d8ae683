/* linear.c -- pressure in proportion to what the density is above that at rest,
 *
 *   p = k (rho - rho0),  k = c0^2                                     (E1), (19)
 *
 * "standard SPH" of Toth (2012).  Its table 1 gives k = 10000 m^2/s^2, a sound speed of
 * 100 m/s: 25 times that of its "stiff" WCSPH.  Toth 2012, section 3.4.1. */
#include "pressure/liquid.h"

#include "base/status.h"

#include <math.h>

struct linear {
    struct liquid liquid;
    double k; /* c0^2 [m^2/s^2] */
};

static const struct param params[] = {
    { .key = "rho0", .unit = "kg/m^3", .offset = offsetof(struct linear, liquid.eos.rho0),
      .fallback = 1000, .min = 1e-3, .max = 1e5, .about = "density at rest" },
    { .key = "c0", .unit = "m/s", .offset = offsetof(struct linear, liquid.eos.c0),
      .fallback = NAN, .min = 1e-6, .max = 1e5,
      .about = "sound speed; computed: sqrt(k) if that is given, else 10 sqrt(2 g H), H the "
               "height of the fluid at the start" },
    { .key = "k", .unit = "m^2/s^2", .offset = offsetof(struct linear, k), .min = 0, .max = 1e10,
      .about = "stiffness, the square of the sound speed; 0: not given, c0 counts" },
    LIQUID_TENSION,
    { 0 },
};

static int complete(void *self)
{
    struct linear *l = self;
    struct eos *e = &l->liquid.eos;

    e->gamma = 1;
    e->clamped = !l->liquid.tension;
    if (l->k == 0)
        return STATUS_DONE;
    if (isnan(e->c0))
        e->c0 = sqrt(l->k);
    if (!(fabs(e->c0 * e->c0 - l->k) <= 1e-9 * l->k))
        return status_fail(STATUS_BAD_SCENE, "eos: both k = %g m^2/s^2 and c0 = %g m/s are given, "
                           "but k is the square of c0, %g m^2/s^2; leave one of them out", l->k,
                           e->c0, e->c0 * e->c0);
    return STATUS_DONE;
}

const struct part pressure_linear = {
    .name = "linear",
    .about = "pressure in proportion to density, standard SPH of Toth (2012)",
    .equation = "(E1) p = k (rho - rho0), k = c0^2",
    .source = "Toth 2012, (19)",
    .size = sizeof(struct linear),
    .params = params,
    .needs = FIELD_DENSITY,
    .provides = FIELD_PRESSURE,
    .complete = complete,
    .prepare = liquid_prepare,
    .limit = liquid_limit,
    .energy = liquid_energy,
    .as.pressure = &liquid_pressure,
};
