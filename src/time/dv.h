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

#include "time/paced.h"

enum { DV_POINTS = 3 };

/* Rates at the last times: [0] belongs to the step that is tried. */
struct dv_past {
    double t[DV_POINTS];
    double *f[DV_POINTS];       /* [n]                                         */
    int known;                  /* of [1] and [2]                              */
    const double *begun;        /* [n] those at the beginning of the last step */
};

struct dv {
    struct paced frame;         /* first                                       */
    long from[LAYOUT_CLASSES + 1]; /* y[from[c]] .. y[from[c+1]-1] is class c  */
    bool flows;                 /* densities are stepped                       */
    int ranges;                 /* entries of bodies: y[range[k][0]] up to     */
    long range[LAYOUT_ROWS][2]; /* y[range[k][1]]                              */

    double *half;               /* [n] x', v_n, rho'                           */
    double *load, *load_old;    /* [n] of bodies' entries: rates by the water
                                   alone, in this step and in the last         */
    double *right;              /* [n] of moment_solve()                       */
    struct dv_past a, d;        /* A at half steps, D at whole ones            */
};

extern const struct paced_kind dv_kind;

/* dv-advance.c: members of dv_kind. */
int dv_begin(struct paced *frame);                /* A and D where a run starts */
int dv_advance(struct paced *frame, double h);
void dv_remember(struct paced *frame, bool replace);

/* dv-bodies.c: entries of bodies; nothing is done when there are none. */
int dv_bodies_half(struct dv *x, double h);  /* y_old -> half, h later         */
int dv_bodies_step(struct dv *x, double h);  /* y_old -> y under the load in A */

/* dv-length.c: members of dv_kind. */
double dv_error(struct paced *frame, double h);
double dv_bound(const struct paced *frame, struct limit *of);
double dv_haste(struct paced *frame);

/* dv-dense.c: a member of dv_kind. */
void dv_inside(const struct paced *frame, double t, double *y);

#endif
