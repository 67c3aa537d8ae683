/* operator.h -- a symmetric, positive definite operator A, and the solve A x = b by the
 * conjugate gradients of SUNDIALS, SUNLinSol_PCG.
 *
 *     operator_solver_create(operator_size(&a), most, &solver);
 *     x is a guess of the caller, residual = b - A x         (operator_apply())
 *     if (operator_solve(solver, &a, x, residual, &report) != STATUS_DONE)
 *         operator_refusal(&report, text, sizeof text);
 *
 * An operator says how to multiply, not where its matrix is: coefficients stored over pairs
 * (plan/couple.h) are one way to have an apply(), two passes over pairs another, as for
 * J M^-1 J^T, whose wide stencil is better not stored.
 *
 * x has `n` unknowns of the operator's own, A0 x in apply(), and bodies bring blocks, B
 * square and C rectangular, [n][body's unknowns].  With unknowns that stand in x, behind
 * the operator's own and in the order of bodies, or with unknowns that are eliminated:
 *
 *     | A0   C |                             A0 + C B^-1 C^T
 *     | C^T  B |
 *
 * Nothing is kept from one solve to the next, so that what is solved for is a function of
 * A, b and the guess alone; no bit depends on the number of threads when no apply()'s does. */
#ifndef IMPLICIT_OPERATOR_H
#define IMPLICIT_OPERATOR_H

#include <stdbool.h>
#include <stddef.h>

struct operator_body {
    void *self;
    int n;           /* unknowns                                               */
    bool eliminated; /* else they stand in x                                   */

    /* Where they stand in x: to = B x, [n] each.  Comes after the operator's apply() of the
     * same x; when that has left C^T x to it, this adds it, and there is no gather(). */
    void (*apply)(void *self, const double *x, double *to);

    /* In place: B^-1 v, exactly when unknowns are eliminated; else about that, or about the
     * body's block of A^-1, symmetric and positive definite: it preconditions. */
    void (*solve)(void *self, double *v);

    /* How large a correction is [as the operator's own unknowns]; of unknowns in x. */
    double (*largest)(void *self, const double *v);

    /* C, both or none: to [operator's n] += C v; v [n] += C^T x. */
    void (*spread)(void *self, const double *v, double *to);
    void (*gather)(void *self, const double *x, double *v);
};

/* Where a solve stands. */
struct operator_progress {
    int products;      /* so far                                               */
    double correction; /* largest of M^-1 r, M the preconditioner, r the residual */
    double work;       /* r . M^-1 r                                           */
};

struct operator {
    void *self;
    int n, width;           /* own unknowns, a multiple of width               */
    const double *diagonal; /* [n / width] about A's, each for `width` unknowns
                               that stand together                             */
    double near;            /* residual [2-norm] that is exact enough; 0: enough() says */
    int bodies;
    const struct operator_body *body; /* [bodies]                              */
    double *modes;          /* [unknowns of eliminated bodies] scratch; NULL: none */
    double *image;          /* [n] scratch for temper(); NULL: none            */

    /* to [n] = A0 x; where bodies' unknowns stand in x, it may read those, too, and add
     * C of them at once. */
    void (*apply)(void *self, const double *x, double *to);

    /* In place: v of all eliminated bodies, one after the other, by (B + C^T D^-1 C)^-1 with
     * D the diagonal, or by the inverse of a little more than that.  The preconditioner is
     * then the inverse of D + C B^-1 C^T; without it light bodies take many more products.
     * NULL: the diagonal alone. */
    void (*temper)(void *self, double *v);

    /* near = M^-1 residual, M about A, symmetric and positive definite; then there are no
     * bodies.  NULL: M is the diagonal, tempered, and what bodies bring. */
    void (*precondition)(void *self, const double *residual, double *near);

    /* Exact enough?  Asked before each product.  NULL: see near. */
    bool (*enough)(void *self, const struct operator_progress *at);

    /* Directions in which caller solved before, and which rounding must not bring back:
     * takes them out of a residual, and, by A, out of a direction.  NULL: none. */
    void (*clear)(void *self, double *residual);
    void (*leave)(void *self, double *v);
};

enum operator_cause { OPERATOR_SOLVED, OPERATOR_TOO_MANY, OPERATOR_NOT_FINITE,
                      OPERATOR_NOT_POSITIVE, OPERATOR_BROKEN };

struct operator_report {
    enum operator_cause cause;
    int products;
    double residual;   /* its 2-norm at the end over that at the start          */
    double correction; /* see struct operator_progress, when last asked         */
};

int operator_size(const struct operator *a); /* entries of x */

/* to = A x, [operator_size()] each. */
void operator_apply(const struct operator *a, const double *x, double *to);

/* For `size` unknowns; a solve has at most so many products. */
struct operator_solver;
int operator_solver_create(int size, int most, struct operator_solver **out);
void operator_solver_free(struct operator_solver **s); /* NULL is welcome */

/* x and its residual come in, better ones go out.  STATUS_FAILED, without a failure kept:
 * a refusal, of which the report tells the cause; x is as before. */
int operator_solve(struct operator_solver *s, const struct operator *a, double *x,
                   double *residual, struct operator_report *report);

/* "after 12 products its residual is 0.3 of the first: ..." */
void operator_refusal(const struct operator_report *report, char *text, size_t size);

#endif
