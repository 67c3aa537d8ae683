/* buckets.h -- which points are near a place, for filling shapes.
 *
 * Points are sorted into cells, the cells into buckets by their number modulo the
 * buckets: near points lie near in memory, and two cells in one bucket cost time
 * only. */
#ifndef SHAPES_BUCKETS_H
#define SHAPES_BUCKETS_H

#include <stdbool.h>
#include <stdint.h>

struct buckets {
    const double (*x)[DIM]; /* [n] lent                  */
    double width;           /* of a cell [m]             */
    uint64_t mask;          /* buckets - 1               */
    int *start;             /* [buckets + 1] into member */
    int *member;            /* [n] points, bucket by bucket */
};

int buckets_create(struct buckets *b, const double (*x)[DIM], int n, double width);
void buckets_free(struct buckets *b);

/* A point j nearer to x than reach, at most the width, for which counts(self, j)
 * says yes (NULL: all count), or -1. */
int buckets_find(const struct buckets *b, const double *x, double reach,
                 bool (*counts)(const void *self, int j), const void *self);

double buckets_distance2(const double *a, const double *b); /* [m^2] */

#endif
