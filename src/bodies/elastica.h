/* elastica.h -- M q'' + D q' + dE/dq = F of a beam of equal elements that bends far.
 *
 * Four degrees of freedom a node (elastica-element.h), nodes from the root (0) to the tip,
 * component 0 along the straight beam and 1 across; F holds what does work on them.  M and
 * D are those of the linear beam (bending.h), once for each component; but what beta damps is
 * the rate at which the beam bends (elastica-friction.h).  Ends take degrees
 * of freedom away: those stay in the vectors as entries that nothing moves ("held").
 * Per metre of width in 2D. */
#ifndef BODIES_ELASTICA_H
#define BODIES_ELASTICA_H

#include "algebra/band.h"
#include "bodies/bending.h"
#include "bodies/elastica-element.h"

struct elastica_def {
    struct bending_def bending; /* length, EI, mass, ends; its beta is that of (BE7)  */
    double EA;                  /* axial stiffness [N, 2D: N/m]                       */
    double thickness, speed;    /* scales of deflection and its rate [m], [m/s]       */
    const char *path;           /* for messages, stays where it is                    */
};

struct elastica {
    struct elastica_def def;
    int dofs;                   /* 4 (elements + 1)                                   */
    double l;                   /* length of an element [m]                           */
    double fastest;             /* frequency that none exceeds at rest [rad/s]        */
    double decay;               /* largest v . D v / v . M v [1/s]                    */
    struct elastica_element element;
    struct bending *plane;      /* the linear beam: mass, frequencies                 */
    struct band *mass;          /* all degrees of freedom                             */
    struct band_factor *mass_factor; /* held ones taken out                           */
};

struct elastica_work { /* scratch */
    struct band *tangent, *sum;
    struct band *skew;          /* beside sum, where beta makes it not symmetric      */
    struct band_factor *factor;
    double *vector;             /* [3][dofs]                                          */
};

/* Each takes all memory it will ever need; the beam is const from there on, a work is for
 * one caller at a time.  Free with elastica_free(&e), elastica_work_free(&w). */
int elastica_create(const struct elastica_def *def, struct elastica **out);
void elastica_free(struct elastica **e); /* NULL is welcome */
int elastica_work_create(const struct elastica *e, struct elastica_work **out);
void elastica_work_free(struct elastica_work **w); /* NULL is welcome */

bool elastica_held(const struct elastica *e, int dof);

/* Entry of the vectors that shape k of an element carries for component c. */
static inline int elastica_at(int element, int k, int c)
{
    return ELASTICA_NODE * element + elastica_entry(k, c);
}

/* to [dofs] = dE/dq + D v, rows of held degrees of freedom included. */
void elastica_resist(const struct elastica *e, struct elastica_work *w, const double *q,
                     const double *v, double *to);

/* Takes held degrees of freedom out of w->sum. */
void elastica_hold(const struct elastica *e, struct elastica_work *w);

/* d2E/dq2 at q into w->tangent, held ones included. */
void elastica_tangent(const struct elastica *e, struct elastica_work *w, const double *q);

/* f [dofs]: forces come in, accelerations M^-1 f go out; held ones are 0. */
void elastica_accelerate(const struct elastica *e, double *f);

/* The same by (M + tau D + tau^2 K)^-1, with D at q and K that of elastica_element_stiffness():
 * symmetric, positive definite.  set() makes w ready for any number of calls; stretch() then adds
 * tau K v to `to` [dofs].  STATUS_FAILED: the matrix is not finite.  elastica-yield.c. */
int elastica_yield_set(const struct elastica *e, struct elastica_work *w, double tau,
                       const double *q);
void elastica_yield_stretch(const struct elastica *e, struct elastica_work *w, double tau,
                            const double *v, double *to);
void elastica_yield(const struct elastica *e, const struct elastica_work *w, double *f);

/* Solves z - gamma f_I(z) = r with f_I = (v, -M^-1 (dE/dq + D v)) by Newton's method: a
 * guess of z_q comes in through q, z goes out; held entries get those of r.
 * STATUS_FAILED: no solution was found within ELASTICA_ITERATIONS. */
enum { ELASTICA_ITERATIONS = 25 };
int elastica_solve(const struct elastica *e, struct elastica_work *w, double gamma,
                   const double *rq, const double *rv, double *q, double *v);

/* Adds to f [dofs] a uniform load across the beam [N/m, 2D: N/m^2] and a force across its
 * tip [N, 2D: N/m], which turn with it. */
void elastica_follow(const struct elastica *e, double load, double tip, const double *q,
                     double *f);

double elastica_kinetic(const struct elastica *e, const double *v); /* [J, 2D: J/m]        */
double elastica_elastic(const struct elastica *e, const double *q); /* [J, 2D: J/m]        */
double elastica_damping(const struct elastica *e, const double *q,
                        const double *v);                           /* power, <= 0 [W, ..] */

#endif
