/* probe-area.h -- probes that measure over an area: the points that they read at. */
#ifndef MEASURE_PROBE_AREA_H
#define MEASURE_PROBE_AREA_H

#include "plan/settings.h"

/* Points of a probe: the middles of equal parts of its area, at most `step` [m] apart along
 * each side, or on rings of a disc; of a probe at a point, that point.  Their plain mean is
 * the mean over the area, exact for what is linear there.  x [returned number][DIM] [m];
 * NULL: only counted. */
int probe_area(const struct settings_probe *p, double step, double (*x)[DIM]);

#endif
