/* gather.h -- from places to what a law sees: the owners' own side, and rows of
 * neighbours with the geometry of their pairs. */
#ifndef SPACE_GATHER_H
#define SPACE_GATHER_H

#include "kernels/rows.h"
#include "space/pairs.h"

/* Fills n <= PAIRS_ROWS rows of b but for what kernels give; j is [n][LANES]
 * entries of rows of the list. */
typedef void gather_rows(const double *record, const int *j, int n, const struct side *a,
                         struct block *b);

/* The cheapest that fills at least what `needs` (NEED_ bits) ask for. */
#define gather_choose LANE_NAME(gather_choose)
gather_rows *gather_choose(unsigned needs);

/* The owners in places first.. before end; lanes beyond get a copy of record
 * `dummy` at the opposite position, so that they are far from padding too. */
#define gather_side LANE_NAME(gather_side)
void gather_side(const double *record, int first, int end, int dummy, struct side *a);

/* Fills gw, gw_r2, w and lw, whichever are needed, by this kernel. */
#define gather_kernel LANE_NAME(gather_kernel)
void gather_kernel(unsigned needs, const struct kernel_use *use, struct block *b);

/* x = x_a - x_b: the one place where the separation of a pair is formed. */
static inline void gather_separation(const lanes *a, const lanes *b, lanes *x)
{
    for (int d = 0; d < DIM; d++)
        x[d] = a[d] - b[d];
}

#endif
