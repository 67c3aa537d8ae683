/* dv.h -- what the files of the method "dv" share.
 *
 * Staggered Verlet: velocities and densities step in turn.  A are the rates of
 * velocities, D those of densities; each is a pass over pairs.  A step h from t_n:
 *
 *   rho' = rho_n + h/2 D_n,   x' = x_n + h/2 v_n
 *   v_(n+1) = v_n + h A,               A = A(t_n + h/2, x', rho', v_n)
 *   x_(n+1) = x' + h/2 v_(n+1)
 *   rho_(n+1) = rho' + h/2 D_(n+1),    D_(n+1) = D(t_n + h, x_(n+1), v_(n+1), rho')
 *
 * Symmetric in time and of order 2 but for what A makes of v (viscosity) and D of
 * rho (diffusion): these see values half a step old, order 1 with a small constant.
 * Taken at their own time, by extrapolation, they would be of order 2, but the
 * longest stable step is shorter and the energy strays further.  Quadratures ride
 * along: h of A's rates, h/2 of D_n's and of D_(n+1)'s.
 *
 * D taken at x', where A has the geometry of all pairs, would be as stable, but of
 * order 1: three times the error in positions (doc/speed.md).
 *
 * Bodies: A needs them at the half step, by backward Euler under the last load;
 * then the load in A, held fixed, moves them by two implicit stages (dv-bodies.c).
 *
 * Verlet, Phys. Rev. 159 (1967) 98-103; Hairer, Lubich, Wanner, Acta Numerica 12
 * (2003) 399-450. */
#ifndef TIME_DV_H
#define TIME_DV_H

#include "algebra/vector.h"
#include "state/limit.h"
#include "time/choice.h"
#include "time/control.h"
#include "time/method.h"

enum { DV_POINTS = 3 };

/* Rates at the last times: [0] belongs to the step that is tried. */
struct dv_past {
    double t[DV_POINTS];
    double *f[DV_POINTS];       /* [n]                                         */
    int known;                  /* of [1] and [2]                              */
    const double *begun;        /* [n] those at the beginning of the last step */
};

struct dv {
    struct method_def def;
    struct plan *plan;
    long n, from[LAYOUT_CLASSES + 1]; /* y[from[c]] .. y[from[c+1]-1] is class c */
    bool flows;                 /* densities are stepped                       */
    int ranges;                 /* entries of bodies: y[range[k][0]] up to     */
    long range[LAYOUT_ROWS][2]; /* y[range[k][1]]                              */

    double t, t_old;
    double *y, *y_old;          /* [n] at both                                 */
    double *half;               /* [n] x', v_n, rho'                           */
    double *load, *load_old;    /* [n] of bodies' entries: rates by the water
                                   alone, in this step and in the last         */
    double *right;              /* [n] of plan_solve()                         */
    struct dv_past a, d;        /* A at half steps, D at whole ones            */
    bool ready, stepped;        /* a and d are known at t; there is a y_old    */

    SUNContext context;
    N_Vector error, weight;
    struct control control;
    struct choice choice;    /* for the step to come                        */
    double h_min;               /* [s]                                         */
    long rejected;
};

extern const struct method dv_method;

/* dv-create.c */
int dv_create(const struct method *m, const struct method_def *def, struct plan *plan, double t,
              const double *y, void **out);
int dv_restart(void *self, double t, const double *y);
void dv_free(void **self);
int dv_vectors(const struct method *m, const struct plan *plan);

/* dv-advance.c.  A refusal is handed up. */
int dv_begin(struct dv *x);               /* A and D where a run starts        */
int dv_advance(struct dv *x, double h);   /* y_old at t_old -> y at t_old + h  */

/* dv-bodies.c: entries of bodies; nothing is done when there are none. */
int dv_bodies_half(struct dv *x, double h);  /* y_old -> half, h later         */
int dv_bodies_step(struct dv *x, double h);  /* y_old -> y under the load in A */

/* dv-length.c */
double dv_error(struct dv *x, double h);     /* of the step tried, in units of tol */
void dv_choose(struct dv *x, double h);      /* the next step: h where it is stable */
void dv_first(struct dv *x, double t_stop);
int dv_constant_failed(const struct dv *x);  /* STATUS_FAILED, with the bound it broke */

/* dv-dense.c */
int dv_at(void *self, double t, double *y);

/* dv.c */
int dv_step(void *self, double t_stop, struct method_step *out);

#endif
