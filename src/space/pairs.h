/* pairs.h -- what a pair law sees: rows of neighbours, lanes wide.
 *
 * Row k holds the k-th neighbour of each of the LANES owners.  A law is a loop
 * over rows that adds to its own sum; it is written symmetric in its two
 * sides, so that both sides of a pair come out bitwise opposite in force. */
#ifndef SPACE_PAIRS_H
#define SPACE_PAIRS_H

#include "base/lanes.h"
#include "space/laws.h"

/* Rows of a block at most; more are sliced.  A block of 64-byte lanes would not stay in
 * the nearest cache with more. */
enum { PAIRS_ROWS = sizeof(lanes) == 64 ? 30 : 62 };

/* The owners' own values. */
struct side {
    lanes x[DIM], v[DIM]; /* position [m], velocity [m/s]                    */
    lanes rho, p2;        /* density [kg/m^D], p/rho^2                       */
    lanes m, irho;        /* mass [kg], 1/rho                                */
};

struct block {
    int n;                     /* rows in use, <= PAIRS_ROWS                 */
    lanes x[DIM][PAIRS_ROWS];  /* x_a - x_b                        [m]       */
    lanes v[DIM][PAIRS_ROWS];  /* v_a - v_b                        [m/s]     */
    lanes r2[PAIRS_ROWS];      /* r^2                              [m^2]     */
    lanes r[PAIRS_ROWS];       /* r, always there                  [m]       */
    lanes mm[PAIRS_ROWS];      /* m_a m_b, always there            [kg^2]    */
    lanes xv[PAIRS_ROWS];      /* x . v                            [m^2/s]   */
    lanes gw[PAIRS_ROWS];      /* m_a m_b W'(r)/r, 0 beyond the support      */
    lanes gw_r2[PAIRS_ROWS];   /* gw / (r^2 + 0.01 hs^2), hs half the support */
    lanes w[PAIRS_ROWS];       /* m_a m_b W(r), 0 beyond the support         */
    lanes lw[PAIRS_ROWS];      /* m_a m_b lap W(r), 0 beyond the support     */
    lanes rho[PAIRS_ROWS], p2[PAIRS_ROWS], m[PAIRS_ROWS], irho[PAIRS_ROWS]; /* of b */
};

/* What a law sees of one row: a loop over rows that several laws share holds it in
 * registers.  Members are those of struct block. */
struct row {
    lanes x[DIM], v[DIM];
    lanes r2, xv, gw, gw_r2, rho, p2, irho;
};

/* Row k of b; what is not looked at is not even loaded. */
LANES_INLINE struct row pairs_row(const struct block *b, int k)
{
    struct row row = {
        .r2 = b->r2[k], .xv = b->xv[k], .gw = b->gw[k], .gw_r2 = b->gw_r2[k],
        .rho = b->rho[k], .p2 = b->p2[k], .irho = b->irho[k],
    };

    for (int d = 0; d < DIM; d++) {
        row.x[d] = b->x[d][k];
        row.v[d] = b->v[d][k];
    }
    return row;
}

/* What a row of a block holds, but for what kernels give. */
struct whole_row {
    struct row pair;      /* gw and gw_r2 are not filled                     */
    lanes r, mm, m;
};

/* What one law adds up for its owners. */
struct sum {
    lanes f[DIM]; /* force                                         [N, 2D: N/m] */
    lanes drho;   /* own mass times rate of density     [kg * kg/m^D / s]       */
};

/* What a summed density adds up for its owners before there are forces. */
struct field_sum {
    lanes s[PAIRS_FIELD];
};

/* A law on one row. */
typedef void pairs_row_law(const void *self, const struct side *a, const struct row *b,
                           struct sum *to);

/* A law on all rows of b; `law` is a constant, so that it is copied into the loop. */
LANES_INLINE void pairs_rows(pairs_row_law *law, const void *self, const struct side *a,
                             const struct block *b, struct sum *to)
{
    struct sum t = *to; /* registers, not memory */

    for (int k = 0; k < b->n; k++) {
        const struct row row = pairs_row(b, k);
        law(self, a, &row, &t);
    }
    *to = t;
}

#endif
