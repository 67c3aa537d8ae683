/* pcisph.h -- pressure by prediction and correction, once a step.
 *
 *     moment_eval(moment, all but pressure, t, y, rates);
 *     pcisph_solve(p, t, h, rates, y);         densities of y become those of the pressure
 *     moment_eval(moment, all, t, y, rates);   forces of that pressure
 *     pcisph_settle(p, h, y_old, y, rates);    densities follow no law
 *
 * A density in y stands for a pressure here, by the equation of state: all that looks at a
 * state, forces and probes among them, finds the pressure that was solved for.
 *
 * This header knows no dimension. */
#ifndef SOLVED_PCISPH_H
#define SOLVED_PCISPH_H

#include "eval/moment.h"

struct pcisph;

/* NULL, or why there is no such pressure in this plan. */
const char *pcisph_serves(const struct plan *plan);

int pcisph_create(struct moment *moment, struct pcisph **out);
void pcisph_free(struct pcisph **p); /* NULL is welcome */
double pcisph_memory(const struct plan *plan); /* about [bytes] */

/* y [size] at t comes in with any densities and goes out with those of the pressure for a
 * step of h [s]; rates [size] are those by all but the pressure.  STATUS_FAILED without a
 * failure kept: a refusal, moment_refusal() says which particle is how much too dense after
 * how many iterations; a shorter step may do. */
int pcisph_solve(struct pcisph *p, double t, double h, const double *rates, double *y);

/* Rates [size] of a step h from y_old to the densities of y: those of densities become 0,
 * and so do works of laws for densities, but for the energy that the equation of state
 * stores at the new densities. */
void pcisph_settle(const struct pcisph *p, double h, const double *y_old, const double *y,
                   double *rates);

/* The step in which the reference speed U crosses hs [s]. */
double pcisph_pace(const struct pcisph *p);

/* Fastest decay by forces [1/s]: effects on densities alone do nothing here. */
void pcisph_decay(const struct pcisph *p, double t, const double *y, struct limit *out);

#endif
