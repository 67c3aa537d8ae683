/* plan.h -- a scene turned into a list of function pointers, and the one
 * right-hand side y' = f_E(t, y) + f_I(t, y) made of it.
 *
 * This header knows no dimension: time/ and study/ see only this. */
#ifndef PLAN_PLAN_H
#define PLAN_PLAN_H

#include "state/layout.h"
#include "state/limit.h"
#include <stdbool.h>

struct plan;
struct scene;

enum plan_which {
    PLAN_EXPLICIT = 1, /* everything but the implicit side                    */
    PLAN_IMPLICIT = 2, /* the stiff side of bodies, and a viscosity whose key
                          `side` says so; rows of others are 0                */
    PLAN_ALL = 3,

    /* The two halves of the explicit side, a pass over pairs each; rows of others,
     * positions among them, are 0.  See plan_half(). */
    PLAN_DENSITY = 4,  /* rates of densities                                  */
    PLAN_VELOCITY = 8  /* rates of velocities, forces on solids               */
};

/* Reads and checks the scene, fills its shapes, orders its parts. */
int plan_create(struct scene *scene, struct plan **out);
void plan_free(struct plan **plan); /* NULL is welcome */

long plan_size(const struct plan *plan);                    /* entries of y   */
const struct layout *plan_layout(const struct plan *plan);  /* lent           */
double plan_length(const struct plan *plan); /* support radius H of the kernel [m] */
void plan_start(const struct plan *plan, double *y);        /* y at t = 0     */

/* ydot [size] = the chosen side of f(t, y).  0, or STATUS_FAILED when it cannot
 * answer (density out of bounds, a position not finite): then
 * plan_refusal() says particle, part and value, and ydot is not to be used.
 * Allocates nothing between list rebuilds; f does not depend on history but for
 * the last bits (the order of sums follows the last rebuild). */
int plan_rhs(struct plan *plan, enum plan_which which, double t, const double *y, double *ydot);
const char *plan_refusal(const struct plan *plan);

/* Both sides at once, as plan_rhs() gives each of them: with an implicit viscosity for
 * one pass over pairs instead of two. */
int plan_sides(struct plan *plan, double t, const double *y, double *explicit, double *implicit);

/* One half, for methods that change velocities or densities by it: as plan_rhs(),
 * but powers are booked with the velocities of the fluid (PLAN_VELOCITY) or with the
 * pressures (PLAN_DENSITY) that the rates lead to in a time `later` [s].  With half
 * of h, the book gets the very work of a kick v += h A. */
int plan_half(struct plan *plan, enum plan_which which, double t, const double *y, double later,
              double *ydot);

/* NULL, or why rates of positions are not the velocities alone. */
const char *plan_drifts(const struct plan *plan);

/* NULL, or why this plan's explicit side has no two halves. */
const char *plan_halves(const struct plan *plan);

/* The implicit side.  plan_stiff(): is there any?  The entries of y that it
 * couples lie in ranges [from, to); all others have f_I = 0. */
bool plan_stiff(const struct plan *plan);
int plan_stiff_ranges(const struct plan *plan, int most, long (*range)[2]); /* their number */

/* Finds z with z - gamma f_I(t, z) = r in those ranges (z comes in as a guess);
 * other entries are not touched.  STATUS_FAILED: without a failure kept, a refusal as
 * that of plan_rhs() -- try a shorter step -- else the failure. */
int plan_solve(struct plan *plan, double t, double gamma, const double *r, double *z);

/* NULL, or the path of the effect that is implicit ("effects.laminar-viscosity").
 * Then the ranges hold the fluid's velocities and the book, too; plan_solve() reads
 * all of r; and it is exact to a small part of the errors of size tol, in units of
 * scales, that plan_solve_tolerance() says a step may have (until then: the scene's). */
const char *plan_viscous(const struct plan *plan);
void plan_solve_tolerance(struct plan *plan, double tol);

/* Largest explicit step the physics allows: rates of waves and of decay [1/s],
 * with part and particle.  `stiff` says whether the implicit side is taken
 * explicitly too and so limits as well.  limit[0] is for waves, [1] for decay. */
void plan_limit(struct plan *plan, double t, const double *y, bool stiff, struct limit limit[2]);

/* Next time after t at which f jumps, HUGE_VAL: never [s]; a run stops there and
 * restarts its method. */
double plan_event(const struct plan *plan, double t);

/* Error weights for a tolerance, constant during a run. */
void plan_weights(const struct plan *plan, double tol, double *weight);

/* "velocity of fluid.water particle 17" for entry i of y; static buffer. */
const char *plan_entry(const struct plan *plan, long i);

/* How many right-hand sides have been asked for, by side (two halves are one),
 * passes over all pairs for them and for solves, products of the implicit viscosity's
 * matrix, and list rebuilds. */
struct plan_counts {
    long rhs_explicit, rhs_implicit, passes, solves, products, rebuilds, refused;
};
const struct plan_counts *plan_counts(const struct plan *plan);

#endif
