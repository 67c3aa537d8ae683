/* solver.h -- the implicit side of a law between particles: one const struct, which
 * plan_create() picks and a moment calls. */
#ifndef PLAN_SOLVER_H
#define PLAN_SOLVER_H

#include "plan/plan.h"

struct moment;

struct plan_solver {
    int vectors; /* of the fluid's velocities that it holds, for an estimate of memory */

    /* Refuses (BAD_SCENE) what cannot be solved for together. */
    int (*agree)(const struct plan *plan);

    /* What it works in, for a run's moment; free() takes NULL. */
    int (*create)(struct moment *m, void **out);
    void (*free)(void **self);

    /* What earlier solves have left behind, guesses above all: solves begin as a first one. */
    void (*forget)(void *self);

    /* f_I of the law at (t, y) alone; or both sides of f in one pass over pairs, but for
     * the stiff side of bodies.  STATUS_FAILED: a refusal. */
    int (*rates)(struct moment *m, double t, const double *y, double *ydot);
    int (*sides)(struct moment *m, double t, const double *y, double *explicit,
                 double *implicit);

    /* As moment_solve(), of all that is implicit; and its tolerance. */
    int (*solve)(struct moment *m, double t, double gamma, const double *r, double *z);
    void (*exact)(void *self, double tol);

    /* Row i of the fluid becomes what row from[i] was. */
    int (*rearrange)(struct moment *m, const int *from);
};

/* A pressure that is solved for: one there is. */
struct plan_ahead_solver {
    int vectors; /* of all particles that it holds, for an estimate of memory */

    /* What it works in, for a run's moment; free() takes NULL. */
    int (*create)(struct moment *m, void **out);
    void (*free)(void **self);

    /* What earlier solves have left behind: the next begins as a first one. */
    void (*forget)(void *self);

    /* p/rho^2 into the records of m, for accelerations by all but the pressure udot [fluid]
     * [dimension].  STATUS_FAILED: a refusal. */
    int (*find)(void *self, struct moment *m, double t, const double *udot);
};

extern const struct plan_ahead_solver implicit_ahead; /* implicit/ahead.c */
extern const struct plan_solver implicit_viscous; /* implicit/viscous.c */

#endif
