/* effects.c -- the table of effects: a line each, in the order of their sums. */
#include "effects/effects.h"

extern const struct part LANE_NAME(effects_continuity);
extern const struct part LANE_NAME(effects_summation);
extern const struct part LANE_NAME(effects_pressure_force);
extern const struct part LANE_NAME(effects_pressure_printed);
extern const struct part LANE_NAME(effects_artificial_stress);
extern const struct part LANE_NAME(effects_contact_potential);
extern const struct part LANE_NAME(effects_artificial_viscosity);
extern const struct part LANE_NAME(effects_laminar_viscosity);
extern const struct part LANE_NAME(effects_stress_viscosity);
extern const struct part LANE_NAME(effects_laplacian_viscosity);
extern const struct part LANE_NAME(effects_viscosity_printed);
extern const struct part LANE_NAME(effects_density_diffusion);
extern const struct part LANE_NAME(effects_density_healing);
extern const struct part LANE_NAME(effects_particle_shifting);
extern const struct part LANE_NAME(effects_xsph);
extern const struct part LANE_NAME(effects_shepard_filter);
extern const struct part LANE_NAME(effects_gravity);
extern const struct part LANE_NAME(effects_central_force);

const struct part *const effects_table[] = {
    &LANE_NAME(effects_continuity),
    &LANE_NAME(effects_summation),
    &LANE_NAME(effects_pressure_force),
    &LANE_NAME(effects_pressure_printed),
    &LANE_NAME(effects_artificial_stress),
    &LANE_NAME(effects_contact_potential),
    &LANE_NAME(effects_artificial_viscosity),
    &LANE_NAME(effects_laminar_viscosity),
    &LANE_NAME(effects_stress_viscosity),
    &LANE_NAME(effects_laplacian_viscosity),
    &LANE_NAME(effects_viscosity_printed),
    &LANE_NAME(effects_density_diffusion),
    &LANE_NAME(effects_density_healing),
    &LANE_NAME(effects_particle_shifting),
    &LANE_NAME(effects_xsph),
    &LANE_NAME(effects_shepard_filter),
    &LANE_NAME(effects_gravity),
    &LANE_NAME(effects_central_force),
    NULL,
};
