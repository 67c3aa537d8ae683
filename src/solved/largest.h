/* largest.h -- the largest vector of the fluid that is in the domain. */
#ifndef SOLVED_LARGEST_H
#define SOLVED_LARGEST_H

#include "eval/inside.h"

/* Largest length among vectors [fluid][DIM] by row, which stand where the fluid's velocities do
 * in a vector like y, and whose, by id: the first of equals; where is not touched when all are 0.
 * What has left the domain counts for nothing: it falls for ever, alone. */
double largest_inside(const struct moment *m, const double *y, const double *vectors, int *where);

#endif
