/* poisson.h -- the Poisson equation of pressure between particles, as a sparse symmetric matrix,
 * solved by preconditioned conjugate gradients.
 *
 *     sum over j of a_ij (p_i - p_j) + e_i p_i = b_i                             (M7)
 *
 * over unknowns; where a neighbour is at a surface, p_j = 0 and the term stays in the diagonal
 * alone, so that the matrix stays symmetric; dummies are left out, dp/dn = 0.  Unknowns are
 * numbered by place. */
#ifndef SOLVED_POISSON_H
#define SOLVED_POISSON_H

#include "implicit/operator.h"
#include "solved/near.h"
#include "solved/precondition.h"

enum poisson_role { POISSON_DUMMY, POISSON_SURFACE, POISSON_UNKNOWN };

/* a_ij at the distance r, 0 where they do not meet [1/m^2]. */
typedef double poisson_weight(const void *self, double r);

struct poisson {
    int n;                 /* places, unknowns or not                              */
    double *diagonal;      /* [n] of A; 1 where there is no unknown                */
    size_t *from;          /* [n+1] entries of row i off the diagonal, ascending   */
    int *column;
    double *value;
    double *residual;      /* [n] scratch of a solve                               */
    const struct precondition *how;
    void *own;             /* of `how`                                             */
    struct operator_solver *solver;
    size_t room;
    int size, iterations;  /* particles that there can be; products allowed        */
    int *queue;            /* [size] scratch: lengths of rows; places to go on from */
    bool *tied;            /* [size] is there a surface that p is measured from?   */
    char why[120];         /* a solve was refused                                  */
};

/* For at most `size` particles and so many products in a solve, preconditioned so. */
int poisson_create(int size, int iterations, const struct precondition *how, struct poisson *out);
void poisson_free(struct poisson *s);

/* Makes the matrix; e [1/m^2] of all.  STATUS_FAILED: no memory. */
int poisson_assemble(struct poisson *s, const struct near *near, const char *role,
                     poisson_weight *weight, const void *self, double e);

/* The place of an unknown that no chain of unknowns joins to a surface, and how many it is
 * joined to; -1: there is none. */
int poisson_loose(struct poisson *s, const char *role, int *joined);

/* p comes in as a guess, 0 where there is no unknown, as b.  Ends when the residual is
 * `exact` times b.  STATUS_FAILED: a refusal, see `why`. */
int poisson_solve(struct poisson *s, const double *b, double exact, double *p,
                  struct operator_report *report);

#endif
