/* ahead.h -- the system of a pressure that looks ahead, (E3), for P = p/rho^2 of the fluid and
 * of solids with a density of their own:
 *
 *   (E + tau^2 D M^-1 G) P = m (rho - rho0) + tau D v + tau^2 (D a + C v),  E = m rho^2/c0^2
 *
 * D, G, C of space/nabla.h; a: accelerations by all but the pressure, of walls those of their
 * motion; M^-1 is 0 for walls.  By (D1) m rho' = D v, and the force is -G P with G the
 * transpose of D, so the system is symmetric and positive definite, at free surfaces and in
 * closed tanks alike.
 *
 * Without tension (eos.tension = false) it is a complementarity problem: P >= 0, the left side
 * is not less than the right one, and is equal to it wherever P > 0. */
#ifndef IMPLICIT_AHEAD_H
#define IMPLICIT_AHEAD_H

#include "eval/inside.h"
#include "implicit/bounded.h"
#include "implicit/operator.h"
#include "matter/eos.h"
#include "space/nabla-kept.h"

/* Vectors are by place of the list: [n] particles, [places] with images and the dummy. */
struct ahead {
    struct moment *m;          /* of the last find()                          */
    struct nabla_job job;
    struct nabla_kept kept;    /* weights of the pairs at the positions of a solve  */
    unsigned meets[KINDS], kinds;
    int n, listed;             /* all particles; those in the list, without images */
    size_t places, pairs, groups;           /* there is room for             */
    double tau, residual_share;
    double *P, *residual, *b, *term;        /* [n]                            */
    double *still, *diagonal;               /* [n] E, that of the system      */
    double *scalar, *vector;                /* [places], [places][NABLA_STRIDE] */
    struct operator operator;
    struct operator_solver *solver;         /* NULL: with bounds         */
    struct bounded_solver *bounded;         /* P >= 0; NULL: with tension */
};

/* ahead-operator.c: right-hand side b and operator at a->m, for accelerations udot [fluid]
 * [DIM]. */
void ahead_assemble(struct ahead *a, const double *udot);

#endif
