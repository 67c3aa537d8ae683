/* mps.h -- one step of MPS: an explicit part, then a pressure that keeps the number density.
 *
 *     struct mps *mps;
 *     TRY(mps_create(moment, &mps));
 *     f = rates at (t, y) by all but the pressure
 *     TRY(mps_step(mps, t, h, y, f, to));
 *     mps_free(&mps);
 *
 * doc/equations.md has the equations, (M1) to (M16); the group `mps` of a scene chooses among
 * them.  Nothing is kept from one step to the next: the pressure stands in y, as the density
 * that the equation of state has there, and is the guess of the next solve.
 *
 * This header knows no dimension. */
#ifndef SOLVED_MPS_H
#define SOLVED_MPS_H

#include "eval/moment.h"

struct mps;

/* NULL, or why MPS cannot serve the plan. */
const char *mps_serves(const struct plan *plan);

int mps_create(struct moment *moment, struct mps **out);
void mps_free(struct mps **mps); /* NULL is welcome */
double mps_memory(const struct plan *plan); /* about [bytes] */

/* to [size of y] at t + h from y at t.  STATUS_FAILED: no memory, or a refusal, which is then
 * that of the moment. */
int mps_step(struct mps *mps, double t, double h, const double *y, const double *f, double *to);

/* number l0 / (the reference speed or the fastest particle's, if that is more), and not more
 * than what viscosities allow [s]; sets limit. */
double mps_length(const struct mps *mps, double number, double t, const double *y,
                  struct limit *limit);

#endif
