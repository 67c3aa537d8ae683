/* plan.h -- a scene turned into a list of function pointers: what there is, never changed
 * after plan_create().  What it evaluates to at a (t, y) is asked of a moment (moment.h):
 * the one right-hand side y' = f_E(t, y) + f_I(t, y).
 *
 * This header knows no dimension. */
#ifndef PLAN_PLAN_H
#define PLAN_PLAN_H

#include "state/layout.h"
#include "state/limit.h"
#include <stdbool.h>

struct plan;
struct scene;

#define PLAN_TOL 1e-2 /* error allowed in a step where nothing else is said */

/* Reads and checks the scene, fills its shapes, orders its parts. */
int plan_create(struct scene *scene, const struct plan **out);

/* The same by all ranks at once, which share what takes long; then they agree on the status by
 * ranks_agree_after(). */
int plan_create_together(struct scene *scene, const struct plan **out);
void plan_free(const struct plan **plan); /* NULL is welcome */

long plan_size(const struct plan *plan);                    /* entries of y at t = 0 */
const struct layout *plan_layout(const struct plan *plan);  /* of y at t = 0; lent   */
double plan_length(const struct plan *plan); /* support radius H of the kernel [m] */
const char *plan_precision(const struct plan *plan); /* of pairs: "double" or "single" */
void plan_start(const struct plan *plan, double *y);        /* y at t = 0, but for a
                                   pressure that is solved for: implicit/release.h */

/* NULL, or why rates of positions are not the velocities alone. */
const char *plan_drifts(const struct plan *plan);

/* NULL, or why this plan's explicit side has no two halves. */
const char *plan_halves(const struct plan *plan);

/* Is there an implicit side?  The entries of a y of this layout that it couples lie in
 * ranges [from, to), at most `most`; returns their number. */
bool plan_stiff(const struct plan *plan);
int plan_stiff_ranges(const struct plan *plan, const struct layout *l, int most,
                      long (*range)[2]);

/* NULL, or the path of the effect that is implicit ("effects.laminar-viscosity").
 * Then the ranges hold the fluid's velocities and the book, too, and moment_solve() reads
 * all of r. */
const char *plan_viscous(const struct plan *plan);

/* Next time after t at which f or densities jump, HUGE_VAL: never [s]; a run stops there,
 * asks moment_event() and restarts its method. */
double plan_event(const struct plan *plan, double t);

#endif
