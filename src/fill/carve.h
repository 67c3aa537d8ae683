/* carve.h -- fluids make room for solids. */
#ifndef FILL_CARVE_H
#define FILL_CARVE_H

#include "fill/fill.h"
#include "shapes/points.h"

/* What a fluid left to solids. */
struct carve {
    long n;   /* sites                                  */
    int most; /* item that took most of them, -1: none  */
};

/* Takes out of points[k] of each fluid item k the sites inside of the shape of a wall, or
 * nearer than 0.75 dx to a particle of a wall or skin, over periodic sides too.  out[items]:
 * what each fluid lost.
 *
 * Refuses (BAD_SCENE) a fluid of which more than half is lost, with the shares that solids
 * took of it. */
int carve_fluids(const struct fill_item *item, int items, const struct scales *scales,
                 struct points *points, struct carve *out);

#endif
