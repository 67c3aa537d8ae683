/* method.h -- a way of going through time: one file (or one row of a table),
 * one const struct. */
#ifndef TIME_METHOD_H
#define TIME_METHOD_H

#include "algebra/norm.h"
#include "algebra/vector.h"
#include "eval/moment.h"
#include <stdbool.h>

/* How a method is to run; method_def_default() first. */
struct method_def {
    double tol;           /* error per step in units of the layout's scales:
                             what the controller aims at                      */
    enum vector_norm norm;
    double step;          /* CFL number of methods without error control
                             (name@0.25); 0: the method's default             */
    double seconds;       /* every step is that long (name@1e-4s) but for the one
                             that t_stop cuts short; 0: the method chooses [s] */
    double substep;       /* largest step of bodies in a method that steps them
                             apart from the fluid [s]; 0: no limit            */
    double h_first;       /* first step [s]; 0: the method chooses            */
    double h_min;         /* a step below this is a collapse [s]; 0: the method
                             takes a millionth of its first step              */
};
struct method_def method_def_default(void);

/* METHOD_STABILITY: also a rule, a constant step, and the first mode of a beam. */
enum method_limiter { METHOD_ERROR, METHOD_STABILITY, METHOD_OUTPUT };

/* How a method goes where a step has ended, for a segment that begins there to go on so. */
struct method_pace {
    double h;                     /* the next step, had no t_stop cut the last short [s]; of bodies
                                     that are stepped apart, theirs; 0: none is known */
    double error[2];              /* of the last two steps, as its controller keeps them */
};

/* What one accepted step was. */
struct method_step {
    double t, h;                  /* time reached [s], length [s]             */
    enum method_limiter limiter;  /* what kept h from being longer            */
    char where[96];               /* "velocity of ... particle 17" (error) or
                                     "pressure, particle 17" (stability)      */
    long rejected;                /* since the start                          */
    struct method_pace pace;      /* h = 0 of methods whose steps follow a rule, or begin at order 1 */
};

struct method {
    const char *name;   /* "imex3", "leapfrog", or an ARKODE table's name     */
    struct {
        const char *about, *source;
    } told;             /* for help and lists                                 */
    bool adaptive;      /* has an error estimate (else `@` gives the step)    */
    int order;          /* nominal, of the error; 0: changes from step to step */
    const char *varies; /* NULL, or why its steps cannot be all of one length */

    /* NULL, or why this method cannot serve the plan. */
    const char *(*serves)(const struct plan *plan);

    /* y [size] is copied.  def is copied. */
    int (*create)(const struct method *m, const struct method_def *def, struct moment *moment,
                  double t, const double *y, void **out);

    /* One accepted step that does not pass t_stop (it may end exactly there).
     * STATUS_FAILED when no step can be accepted; the message then says time,
     * block, particle and the plan's refusal, and what to try. */
    int (*step)(void *self, double t_stop, struct method_step *out);

    /* y at t inside the last step (dense output of about the method's order);
     * never asks for a right-hand side that could change later bits. */
    int (*at)(void *self, double t, double *y);

    /* How many vectors of the size of y it will hold; in how many of these a rank of many has rows of its
     * own alone, NULL: in none. */
    struct {
        int (*vectors)(const struct method *m, const struct plan *plan);
        int (*own)(const struct method *m, const struct plan *plan);
    } room;

    const double *(*state)(const void *self);     /* y at the end of the last step */

    /* From (t, y) on all is as after create() there: steps begin with h_first or the
     * method's own first one, errors, stages and states before are forgotten.  Only
     * `rejected` counts on.  With a pace whose h is not 0, steps begin with that h, where it is
     * stable; a right-hand side that has no past must not have jumped there.  NULL: none.
     * At a checkpoint moment_restart() goes with it. */
    int (*restart)(void *self, double t, const double *y, const struct method_pace *pace);

    /* Between two steps: rows of y, and of all that it keeps beside, change places
     * (eval/rearrange.h).  STATUS_FAILED, and nothing has changed: no memory.  NULL: it keeps
     * something where it cannot be reached. */
    int (*rearrange)(void *self, int blocks, const struct vector_rows *block);
    const char *(*table)(const void *self);       /* for run.json             */
    void (*free)(void **self);
};

/* A method by name: "erk4", "imex3", "ARKODE_ZONNEVELD_5_3_4", "leapfrog@0.25"
 * (the number goes to def->step), "erk4@1e-4s" (to def->seconds).  STATUS_BAD_SCENE
 * with the nearest name, or with what may stand behind the @. */
int method_find(const char *name, struct method_def *def, const struct method **out);
extern const struct method *const method_table[]; /* NULL-ended, for `list`   */

/* NULL, or why methods that solve for bodies alone cannot serve the plan: a viscosity
 * is implicit, too. */
const char *method_bodies_alone(const struct plan *plan);

/* The name a scene gets that names none: by whether there is a stiff side, and anything
 * beside bodies. */
const char *method_default(const struct plan *plan);

#endif
