/* bounded.h -- the complementarity problem  x >= 0,  g = A x - b >= 0,  x . g = 0  for a
 * symmetric, positive definite A: what makes x . A x/2 - b . x smallest among x >= 0.  Some
 * unknowns may be free; of these g = 0.
 *
 *     bounded_solver_create(n, most, &solver);
 *     x >= least is a guess of the caller, residual = b - A x      (operator_apply())
 *     bounded_solve(solver, &a, least, x, residual, &report)
 *
 * MPRGP: Dostal & Schoeberl, Comput. Optim. Appl. 30 (2005) 23-43; Dostal, Optimal Quadratic
 * Programming Algorithms (2009), 5.7.  Conjugate gradients on the face of x where x > 0;
 * a step along the reduced gradient that may change face where they would leave x >= 0; a
 * step that releases zeros where the part of the gradient that wants to outweighs the rest.
 * All in unknowns that the diagonal scales, which keeps the bounds.
 *
 * Nothing is kept from one solve to the next; no bit depends on the number of threads. */
#ifndef IMPLICIT_BOUNDED_H
#define IMPLICIT_BOUNDED_H

#include "implicit/operator.h"

/* For n unknowns; a solve has at most `most` products. */
struct bounded_solver;
int bounded_solver_create(int n, int most, struct bounded_solver **out);
void bounded_solver_free(struct bounded_solver **s); /* NULL is welcome */

/* Of `a`, without bodies: apply(), diagonal and near, the 2-norm that is exact enough of what
 * comes out in `residual`: -g where x > least, max(0, -g) elsewhere.  least [n]: 0, or -INFINITY
 * of an unknown that is free; NULL: 0 for all.  STATUS_FAILED, without a failure kept: a refusal,
 * of which the report tells the cause; x is as before. */
int bounded_solve(struct bounded_solver *s, const struct operator *a, const double *least,
                  double *x, double *residual, struct operator_report *report);

#endif
