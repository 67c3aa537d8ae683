/* block.h -- the shape of a wall where it stands at a moment. */
#ifndef EVAL_BLOCK_H
#define EVAL_BLOCK_H

#include "plan/inside.h"

struct block {
    const struct shape *shape;
    const struct plan_wall *wall;
    struct motion_place place;
    double low[DIM], high[DIM]; /* before it moved [m] */
};

/* Of wall i of the plan at t. */
void block_make(struct block *b, const struct plan *p, int i, double t);

/* Is x [DIM] in it, more than `depth` from its outline [m]? */
bool block_holds(const struct block *b, const double *x, double depth);

#endif
