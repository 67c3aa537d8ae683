/* cholesky.h -- the incomplete Cholesky factor without fill, IC(0), of a sparse symmetric
 * matrix, to precondition with: A is about L L^T, and L has the entries that A has.
 *
 * It exists for every M-matrix, of any order of unknowns: Meijerink and van der Vorst, Math.
 * Comp. 31 (1977) 148-162.  Factor and solves go row by row on one thread: no bit depends on
 * the number of threads. */
#ifndef SOLVED_CHOLESKY_H
#define SOLVED_CHOLESKY_H

#include <stddef.h>

/* The lower part: columns of row i, ascending, below i, and the diagonal apart. */
struct cholesky {
    int n;
    const size_t *from;     /* [n+1] lent                                        */
    const int *column;      /* lent                                              */
    double *lower;          /* entries: those of A before, those of L after      */
    double *diagonal;       /* [n] of A before, 1/that of L after                */
};

/* In place.  0, or 1 + the row whose diagonal did not stay above 0: no factor. */
int cholesky_factor(struct cholesky *c);

/* x = (L L^T)^-1 b, [n]; they may be the same. */
void cholesky_solve(const struct cholesky *c, const double *b, double *x);

#endif
