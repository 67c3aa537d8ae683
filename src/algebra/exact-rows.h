/* exact-rows.h -- rows of lanes for an exact sum, cut while they are in registers.
 *
 *     exact_rows_open(&rows, &cut);
 *     exact_rows_add(&rows, row);            at most EXACT_ROWS times
 *     exact_rows_close(&rows, &cut, &sum);
 *
 * exact-sum.c looks for the largest term, cuts each in two at places chosen for it, and
 * adds up the parts.  Here the places are those that would have served the rows of last
 * time, so nothing needs to be looked at first.  That costs no bit: cut anywhere, the
 * parts of a term are the term.  Rows that the places do not serve (too large, too fine,
 * not finite) are kept, and go to exact-sum.c when the rows are closed. */
#ifndef ALGEBRA_EXACT_ROWS_H
#define ALGEBRA_EXACT_ROWS_H

#include "algebra/exact-sum.h"
#include "base/lanes.h"

enum {
    EXACT_ROWS = 128 / LANES
};

struct exact_rows {
    lanes coarse, fine;    /* constants that cut                               */
    lanes high, low;       /* sums of parts                                    */
    lanes most;            /* largest |term|                                   */
    lanes_mask rest;       /* bits of what is left of terms                    */
    int n;
    lanes row[EXACT_ROWS];
};

LANES_INLINE void exact_rows_open(struct exact_rows *rows, const struct exact_cut *cut)
{
    rows->coarse = lanes_all(cut->coarse);
    rows->fine = lanes_all(cut->fine);
    rows->high = rows->low = rows->most = (lanes){ 0 };
    rows->rest = (lanes_mask){ 0 };
    rows->n = 0;
}

LANES_INLINE void exact_rows_add(struct exact_rows *rows, lanes x)
{
    const lanes size = (lanes)((lanes_mask)x & __LONG_LONG_MAX__);
    const lanes high = (x + rows->coarse) - rows->coarse, finer = x - high;
    const lanes low = (finer + rows->fine) - rows->fine;

    rows->row[rows->n++] = x;
    rows->high += high;
    rows->low += low;
    rows->most = lanes_max(size, rows->most);
    rows->rest |= (lanes_mask)(finer - low);
}

LANES_INLINE void exact_rows_close(const struct exact_rows *rows, struct exact_cut *cut,
                                   struct exact_sum *sum)
{
    double part[2] = { 0, 0 }, most = 0;
    long long rest = 0;

    for (int l = 0; l < LANES; l++) {
        part[0] += rows->high[l];
        part[1] += rows->low[l];
        most = rows->most[l] > most ? rows->most[l] : most;
        rest |= rows->rest[l];
    }
    if (rest == 0 && most <= cut->limit) {
        exact_sum_terms(sum, 2, part);
    } else {
        exact_sum_add(sum, (long)rows->n * LANES, (const double *)rows->row);
        exact_sum_choose(cut, most);
    }
}

#endif
