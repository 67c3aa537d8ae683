/* layers-private.h -- between the files that make layers. */
#ifndef SHAPES_LAYERS_PRIVATE_H
#define SHAPES_LAYERS_PRIVATE_H

#include "shapes/layers.h"

/* Where a point comes from: points of one run are spaced already. */
struct layers_tag {
    int row;
    int run; /* 0: a corner of the row */
};

int layers_polygon(const struct shape *s, double dx, long layers, struct points *to);

/* Adds to `to` the points at [at->n], those too near to each other made one. */
int layers_merge(const struct points *at, const struct layers_tag *tag, double dx,
                 struct points *to);

#endif
