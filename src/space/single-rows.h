/* single-rows.h -- rows of neighbours in single precision, of two groups side by side. */
#ifndef SPACE_SINGLE_ROWS_H
#define SPACE_SINGLE_ROWS_H

#include "space/pairs.h"
#include "space/single.h"

enum { SINGLE_HALF = LANES / 2 }; /* lanes of the list                       */

/* The owners of both halves: from places first[] on, those before `end`; the dummy stands
 * where there is none. */
struct single_owners {
    int first[2];
    int end, dummy;
};

/* The owners' own side, with their positions in counts; a.x is not filled. */
struct single_side {
    lanes_mask x[DIM];
    struct side a;
};

/* Places from which rows of one half are taken: [n][SINGLE_HALF], or, with a step of 0, the
 * same row again and again. */
struct single_places {
    const int *j;
    size_t step;
};

/* Records of all, as single_pack() left them. */
struct single_records {
    const float *record;
    real count;           /* the length of a count [m]                          */
    real mass;            /* of all particles; 0: they differ                   */
};

#define single_rows_side LANE_NAME(single_rows_side)
void single_rows_side(const struct single_records *of, const struct single_owners *at,
                      struct single_side *own);

/* Fills rows at..at+n-1 of b with what `needs` (NEED_ bits) ask for, but for kernels. */
#define single_rows_fill LANE_NAME(single_rows_fill)
void single_rows_fill(const struct single_records *of, const struct single_places from[2], int n,
                      const struct single_side *own, unsigned needs, struct block *b, int at);

#endif
