/* walls.c -- the table of wall models, a line each; the first is the default. */
#include "walls/walls.h"

extern const struct part walls_own_density;

const struct part *const walls_table[] = {
    &walls_own_density,
    NULL,
};
