/* precondition.h -- what conjugate gradients that solve for a pressure are preconditioned with: M
 * about A, symmetric and positive definite as A is.
 *
 *     const struct precondition *how = precondition_named("ic0");
 *     TRY(how->create(size, &own));
 *     how->make(own, &A, why, sizeof why);         once a matrix
 *     how->solve(own, residual, near);             once a product
 *     how->free(&own);
 *
 * Nothing is kept from one matrix to the next, and no bit depends on the number of threads. */
#ifndef SOLVED_PRECONDITION_H
#define SOLVED_PRECONDITION_H

#include <stddef.h>

/* Sparse and symmetric, lent: the diagonal apart, entries of row i off it in ascending columns. */
struct precondition_matrix {
    int n;
    const double *diagonal; /* [n]                                             */
    const size_t *from;     /* [n+1]                                           */
    const int *column;
    const double *value;
};

struct precondition {
    const char *name;  /* as mps.preconditioner has it                         */
    const char *lacks; /* why this program has none of it, and what to do; NULL: it has */
    double row, entry; /* about what it takes [bytes] of an unknown, of an entry */

    int (*create)(int size, void **out); /* for at most `size` unknowns        */
    void (*free)(void **self);           /* NULL in it is welcome              */

    /* STATUS_FAILED: there is none of this matrix, or no memory; why [size] has the reason. */
    int (*make)(void *self, const struct precondition_matrix *a, char *why, size_t size);

    /* near = M^-1 residual, [n] of the matrix that it was made of; lent then still. */
    void (*solve)(void *self, const double *residual, double *near);
};

extern const struct precondition precondition_ic0, precondition_multigrid;

/* NULL: there is none of that name. */
const struct precondition *precondition_named(const char *name);

#endif
