/* walls-table.c -- a table of wall models with that of doc/adding-a-part.md. */
#include "base/lanes.h"
#include "walls/walls.h"

#include <stddef.h>

extern const struct part LANE_NAME(walls_own_density);
extern const struct part LANE_NAME(walls_adami);
extern const struct part LANE_NAME(walls_hydrostatic);

const struct part *const walls_table[] = {
    &LANE_NAME(walls_own_density),
    &LANE_NAME(walls_adami),
    &LANE_NAME(walls_hydrostatic),
    NULL,
};
