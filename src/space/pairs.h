/* pairs.h -- what a pair law sees: rows of neighbours, lanes wide.
 *
 * Row k holds the k-th neighbour of each of the LANES owners.  A law is a loop
 * over rows that adds to its own sum; it is written symmetric in its two
 * sides, so that both sides of a pair come out bitwise opposite in force. */
#ifndef SPACE_PAIRS_H
#define SPACE_PAIRS_H

#include "space/kinds.h"
#include "base/lanes.h"

/* Rows of a block at most; more are sliced.  A block of 8 lanes would not stay in the
 * nearest cache with more. */
enum { PAIRS_ROWS = LANES == 8 ? 30 : 62 };

/* Rows a law asks for; r and mm are there for everybody. */
enum need {
    NEED_X = 1 << 0,     /* x                                                */
    NEED_V = 1 << 1,     /* v                                                */
    NEED_RHO = 1 << 2,   /* rho                                              */
    NEED_P2 = 1 << 3,    /* p2                                               */
    NEED_MASS = 1 << 4,  /* m                                                */
    NEED_IRHO = 1 << 5,  /* irho                                             */
    NEED_R2 = 1 << 6,    /* r2                                               */
    NEED_XV = 1 << 7,    /* xv                                               */
    NEED_GRADW = 1 << 8, /* gw                                               */
    NEED_W = 1 << 9,     /* w                                                */
    NEED_GRADW_R2 = 1 << 10, /* gw_r2                                         */
    NEED_LAPW = 1 << 11    /* lw                                              */
};

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

/* What one law adds up for its owners. */
struct sum {
    lanes f[DIM]; /* force                                         [N, 2D: N/m] */
    lanes drho;   /* own mass times rate of density     [kg * kg/m^D / s]       */
};

/* What a field adds up for its owners before there are forces. */
enum { PAIRS_FIELD = 2 + DIM };
struct field_sum {
    lanes s[PAIRS_FIELD];
};

typedef void pairs_field(const void *self, const struct side *a, const struct block *b,
                         struct field_sum *to);
typedef void pairs_law(const void *self, const struct side *a, const struct block *b,
                       struct sum *to);

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

struct kernel_use; /* kernels/kernel.h */

/* One law at work between two kinds. */
struct pairs_work {
    pairs_law *law;
    const void *self;
    const struct kernel_use *kernel;
    int slot;       /* row of the book it is accounted in                    */
    unsigned needs; /* NEED_ bits that its kernel is asked for before it; 0: the
                       rows stand as a law before left them                  */
};

enum { PAIRS_LAWS = 12 };

/* Adds what all laws of a table give on the rows of b to the sums of their slots. */
struct pairs_table;
typedef void pairs_laws(const struct pairs_table *table, const struct side *a, struct block *b,
                        struct sum *sum);

/* Everything that acts on owners of one kind from partners of one kind, in the
 * order in which sums are added; laws that share a kernel stand together. */
struct pairs_table {
    int n;
    unsigned needs; /* NEED_ bits of all of them                             */
    pairs_laws *laws; /* how they are run: plan/sum.h arranges it            */
    struct pairs_work work[PAIRS_LAWS];
};

#endif
