/* release-inside.h -- the pressure of a release, as the files of its solve see it.
 *
 * Vectors are by place of the pair list, fluid first: [fluid], [n] with solids, [places] with
 * images and the dummy, too. */
#ifndef IMPLICIT_RELEASE_INSIDE_H
#define IMPLICIT_RELEASE_INSIDE_H

#include "eval/inside.h"
#include "implicit/operator.h"
#include "matter/eos.h"
#include "space/nabla.h"

/* One linear system. */
struct release_solve {
    double *x, *residual, *image, *scratch; /* [n]                               */
    struct operator operator;
    struct operator_solver *solver;
};

struct release {
    struct moment *m;
    const struct nabla_engine *nabla;
    const struct eos *eos;
    struct nabla_job job, beside;   /* all pairs; those of fluid and solids      */
    unsigned meets[KINDS], meets_beside[KINDS], kinds;
    int n, fluid;       /* particles in the list; of the fluid: unknowns         */
    double tau;         /* [s] in which sound goes through all fluid             */
    double *P;          /* [n] p/rho^2                                           */
    double *drive;      /* [n] D a by all but the pressure                       */
    double *rate;       /* [n] D a, of the fluid S^T D a                         */
    double *weight;     /* [n] of all fluid around a solid's particle            */
    double *still;      /* [fluid] E/tau^2                                       */
    double *diagonal;   /* [fluid] about that of the operator                    */
    bool *parts;        /* [fluid] P = 0, and the fluid parts there              */
    double *scalar, *vector; /* [places], [places][NABLA_STRIDE]                 */
    double *ydot;       /* [size] rates by all but the pressure                  */
    double *modes;      /* [2][unknowns of any body] scratch                     */
    struct release_solve solve;
};

/* release-operator.c: after an evaluation at y.  Makes drive and operator. */
int release_assemble(struct release *r, const double *y);

/* to [n] = D M^-1 G x. */
void release_multiply(struct release *r, const double *x, double *to);

/* x [n] of the fluid goes on to solids, x = S x; by the transpose back, x = S^T x.  Weights
 * of pairs are |gradW|^2. */
void release_extend(struct release *r, double *x);
void release_gather(struct release *r, double *x);

#endif
