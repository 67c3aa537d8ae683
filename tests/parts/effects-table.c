/* effects-table.c -- the table of effects with those of doc/adding-a-part.md at its end.  The
 * linker takes this table instead of the library's. */
#include "effects/effects.h"

#include <stddef.h>

extern const struct part LANE_NAME(effects_velocity_smoothing);
extern const struct part LANE_NAME(effects_number_density);
extern const struct part LANE_NAME(effects_kernel_viscosity);

#define ADDED                                                                            \
    &LANE_NAME(effects_velocity_smoothing),                                              \
    &LANE_NAME(effects_number_density),                                                  \
    &LANE_NAME(effects_kernel_viscosity),                                                \
    (const struct part *)0

/* The library's own text: its end becomes lines more and the end. */
#undef NULL
#define NULL ADDED
#include "effects/effects.c"
