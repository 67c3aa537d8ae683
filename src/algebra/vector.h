/* vector.h -- the vectors that SUNDIALS works with, and our own loops over y.
 *
 * Long vectors in blocks that stay in the cache, worked on by all threads, with
 * the same bits on any number of threads, because partial results belong to fixed
 * blocks and are added in their order.  Copies share their numbers until one is
 * written and sums wait until they are read, so a pointer to numbers (vector_data(),
 * vector_read() ...) is good until the next operation (N_V...) on its family.
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

#include "algebra/norm.h"
#include "algebra/sundials.h"
#include <stdbool.h>

struct ranks_route;

#define VECTOR_NOT_FINITE 1e30

/* On many ranks: entries of y that this one has, and how all ranks name an entry. */
struct vector_own {
    int pieces;
    const long (*piece)[2]; /* [from, to) ascending, disjoint; copied            */
    const void *self;
    long (*common)(const void *self, long i); /* the name of the entry i         */
    long (*here)(const void *self, long common);
};

/* n entries, all 0; NULL and a failure kept when there is no memory.  Clones
 * (N_VClone) share its norm; N_VDestroy ends each of them. */
N_Vector vector_create(long n, enum vector_norm norm, SUNContext context);

/* The numbers of v: to read and write; to read only, which is cheaper where copies
 * share them; to write all of them, whatever they were. */
double *vector_data(N_Vector v);
const double *vector_read(N_Vector v);
double *vector_overwrite(N_Vector v);

/* First entry that is NaN or infinite; -1 if there is none. */
long vector_bad(N_Vector v);

bool vector_same(N_Vector v, N_Vector w); /* bit by bit? */

/* Of the whole family: ranges [from, to) of y, disjoint, outside of which some
 * vectors are 0 (the implicit side of f); sums then pass over these in silence.
 * To be called while all of its vectors are new.  STATUS_FAILED: no memory. */
int vector_ranges(N_Vector v, int ranges, const long (*range)[2]);

/* As vector_create(), for the norm `max`: memory is there for all n entries, but of this family those
 * in the pieces alone are ever written or asked, and others take none that the machine would have
 * to find. */
N_Vector vector_create_own(long n, enum vector_norm norm, SUNContext context,
                           const struct vector_own *own);

/* v becomes what x [n] is in entries that v's family has. */
void vector_take(N_Vector v, const double *x);

void vector_only_inside(N_Vector v);      /* the caller knows it is 0 outside   */
const double *vector_inside(N_Vector v);  /* to read in the ranges alone        */

/* z is x; gives z's numbers, of which those in the ranges are to be written. */
double *vector_like(N_Vector x, N_Vector z);

/* The entry i with the largest e_i (the first that is not finite, if any) when
 * a norm was last taken in v's family; -1 before that. */
long vector_largest(N_Vector v);

/* Rows of y change places, in all vectors of v's family alike, between steps: row i of
 * a block (`components` entries each, the first at `offset`) becomes what row from[i]
 * was.  What an integrator keeps of its past thus moves along, and it notes nothing;
 * numbers stay at their addresses.  Norms and dot products keep the order of sums that
 * the rows had at first, and so their bits; of equal entries the largest, and the first
 * bad one, are still the first in that order.
 *
 * STATUS_FAILED, and nothing has changed: no memory, `from` holds a row twice, or a
 * block lies in a range of vector_ranges() only in part. */
struct vector_rows {
    long offset;
    int n, components;
    const int *from;       /* [n]; NULL: rows do not change places but ranks   */
    const struct vector_travel *travel; /* then; else NULL                     */
};

/* Rows of a block go from rank to rank.  Those of a rank are the first of its block: rows that come,
 * and some that stay, take the place of those that leave.  All ranks rearrange together, and it
 * takes no memory. */
struct vector_travel {
    struct ranks_route *route; /* numbers of a row at least components wide    */
    int leaving, coming, moving;
    const int *out;        /* rows that leave, in the order of the route       */
    const int *in;         /* where those stand that come, likewise            */
    const int *was, *now;  /* of rows that stay but move                       */
    int rows;              /* of this rank afterwards                          */
    const int *to;         /* [n] where each row of the block is then          */
    double *room;          /* [coming] rows                                    */
};
int vector_rearrange(N_Vector v, int blocks, const struct vector_rows *block);

/* The same of plain arrays that are laid out like y; NULL is passed over. */
int vector_rows_move(int blocks, const struct vector_rows *block, int arrays, double *const *x);

/* The entry that i becomes. */
long vector_rows_moved(int blocks, const struct vector_rows *block, long i);

/* to[i] = sum of c[k] x[k][i], k from 0 to terms - 1, zeros of c left out.  A
 * first term with c = 1 is added last, as a step adds small increments to y.
 * `to` may be one of x. */
void vector_combine(int terms, const double *c, const double *const *x, long n, double *to);

/* x . y; partial: room for n/1024 + 1 numbers. */
double vector_dot(long n, const double *x, const double *y, double *partial);

/* The largest |x[i] weight[i]|, of the entries of all ranks, which ask together; one that is NaN is
 * passed over. */
double vector_most(long n, const double *x, const double *weight);

void vector_copy(long n, const double *x, double *to);

/* First entry that is NaN or infinite; -1 if there is none. */
long vector_first_bad(long n, const double *x);

/* The same of all ranks, which ask together. */
long vector_bad_anywhere(long n, const double *x, const struct vector_own *own);

#endif
