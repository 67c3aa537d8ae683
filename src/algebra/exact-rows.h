/* exact-rows.h -- rows of lanes for an exact sum, cut while they are near.
 *
 *     exact_rows_open(&rows);
 *     exact_rows_add(&rows, row);            at most EXACT_ROWS times
 *     exact_rows_close(&rows, &cut, &sum);
 *
 * exact-sum.c looks for the largest term, cuts each in two at places chosen for it, and
 * adds up the parts.  Here the places are those that would have served the rows of last
 * time, so nothing needs to be looked at first.  That costs no bit: cut anywhere, the
 * parts of a term are the term.  Rows that the places do not serve (too large, too fine,
 * not finite) go to exact-sum.c. */
#ifndef ALGEBRA_EXACT_ROWS_H
#define ALGEBRA_EXACT_ROWS_H

#include "algebra/exact-sum.h"
#include "base/lanes.h"

enum {
    EXACT_ROWS = 128 / LANES
};

struct exact_rows {
    int n;
    lanes row[EXACT_ROWS];
};

/* What becomes of the terms of all rows. */
struct exact_rows_parts {
    lanes high, low;       /* sums of parts                                    */
    lanes most;            /* largest |term|                                   */
    lanes_mask rest;       /* bits of what is left of terms                    */
};

LANES_INLINE void exact_rows_open(struct exact_rows *rows)
{
    rows->n = 0;
}

LANES_INLINE void exact_rows_add(struct exact_rows *rows, lanes x)
{
    rows->row[rows->n++] = x;
}

/* Where several are filled side by side, one count serves all: row k of them, and in the end
 * that there are n. */
LANES_INLINE void exact_rows_put(struct exact_rows *rows, int k, lanes x)
{
    rows->row[k] = x;
}

LANES_INLINE void exact_rows_count(struct exact_rows *rows, int n)
{
    rows->n = n;
}

/* Sums stay in registers: kept in memory from row to row they would be waited for. */
LANES_INLINE struct exact_rows_parts exact_rows_cut(const struct exact_rows *rows,
                                                    const struct exact_cut *cut)
{
    const lanes coarse = lanes_all(cut->coarse), fine = lanes_all(cut->fine);
    struct exact_rows_parts to = { { 0 }, { 0 }, { 0 }, { 0 } };

    for (int k = 0; k < rows->n; k++) {
        const lanes x = rows->row[k];
        const lanes high = (x + coarse) - coarse, finer = x - high;
        const lanes low = (finer + fine) - fine;

        to.high += high;
        to.low += low;
        to.most = lanes_max((lanes)((lanes_mask)x & __LONG_LONG_MAX__), to.most);
        to.rest |= (lanes_mask)(finer - low);
    }
    return to;
}

LANES_INLINE void exact_rows_close(const struct exact_rows *rows, struct exact_cut *cut,
                                   struct exact_sum *sum)
{
    const struct exact_rows_parts all = exact_rows_cut(rows, cut);
    double part[2] = { 0, 0 }, most = 0;
    long long rest = 0;

    for (int l = 0; l < LANES; l++) {
        part[0] += all.high[l];
        part[1] += all.low[l];
        most = all.most[l] > most ? all.most[l] : most;
        rest |= all.rest[l];
    }
    if (rest == 0 && most <= cut->limit) {
        exact_sum_terms(sum, 2, part);
    } else {
        exact_sum_add(sum, (long)rows->n * LANES, (const double *)rows->row);
        exact_sum_choose(cut, most);
    }
}

#endif
