/* fixed.h -- methods without error control: a rule gives the step, a formula
 * takes it.
 *
 * A kind has one file and is a const struct.  The frame gives it y and f at the
 * start of a step; when f has no answer, the frame halves the step. */
#ifndef TIME_FIXED_H
#define TIME_FIXED_H

#include "state/limit.h"
#include "time/method.h"

struct fixed {
    const struct fixed_kind *kind;
    const struct plan *plan;
    struct moment *moment;
    long n, from[LAYOUT_CLASSES + 1]; /* y[from[c]] .. y[from[c+1]-1] is class c */
    double number;        /* CFL number, the X of NAME@X                       */
    double seconds;       /* the X of NAME@Xs; 0: the rule gives the step [s]  */
    double substep;       /* largest one of bodies, when they have steps of
                             their own; HUGE_VAL: no limit [s]                 */
    int ranges;           /* entries of such bodies: y[range[k][0]] up to      */
    long range[LAYOUT_ROWS][2]; /* y[range[k][1]]; 0 ranges: none              */
    double h_min;
    double t, t_old;
    double *y, *f;        /* [n] now; f as dense output and the next step see it */
    double *y_old, *f_old;
    double *try, *rates;  /* [n] scratch of advance()                          */
    bool has_f, stepped;
    void *own;            /* of the kind, see take(); NULL                     */
    struct limit limit;   /* what decided on the step                          */
    long halved;
    char table[64];
};

struct fixed_kind {
    struct method method; /* first: its create() finds the kind so             */
    double number;        /* when the name has no @                            */
    unsigned sides;       /* of f: without ASK_IMPLICIT, bodies have
                             steps of their own                                */

    bool even;              /* steps up to t_stop are of about one length, so that none
                               is cut short there                              */
    bool without_pressure;  /* f is asked for without it: advance() solves for it */

    int spared;             /* in so many of `try` and `rates` no fluid is written: they take
                               no memory to speak of                                      */

    /* What to do when a step has no answer and a shorter one is no better; NULL: the frame
     * halves it. */
    const char *remedy;

    /* Memory of the kind in x->own; NULL: it needs none. */
    int (*take)(struct fixed *x);
    void (*leave)(struct fixed *x);

    /* Length of a step from (t, y) with rates f [s]; sets limit. */
    double (*length)(struct fixed *x);

    /* y_old, f_old at t_old -> y at t_old + h.  May set f and has_f.  A refusal
     * is handed up. */
    int (*advance)(struct fixed *x, double h);
};
extern const struct fixed_kind fixed_leapfrog, fixed_euler, fixed_staggered, fixed_pcisph,
                               fixed_mps;

int fixed_step(void *self, double t_stop, struct method_step *out);
int fixed_at(void *self, double t, double *y);
const double *fixed_state(const void *self);
int fixed_restart(void *self, double t, const double *y, const struct method_pace *pace);
int fixed_rearrange(void *self, int blocks, const struct vector_rows *block);
const char *fixed_table(const void *self);

/* fixed-create.c */
int fixed_create(const struct method *m, const struct method_def *def, struct moment *moment,
                 double t, const double *y, void **out);
void fixed_free(void **self);
int fixed_vectors(const struct method *m, const struct plan *plan);
int fixed_own(const struct method *m, const struct plan *plan);

/* NULL, or why positions and velocities do not pair up entry by entry. */
const char *fixed_serves(const struct plan *plan);

/* CFL number * hs/(c0 + v) for waves, and not more than 1/2 of 1/rate for decay;
 * sets limit. */
double fixed_wave_step(struct fixed *x);

/* The same, and short enough to take bodies explicitly. */
double fixed_explicit_step(struct fixed *x);

/* Bodies with steps of their own: their entries of `to` become those of y_old. */
void fixed_hold(const struct fixed *x, double *to);

/* length() and advance() of fixed_euler; bodies with steps of their own are held
 * where others look at them, and their entries of y are left to the caller. */
double fixed_euler_length(struct fixed *x);

/* Largest length of the vectors in row r of y or f, and whose it is, by id: the first of equals. */
double fixed_largest(const struct fixed *x, int r, const double *y, int *where);

/* The shorter one of h and `other`, which then is what decides: of particle `where`. */
double fixed_shorter(struct fixed *x, double h, double other, int where, const char *name);

/* Bodies with steps of their own: y_old goes on by h under the forces of f, as
 * fixed_staggered does it; book, unless it is NULL, is called after each of their steps, which
 * ended at t and was that long. */
typedef void fixed_book(struct fixed *x, double t, double h);
int fixed_bend(struct fixed *x, double h, const double *f, fixed_book *book);
int fixed_euler_advance(struct fixed *x, double h);

/* fixed-solved.c: members of kinds whose pressure is solved for once a step. */
const char *fixed_solved_serves(const char *method, const struct plan *plan);
int fixed_solved_take(struct fixed *x);
void fixed_solved_leave(struct fixed *x);
double fixed_solved_length(struct fixed *x);
int fixed_solved_advance(struct fixed *x, double h);

#define FIXED_METHOD(NAME, ORDER, ABOUT, SOURCE)                                         \
    FIXED_METHOD_SERVING(fixed_serves, NAME, ORDER, ABOUT, SOURCE)

#define FIXED_METHOD_SERVING(SERVES, NAME, ORDER, ABOUT, SOURCE)                         \
    { .name = NAME, .told = { ABOUT, SOURCE }, .adaptive = false, .order = ORDER,        \
      .serves = SERVES, .create = fixed_create, .step = fixed_step,                      \
      .at = fixed_at, .state = fixed_state, .restart = fixed_restart,                    \
      .table = fixed_table, .free = fixed_free, .room = { fixed_vectors, fixed_own },    \
      .rearrange = fixed_rearrange }

#endif
