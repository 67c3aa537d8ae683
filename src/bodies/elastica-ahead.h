/* elastica-ahead.h -- a beam that bends far under a pressure that looks ahead: see struct
 * body_ahead. */
#ifndef BODIES_ELASTICA_AHEAD_H
#define BODIES_ELASTICA_AHEAD_H

#include "bodies/elastica-make.h"

int elastica_ahead_set(const struct body *b, struct body_work *w, const struct layout *l, double t,
                       double tau, const double *y);
void elastica_ahead_drive(const struct body *b, struct body_work *w, const double (*force)[DIM],
                          double (*a)[DIM]);
void elastica_ahead_yield(const struct body *b, struct body_work *w, const double (*force)[DIM],
                          double (*a)[DIM]);

/* w->q, v, given, force, rate and inertia at (t, y) as load() goes by them, v' being that of (E4), and
 * in w->resist all that (E4) has beside M v' and F.  Rates that are not finite: there are none. */
void elastica_ahead_balance(const struct body *b, struct body_work *w, const struct layout *l,
                            double t, const double *y, const double (*force)[DIM]);

/* Of bodies_elastica_predicted: load() of struct body_kind, all rates by (E4) of the last set(). */
void elastica_ahead_load(const struct body *b, struct body_work *w, const struct layout *l,
                         double t, const double *y, const double (*force)[DIM], double *ydot,
                         struct body_load *out);

#endif
