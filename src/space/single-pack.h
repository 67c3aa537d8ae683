/* single-pack.h -- records of pairs in single precision from those in double. */
#ifndef SPACE_SINGLE_PACK_H
#define SPACE_SINGLE_PACK_H

#include "base/lanes.h"
#include "space/single.h"

/* Fills record [list->listed + 1][single_floats(mass)], 64-byte aligned, from records in
 * double precision (space/record.h). */
#define single_pack LANE_NAME(single_pack)
void single_pack(const struct list *list, const double *from, double mass, float *record);

#endif
