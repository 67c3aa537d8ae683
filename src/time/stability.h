/* stability.h -- how long an explicit step may be, from the method's table alone.
 *
 * A table multiplies an eigenvector with eigenvalue lambda by R(h lambda) in a
 * step of length h.  A factor C means: stable for h <= C / |lambda|. */
#ifndef TIME_STABILITY_H
#define TIME_STABILITY_H

#include "time/tableau.h"

/* Damping of the fluid's fastest waves: their eigenvalues are about i - 0.07. */
#define STABILITY_DAMPING 0.07

/* |R(z)| of an explicit table at z = re + i im. */
double stability_growth(const struct tableau *t, double re, double im);

/* Largest C with |R| <= 1.001 on s C (i - damping) for all s from 0 to 1. */
double stability_wave(const struct tableau *t, double damping);

/* Largest C with |R| <= 1.001 on the real axis from -C to 0. */
double stability_decay(const struct tableau *t);

/* Largest C for which ten periods of a vibration of frequency omega change its amplitude by
 * at most the part `loss`, in steps of h <= C / omega by this table, explicit or with a
 * diagonal; a twelfth of a period at most, which dense output can follow. */
double stability_swing(const struct tableau *t, double loss);

#endif
