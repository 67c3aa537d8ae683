/* beam-ahead.h -- a beam under a pressure that looks ahead: see struct body_ahead. */
#ifndef BODIES_BEAM_AHEAD_H
#define BODIES_BEAM_AHEAD_H

#include "bodies/beam-make.h"

int beam_ahead_set(const struct body *b, struct body_work *w, const struct layout *l, double t,
                   double tau, const double *y);
void beam_ahead_drive(const struct body *b, struct body_work *w, const double (*force)[DIM],
                      double (*a)[DIM]);
void beam_ahead_yield(const struct body *b, struct body_work *w, const double (*force)[DIM],
                      double (*a)[DIM]);

/* w->q, v, force, rate and inertia at (t, y) as load() goes by them, v' being that of (E4), and in
 * w->resist all that (E4) has beside M v' and F.  Returns the force of the water along the axis. */
double beam_ahead_balance(const struct body *b, struct body_work *w, const struct layout *l,
                          double t, const double *y, const double (*force)[DIM]);

/* Of bodies_beam_predicted: load() of struct body_kind, all rates by (E4) of the last set(). */
void beam_ahead_load(const struct body *b, struct body_work *w, const struct layout *l, double t,
                     const double *y, const double (*force)[DIM], double *ydot,
                     struct body_load *out);

#endif
