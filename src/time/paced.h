/* paced.h -- the frame of our own methods with error control, "ab3" and "dv".
 *
 * A kind has its files and is a const struct.  The frame asks it for a step, shortens the
 * step until its error is accepted, and chooses the next one: by the error, but no longer
 * than is stable.  Steps of one length, NAME@1e-4s, are never shortened. */
#ifndef TIME_PACED_H
#define TIME_PACED_H

#include "algebra/vector.h"
#include "state/limit.h"
#include "time/choice.h"
#include "time/control.h"
#include "time/method.h"

enum { PACED_ARRAYS = 16 };

/* First in the struct of a kind. */
struct paced {
    const struct paced_kind *kind;
    struct method_def def;
    const struct plan *plan;
    struct moment *moment;
    long n;                     /* entries of y                                */

    double t, t_old;
    double *y, *y_old;          /* [n] at both                                 */
    double *array[PACED_ARRAYS]; /* all [n] of paced_numbers()                 */
    int arrays;
    bool ready, stepped;        /* rates are known at t; there is a y_old      */

    SUNContext context;
    N_Vector error, weight;     /* of the step tried; 1/what an error may be   */
    struct control control;
    struct choice choice;       /* for the step to come                        */
    double carried;             /* first step by the pace of a segment before; 0: none [s] */
    double h_min;               /* [s]                                         */
    long rejected;
};

struct paced_kind {
    struct method method;       /* first: its create() finds the kind so       */
    size_t size;                /* of the kind's struct                        */
    struct control_row control;

    int (*take_memory)(struct paced *x);
    void (*free_memory)(struct paced *x); /* what there is of it               */

    /* Rates where a run starts.  A refusal is handed up. */
    int (*begin)(struct paced *x);

    /* y_old at t_old -> y at t_old + h, with the rates there.  A refusal is handed up. */
    int (*advance)(struct paced *x, double h);

    /* Of the step tried, in units of tol. */
    double (*error)(struct paced *x, double h);

    /* Why begin() or advance() had no answer. */
    const char *(*refusal)(const struct paced *x);

    /* The rates of an accepted step are the newest; `replace`: instead of the last ones. */
    void (*remember)(struct paced *x, bool replace);

    /* Largest stable step at (t, y) and what sets it; HUGE_VAL if the plan knows none. */
    double (*bound)(const struct paced *x, struct limit *of);

    /* Largest rate of an entry at the start over what its error may be [1/s]; 0: not known. */
    double (*haste)(struct paced *x);

    /* y at a t within the last step. */
    void (*inside)(const struct paced *x, double t, double *y);
};

enum { PACED_VECTORS = 4 }; /* y, y_old, the error and its weights */

/* For the struct method of a kind. */
#define PACED_METHOD                                                                     \
    .adaptive = true, .create = paced_create, .step = paced_step, .at = paced_at,        \
    .state = paced_state, .restart = paced_restart, .free = paced_free,                  \
    .rearrange = paced_rearrange

int paced_step(void *self, double t_stop, struct method_step *out);
int paced_at(void *self, double t, double *y);
const double *paced_state(const void *self);

/* paced-create.c */
int paced_create(const struct method *m, const struct method_def *def, struct moment *moment,
                 double t, const double *y, void **out);
int paced_restart(void *self, double t, const double *y, const struct method_pace *pace);
void paced_free(void **self);
int paced_rearrange(void *self, int blocks, const struct vector_rows *block);
int paced_numbers(struct paced *x, double **to); /* [n] of them, all 0 */

/* paced-length.c */
void paced_choose(struct paced *x, double h);      /* the next step: h where it is stable */
void paced_first(struct paced *x, double t_stop);
int paced_constant_failed(const struct paced *x);  /* STATUS_FAILED, with the bound it broke */

#endif
