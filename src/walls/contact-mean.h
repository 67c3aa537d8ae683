/* contact-mean.h -- the mean of numbers of a solid over the kernel, and its transpose:
 *
 *   mean_w = sum_w' A_ww' r_w',  A_ww' = K_ww'/N_w,  N_w = sum_w'' K_ww''
 *   K_ww' = W(X_w - X_w') max(0, 1 - |n_w/s_w - n_w'/s_w'|^2)
 *
 * over particles of solids that never move against each other, at their places X at rest, that
 * water can reach (s_w > 0).  The second factor keeps the two sides of a thin solid apart:
 * n_w/s_w (contact-room.h) points to the water's side.  K is symmetric to the bit. */
#ifndef WALLS_CONTACT_MEAN_H
#define WALLS_CONTACT_MEAN_H

#include "walls/contact-room.h"

struct contact_mean {
    int n;            /* particles that water can reach              */
    int *solid;       /* [n] which, counted from the first solid     */
    long *start;      /* [n + 1] rows into column and weight         */
    int *column;      /* which of the n                              */
    float *weight;    /* K, times a constant                         */
    double *inverse;  /* [n] 1/N                                     */
};

/* share [solids] of contact-room.h. */
int contact_mean_create(struct contact_mean *m, const struct part_places *at,
                        const struct contact_cells *solids, const struct contact_share *share);
void contact_mean_free(struct contact_mean *m);
double contact_mean_memory(const struct contact_mean *m); /* [bytes] */

/* sum_w' K_ww' r_w' of number i. */
double contact_mean_sum(const struct contact_mean *m, int i, const double *r);

#endif
