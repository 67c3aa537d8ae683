/* bending-rates.h -- how fast a straight beam swings, and how fast it dies down. */
#ifndef BODIES_BENDING_RATES_H
#define BODIES_BENDING_RATES_H

#include "bodies/bending.h"
#include "state/limit.h"

/* Largest frequency [rad/s] and largest v . D v / v . M v [1/s], from above by 1 % at
 * most; of the assembled matrices; factorizations that w keeps get lost. */
double bending_rates_fastest(const struct bending *b, struct bending_work *w);
double bending_rates_decay(const struct bending *b, struct bending_work *w);

/* Adds d I to w->sum where degrees of freedom move. */
void bending_rates_drag(const struct bending *b, struct bending_work *w, double d);

/* What both of them are to explicit steps: out->rate and out->decay. */
void bending_rates_limit(const struct bending_def *def, double fastest, double decay,
                         struct limit *out);

#endif
