/* band.h -- symmetric banded matrices and their solves, on GSL.
 *
 *     band_create(n, half, &a);              a is zero, |i - j| <= half is kept
 *     band_add(a, i, j, value);              assembles; (i, j) stands for (j, i) too
 *     band_factor_create(n, half, &f);       all memory is taken here
 *     TRY(band_factor_set(f, a));            Cholesky, or LU if not positive definite
 *     band_factor_solve(f, x);               x comes in as the right side
 *
 * n = 0 is a matrix like any other: nothing happens.  GSL's error handler is
 * off while these functions run, whatever the caller has set. */
#ifndef ALGEBRA_BAND_H
#define ALGEBRA_BAND_H

#include <stdbool.h>

struct band {
    int n, half; /* rows; diagonals below the main one, at most n - 1           */
    double *a;   /* [n][half + 1]: a[j (half + 1) + k] is the entry (j + k, j)  */
};

int band_create(int n, int half, struct band **out);
void band_free(struct band **b); /* NULL is welcome */

void band_add(struct band *b, int i, int j, double value);
double band_at(const struct band *b, int i, int j); /* 0 outside the band */

/* Adds the symmetric block e [m][m] with its corner at (first, first). */
void band_add_block(struct band *b, int first, int m, const double *e);

/* Takes unknown i out: its row and column become 0, its diagonal `diagonal`. */
void band_hold(struct band *b, int i, double diagonal);

/* to = ca a + cb b: three matrices of one shape. */
void band_sum(struct band *to, double ca, const struct band *a, double cb,
              const struct band *b);

void band_multiply(const struct band *b, const double *x, double *y); /* y = B x   */
double band_form(const struct band *b, const double *x);              /* x . B x   */

struct band_factor; /* room for one factorization */

int band_factor_create(int n, int half, struct band_factor **out);
void band_factor_free(struct band_factor **f); /* NULL is welcome */

/* Factorizes; STATUS_FAILED when the matrix is singular or not finite. */
int band_factor_set(struct band_factor *f, const struct band *b);

/* The same of a matrix that is not symmetric, by LU: b + s, where entry (i, j) of s below
 * the diagonal stands for -(j, i), and its diagonal for nothing. */
int band_factor_set_skew(struct band_factor *f, const struct band *b, const struct band *s);

/* True if Cholesky went through; changes f, which then may only be set anew. */
bool band_factor_definite(struct band_factor *f, const struct band *b);

void band_factor_solve(const struct band_factor *f, double *x); /* in place */

#endif
