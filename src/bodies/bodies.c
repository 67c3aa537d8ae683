/* bodies.c -- the table of bodies, a line each. */
#include "bodies/bodies.h"

const struct body_kind *const bodies_table[] = {
    &bodies_beam,
    &bodies_rigid,
    NULL,
};
