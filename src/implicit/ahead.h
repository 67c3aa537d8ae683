/* ahead.h -- the system of a pressure that looks ahead, (E3), for P = p/rho^2 of the fluid and
 * of solids with a density of their own:
 *
 *   (E + tau^2 D M^-1 G) P = m (rho - rho0) + tau D v + tau^2 (D a + C v),  E = m rho^2/c0^2
 *
 * D, G, C of space/nabla.h; a: accelerations by all but the pressure, of walls those of their
 * motion; M^-1 is 0 for walls, and for skins S (M + tau D + tau^2 K)^-1 S^T of their bodies
 * (E4).  By (D1) m rho' = D v, and the force is -G P with G the transpose of D, so the system
 * is symmetric and positive definite, at free surfaces and in closed tanks alike.
 *
 * Solids of walls = "contact" press by means: of them pi >= 0 is unknown, that of the mean A of
 * their densities (W6) predicted, and
 *
 *   P_w = q_w = sum_w' A_w'w pi_w' m_w'/m_w,   D_w = sum_w' A_ww' (m_w/m_w') D_w',
 *   m (rho - rho0) = m_w (sum_w' A_ww' r_w' - rho0),   lower bound 0,
 *
 * so that G is the transpose of D still.  r holds g(o) as it stands.  The bound makes the one
 * side, so (W6) needs no eps here.
 *
 * Without tension (eos.tension = false) it is a complementarity problem: P >= 0, the left side
 * is not less than the right one, and is equal to it wherever P > 0. */
#ifndef IMPLICIT_AHEAD_H
#define IMPLICIT_AHEAD_H

#include "eval/inside.h"
#include "implicit/bounded.h"
#include "implicit/operator.h"
#include "matter/eos.h"
#include "space/nabla-kept.h"

/* Vectors are by place of the list: [n] particles, [places] with images and the dummy. */
struct ahead {
    struct moment *m;          /* of the last find()                          */
    struct nabla_job job;
    struct nabla_kept kept;    /* weights of the pairs at the positions of a solve  */
    unsigned meets[KINDS], kinds, moving;
    int n, listed;             /* all particles; those in the list, without images */
    struct {
        size_t places, pairs, groups;       /* there is room for             */
    } room;
    double tau, residual_share;
    double *P, *residual, *b, *term, *rate; /* [n]; rate: D v                 */
    struct {
        double *still, *diagonal;           /* [n] E, that of the system      */
    } left;
    struct {                                /* of the last solves, newest first */
        int n;
        double t[2], *P[2];                 /* [n] by id                      */
    } past;
    double *scalar, *vector;                /* [places], [places][NABLA_STRIDE] */
    double (*push)[DIM];                    /* [skins] forces on them by all but the pressure */
    struct operator operator;
    struct operator_solver *solver;         /* NULL: with bounds         */
    struct bounded_solver *bounded;         /* P >= 0 of some; NULL: of none */
    struct {
        double *from, *to, *least; /* [solids], [solids], [n] bounds where fluid has none;
                                      NULL without such walls                  */
    } walls;
};

/* ahead-operator.c: right-hand side b and operator at a->m, for accelerations udot [fluid]
 * [DIM]. */
void ahead_assemble(struct ahead *a, const double *udot);

/* ahead-walls.c: of solids that press by means, memory; bounds; q from pi, and m A/m of v, both
 * by place, in place.  They do nothing where there are no such solids. */
int ahead_walls_create(struct ahead *a, bool tension);
void ahead_walls_bound(struct ahead *a);
void ahead_walls_spread(struct ahead *a, double *v);
void ahead_walls_mean(struct ahead *a, double *v);

/* ahead-bodies.c: memory for forces on all skins. */
int ahead_bodies_create(const struct plan *p, double (**push)[DIM]);

/* Bodies ready at (t, y), with the forces on their skins by all but the pressure
 * in m->work->f, from which later passes over pairs may take it.  STATUS_FAILED: one is not. */
int ahead_bodies_set(struct ahead *a, double t, const double *y);

/* Accelerations of skins into a->vector: by all but the pressure; by the pressure's forces
 * in m->work->f alone. */
void ahead_bodies_drive(struct ahead *a);
void ahead_bodies_yield(struct ahead *a);

/* ahead-power.c: a member of implicit_ahead. */
double ahead_power(const void *self);

/* ahead-guess.c: P at t by the solves before, and what was found; forget: a member of
 * implicit_ahead. */
void ahead_guess(struct ahead *a, double t);
void ahead_keep(struct ahead *a, double t);
void ahead_forget(void *self);

#endif
