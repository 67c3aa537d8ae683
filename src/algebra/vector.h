/* vector.h -- the vectors that SUNDIALS works with, and our own loops over y.
 *
 * SUNDIALS' serial vector with the operations of a step replaced: cut into
 * blocks that stay in the cache, run by all threads when they are long, and
 * giving the same bits on any number of threads, because partial results
 * belong to fixed blocks and are added in their order.
 *
 * The norm of error tests is one of three, inherited by clones.  With e_i =
 * |v_i w_i| over n entries:
 *
 *     max   max e_i                      does not depend on n
 *     p8    (1/n sum e_i^8)^(1/8)        dilutes like n^(1/8)
 *     wrms  (1/n sum e_i^2)^(1/2)        dilutes like n^(1/2)
 *
 * All of them see a NaN or infinity in any entry, whatever its weight, and then
 * are VECTOR_NOT_FINITE, which no error test lets pass. */
#ifndef ALGEBRA_VECTOR_H
#define ALGEBRA_VECTOR_H

#include "algebra/sundials.h"
#include <stdbool.h>

enum vector_norm { VECTOR_NORM_MAX, VECTOR_NORM_P8, VECTOR_NORM_WRMS };

#define VECTOR_NOT_FINITE 1e30

/* n entries, all 0; NULL and a failure kept when there is no memory.  Clones
 * (N_VClone) share its norm; N_VDestroy ends each of them. */
N_Vector vector_create(long n, enum vector_norm norm, SUNContext context);

double *vector_data(N_Vector v);

/* The entry i with the largest e_i (the first that is not finite, if any) when
 * a norm was last taken in v's family; -1 before that. */
long vector_largest(N_Vector v);

/* to[i] = sum of c[k] x[k][i], k from 0 to terms - 1, zeros of c left out.  A
 * first term with c = 1 is added last, as a step adds small increments to y.
 * `to` may be one of x. */
void vector_combine(int terms, const double *c, const double *const *x, long n, double *to);

void vector_copy(long n, const double *x, double *to);

/* First entry that is NaN or infinite; -1 if there is none. */
long vector_first_bad(long n, const double *x);

#endif
