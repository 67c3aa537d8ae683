/* front.h -- how far the water has come, and how high it still stands. */
#ifndef MEASURE_FRONT_H
#define MEASURE_FRONT_H

#include "measure/crowd.h"

struct front {
    double x;      /* foremost particle of the water: largest first coordinate [m],
                      half a spacing short of the surface; NAN when there is no water */
    double height; /* level of the water within the support of the domain's low-x
                      side: above the domain's lowest point [m], 0 when it is dry     */
};

/* At the moment of the last crowd_update(); all ranks together where its view has some rows alone.  Up is y in 2D and z in 3D. */
void front_find(const struct crowd *c, struct front *out);

#endif
