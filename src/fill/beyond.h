/* beyond.h -- points near a place over periodic sides. */
#ifndef FILL_BEYOND_H
#define FILL_BEYOND_H

#include "shapes/buckets.h"
#include "state/scales.h"

/* As buckets_find(), of the images of x over the sides that repeat and their corners; x
 * itself is not one of them. */
int beyond_find(const struct buckets *b, const struct scales *s, const double *x, double reach,
                bool (*counts)(const void *self, int j), const void *self);

#endif
