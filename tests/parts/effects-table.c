/* effects-table.c -- a table of effects with those of doc/adding-a-part.md, and those of the
 * library that their tests need.  The linker takes it instead of the library's. */
#include "effects/effects.h"

#include <stddef.h>

extern const struct part LANE_NAME(effects_continuity);
extern const struct part LANE_NAME(effects_summation);
extern const struct part LANE_NAME(effects_pressure_force);
extern const struct part LANE_NAME(effects_artificial_viscosity);
extern const struct part LANE_NAME(effects_laminar_viscosity);
extern const struct part LANE_NAME(effects_density_diffusion);
extern const struct part LANE_NAME(effects_gravity);
extern const struct part LANE_NAME(effects_velocity_smoothing);
extern const struct part LANE_NAME(effects_number_density);
extern const struct part LANE_NAME(effects_kernel_viscosity);

const struct part *const effects_table[] = {
    &LANE_NAME(effects_continuity),
    &LANE_NAME(effects_summation),
    &LANE_NAME(effects_pressure_force),
    &LANE_NAME(effects_artificial_viscosity),
    &LANE_NAME(effects_laminar_viscosity),
    &LANE_NAME(effects_density_diffusion),
    &LANE_NAME(effects_gravity),
    &LANE_NAME(effects_velocity_smoothing),
    &LANE_NAME(effects_number_density),
    &LANE_NAME(effects_kernel_viscosity),
    NULL,
};
