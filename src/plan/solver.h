/* solver.h -- what is solved for: the implicit side of a law between particles, a pressure
 * within a right-hand side, a pressure once a step.  One const struct each, which plan_create()
 * picks; a moment calls the first two, the method of its name the third. */
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
     * [dimension], and such forces on skins in m->work->f.  STATUS_FAILED: a refusal. */
    int (*find)(void *self, struct moment *m, double t, const double *y, const double *udot);

    /* Power of the decay that the last find() leads to, below 0 but for a shock [W]. */
    double (*power)(const void *self);
};

/* A pressure that is solved for once a step, by the method of that name. */
enum { PLAN_SOLVED_WORKS = 4 };
struct plan_solved {
    const char *name;

    /* Columns of the book for energy that its corrections gave, NULL-ended; they are there where
     * the scene names the method: plan_book.solved. */
    const char *work[PLAN_SOLVED_WORKS + 1];

    /* NULL, or why there is no such pressure in this plan. */
    const char *(*serves)(const struct plan *plan);

    /* What it works in, for a run's moment; free() takes NULL. */
    int (*create)(struct moment *m, void **out);
    void (*free)(void **self);
    double (*memory)(const struct plan *plan); /* of that, about, on a full lattice [bytes] */

    /* Longest step from (t, y), where rates are f, with this CFL number [s]; sets limit. */
    double (*length)(void *self, double number, double t, const double *y, const double *f,
                     struct limit *limit);

    /* `to` at t + h from y at t, where rates are f; rates: scratch, or, where the method's own
     * file says so, rates of the whole step.  Each is [size].  STATUS_FAILED: no memory, or a
     * refusal, which is then that of the moment. */
    int (*step)(void *self, double t, double h, const double *y, const double *f, double *to,
                double *rates);
};

/* That of a method, whose name may have an @ behind it; NULL: it solves for none. */
const struct plan_solved *plan_solved(const char *method);

extern const struct plan_solved solved_pcisph, solved_mps; /* solved/ */
extern const struct plan_ahead_solver implicit_ahead; /* implicit/ahead.c */
extern const struct plan_solver implicit_viscous; /* implicit/viscous.c */

#endif
