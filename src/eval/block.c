/* block.c -- the shape of a wall where it stands at a moment. */
#include "eval/block.h"

void block_make(struct block *b, const struct plan *p, int i, double t)
{
    b->shape = &p->in.wall[i].set.shape;
    b->wall = &p->wall[i];
    motion_at(&b->wall->motion, t, &b->place);
    shape_bounds(b->shape, b->low, b->high);
}

bool block_holds(const struct block *b, const double *x, double depth)
{
    double own[DIM];

    motion_back(&b->wall->motion, &b->place, x, own);
    for (int d = 0; d < DIM; d++)
        if (own[d] < b->low[d] || own[d] > b->high[d])
            return false;
    return shape_depth(b->shape, own) > depth;
}
