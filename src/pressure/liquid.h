/* liquid.h -- what all equations of state of a liquid have in common: pressures,
 * internal energy, fastest waves.
 *
 * An equation of state is a file with its rows and a complete(); its parameters
 * begin with a struct liquid. */
#ifndef PRESSURE_LIQUID_H
#define PRESSURE_LIQUID_H

#include "pressure/pressure.h"

struct liquid {
    struct eos eos;
    bool tension; /* pressure may be negative                             */
    double reach; /* rate of waves per speed: SCALES_WAVE wave/hs   [1/m] */
};

/* Members of their parts. */
extern const struct part_pressure liquid_pressure;
int liquid_prepare(void *self, const struct scales *s);
void liquid_limit(const void *self, const struct view *v, struct limit *out);
void liquid_energy(const void *self, const struct view *v, struct energy_sums *to);

#define LIQUID_TENSION                                                                   \
    { .key = "tension", .unit = "", .type = PARAM_FLAG, .fallback = 1, .max = 1,         \
      .offset = offsetof(struct liquid, tension),                                        \
      .about = "whether pressure may be negative; false cuts it at 0 below rho0, which " \
               "summation density needs at free surfaces" }

#endif
