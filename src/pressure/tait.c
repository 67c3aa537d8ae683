/* tait.c -- pressure from density by Tait's equation (E2), (20) of Toth (2012).
 * With tension by default, or the density of spray would drift. */
#include "pressure/liquid.h"

#include <math.h>

static const struct param params[] = {
    { .key = "rho0", .unit = "kg/m^3", .offset = offsetof(struct liquid, eos.rho0),
      .fallback = 1000, .min = 1e-3, .max = 1e5, .about = "density at rest" },
    { .key = "c0", .unit = "m/s", .offset = offsetof(struct liquid, eos.c0),
      .fallback = NAN, .min = 1e-6, .max = 1e5,
      .about = "sound speed; computed: 10 sqrt(2 g H), H the height of the fluid at the start" },
    { .key = "gamma", .unit = "1", .offset = offsetof(struct liquid, eos.gamma),
      .fallback = 7, .min = 1, .max = 20, .about = "exponent; 7 is water" },
    LIQUID_TENSION,
    { 0 },
};

static int complete(void *self)
{
    struct liquid *l = self;

    l->eos.clamped = !l->tension;
    return 0;
}

const struct part pressure_tait = {
    .name = "tait",
    .about = "pressure of a slightly compressible liquid",
    .equation = "(E2) p = rho0 c0^2/gamma ((rho/rho0)^gamma - 1)",
    .source = "Monaghan, J. Comput. Phys. 110 (1994) 399-406; Toth 2012, (20)",
    .size = sizeof(struct liquid),
    .params = params,
    .needs = FIELD_DENSITY,
    .provides = FIELD_PRESSURE,
    .complete = complete,
    .prepare = liquid_prepare,
    .limit = liquid_limit,
    .energy = liquid_energy,
    .as.pressure = &liquid_pressure,
};
