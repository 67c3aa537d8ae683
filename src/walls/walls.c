/* walls.c -- the table of wall models, a line each; the first is the default. */
#include "base/lanes.h"
#include "walls/walls.h"

extern const struct part LANE_NAME(walls_contact);
extern const struct part LANE_NAME(walls_own_density);
extern const struct part LANE_NAME(walls_adami);
extern const struct part LANE_NAME(walls_ghost);
extern const struct part LANE_NAME(walls_potential);

const struct part *const walls_table[] = {
    &LANE_NAME(walls_contact),
    &LANE_NAME(walls_own_density),
    &LANE_NAME(walls_adami),
    &LANE_NAME(walls_ghost),
    &LANE_NAME(walls_potential),
    NULL,
};
