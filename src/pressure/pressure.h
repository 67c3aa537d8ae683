/* pressure.h -- where pressure comes from: equations of state now, solved
 * pressure later. */
#ifndef PRESSURE_PRESSURE_H
#define PRESSURE_PRESSURE_H

#include "matter/eos.h"
#include "state/part.h"

/* NULL-ended; the parameters of each begin with a struct eos. */
extern const struct part *const pressure_table[];

#endif
