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

enum { CONTACT_ROWS = 4 }; /* that are added up side by side */

/* Rows stand in slices of CONTACT_ROWS, entry by entry: the e-th of row i is number
 * contact_mean_at(m, i, e).  Short rows, and those of the last slice that are none, are filled
 * up with weights of 0, which change no bit of a sum. */
struct contact_mean {
    int n, slices;    /* particles that water can reach; of them     */
    int *solid;       /* [n] which, counted from the first solid, in contact-order.h's order */
    int *by_solid;    /* [n] which of the n, by ascending solid      */
    long *start;      /* [slices + 1] first number of a slice        */
    long entries;     /* that are no filling                         */
    int *column;      /* which of the n                              */
    float *weight;    /* K, times a constant                         */
    double *inverse;  /* [slices][CONTACT_ROWS] 1/N                  */
    long *reads_from; /* [slices + 1] into reads                     */
    int *reads;       /* slices whose particles a slice has weights of */
};

/* share [solids] of contact-room.h. */
int contact_mean_create(struct contact_mean *m, const struct part_places *at,
                        const struct contact_cells *solids, const struct contact_share *share);
void contact_mean_free(struct contact_mean *m);
double contact_mean_memory(const struct contact_mean *m); /* [bytes] */
void contact_mean_show(const struct contact_mean *m, part_see *see, void *whose);

static inline long contact_mean_at(const struct contact_mean *m, int i, long e)
{
    return m->start[i / CONTACT_ROWS] + e * CONTACT_ROWS + i % CONTACT_ROWS;
}

static inline long contact_mean_length(const struct contact_mean *m, int slice)
{
    return (m->start[slice + 1] - m->start[slice]) / CONTACT_ROWS;
}

/* sum_w' K_ww' r_w' of the rows of a slice: each in its own order, and none waits for the
 * others' additions. */
static inline void contact_mean_sums(const struct contact_mean *m, int slice, const double *r,
                                     double *restrict to)
{
    double sum[CONTACT_ROWS] = { 0 };

    for (long e = m->start[slice]; e < m->start[slice + 1]; e += CONTACT_ROWS)
        for (int k = 0; k < CONTACT_ROWS; k++)
            sum[k] += (double)m->weight[e + k] * r[m->column[e + k]];
    for (int k = 0; k < CONTACT_ROWS; k++)
        to[k] = sum[k];
}

#endif
