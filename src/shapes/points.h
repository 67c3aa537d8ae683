/* points.h -- a list of places that grows, for filling shapes. */
#ifndef SHAPES_POINTS_H
#define SHAPES_POINTS_H

/* Zeroed at first. */
struct points {
    long n, room;
    double (*x)[DIM]; /* [n] [m] */
};

/* Room for `more` beyond n, which the caller may fill himself. */
int points_reserve(struct points *p, long more);
int points_add(struct points *p, const double *x);
void points_free(struct points *p);

#endif
