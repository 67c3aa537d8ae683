/* pressure.c -- the table of equations of state, a line each. */
#include "pressure/pressure.h"

extern const struct part pressure_tait, pressure_linear, pressure_look_ahead;

const struct part *const pressure_table[] = {
    &pressure_tait,
    &pressure_linear,
    &pressure_look_ahead,
    NULL,
};
