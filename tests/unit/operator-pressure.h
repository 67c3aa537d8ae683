/* operator-pressure.h -- for tests: the operator of a pressure that is solved for,
 *
 *     A = 1/(rho0 c^2) + tau^2 ( J rho0^-1 J^T + J_s S B^-1 S^T V J_s^T ),
 *     (J a)_i = sum over j of V (a_i - a_j) . grad W_ij,   V = dx^D,
 *
 * on the pair list of a tank: p of all that is listed, by slot; accelerations of the fluid
 * and, by way of a beam's modes, of its skin; walls stand still.  Nothing of it is stored:
 * J^T and J are two passes over pairs, with vectors as weights. */
#ifndef TESTS_UNIT_OPERATOR_PRESSURE_H
#define TESTS_UNIT_OPERATOR_PRESSURE_H

#include "eval/inside.h"
#include "implicit/operator.h"

#include <gsl/gsl_matrix.h>

struct pressure {
    struct moment *moment;
    const struct list *list;
    int n;                /* unknowns                                          */
    double volume, least; /* V; 1/(rho0 c^2)                                   */
    double rho0, tau;
    double *diagonal;     /* [n]                                               */
    double *a;            /* [n][DIM] scratch                                  */
    double (*points)[DIM], *modes, *image; /* scratch for a beam               */
    gsl_matrix *tempered; /* factored, of the beam's unknowns                  */
    struct operator operator;
    struct operator_body body;
};

/* At y of the tank; with its beam, whose block is M + gamma D + gamma^2 K, or without. */
void pressure_make(struct pressure *p, struct moment *m, const double *y, double stiffness,
                   bool beam, double gamma);

/* Preconditions with the beam. */
void pressure_temper(struct pressure *p, double gamma);
void pressure_free(struct pressure *p);

/* grad W of slots i and j, [DIM]. */
void pressure_gradient(const struct pressure *p, int i, int j, double g[DIM]);

/* f_k = sum of V (x_k + x_j) grad W_kj for owners of these kinds, 0 for others;
 * to_i += c sum of V (a_i - a_j) . grad W_ij. */
void pressure_down(const struct pressure *p, unsigned kinds, const double *x, double *f);
void pressure_up(const struct pressure *p, double c, const double *a, double *to);

#endif
