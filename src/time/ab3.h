/* ab3.h -- what the files of the method "ab3" share.
 *
 * Adams-Bashforth of order 3 with steps of any length h = t_(n+1) - t_n: the parabola
 * through the last three rates, integrated.  With divided differences f[..]:
 *
 *   y_(n+1) = y_n + f_n I_0 + f[n,n-1] I_1 + f[n,n-1,n-2] I_2                   (AB)
 *   I_k = int from t_n to t_(n+1) of (t - t_n)..(t - t_(n-k+1)) dt
 *
 * and the error is the next term, f[n+1,n,n-1,n-2] I_3, for which f_(n+1) is asked for:
 * one right-hand side a step, also of one that is rejected, and the same f_(n+1) is the
 * next step's f_n.  The first two steps after a start are Runge-Kutta's of order 3(2),
 * three right-hand sides each.
 *
 * Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section III.5;
 * the start: Bogacki, Shampine, Appl. Math. Lett. 2 (1989) 321-325. */
#ifndef TIME_AB3_H
#define TIME_AB3_H

#include "algebra/vector.h"
#include "state/limit.h"
#include "time/choice.h"
#include "time/control.h"
#include "time/method.h"
#include "time/rates.h"

enum { AB3_POINTS = 3 };

struct ab3 {
    struct method_def def;
    struct rates rates;
    long n;                     /* entries of y                                */

    double t, t_old;
    double *y, *y_old;          /* [n] at both                                 */
    double *f[AB3_POINTS + 1];  /* [n] at time[], newest first; the last one is
                                   that of a step which is tried               */
    double time[AB3_POINTS];
    int known;                  /* of f and time                               */
    const double *begun;        /* [n] f at t_old                              */
    bool ready, stepped;        /* f[0] is known at t; there is a y_old        */

    SUNContext context;
    N_Vector error, weight;
    struct control control;
    struct choice choice;       /* for the step to come                        */
    double h_min;               /* [s]                                         */
    long rejected;
};

extern const struct method ab3_method;

/* ab3-create.c */
int ab3_create(const struct method *m, const struct method_def *def, struct plan *plan, double t,
               const double *y, void **out);
int ab3_restart(void *self, double t, const double *y);
void ab3_free(void **self);
int ab3_vectors(const struct method *m, const struct plan *plan);

/* ab3-advance.c: y_old at t_old -> y at t_old + h, with the rates there and the error.
 * A refusal is handed up. */
int ab3_advance(struct ab3 *x, double h);
void ab3_remember(struct ab3 *x, bool replace); /* those rates; instead of the last ones */

/* ab3-length.c */
void ab3_choose(struct ab3 *x, double h);    /* the next step: h where it is stable */
void ab3_first(struct ab3 *x, double t_stop);
int ab3_constant_failed(const struct ab3 *x); /* STATUS_FAILED, with the bound it broke */

/* ab3.c */
int ab3_step(void *self, double t_stop, struct method_step *out);
int ab3_at(void *self, double t, double *y);

#endif
