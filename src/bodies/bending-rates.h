/* bending-rates.h -- how fast a straight beam swings, and how fast it dies down. */
#ifndef BODIES_BENDING_RATES_H
#define BODIES_BENDING_RATES_H

#include "bodies/bending.h"
#include "state/limit.h"

/* Largest frequency [rad/s] and largest v . D v / v . M v [1/s], from above by 1 % at
 * most; of the assembled matrices, with the scratch ones. */
double bending_rates_fastest(struct bending *b);
double bending_rates_decay(struct bending *b);

/* Adds d I to the scratch matrix where degrees of freedom move. */
void bending_rates_drag(struct bending *b, double d);

/* What both of them are to explicit steps: out->rate and out->decay. */
void bending_rates_limit(const struct bending_def *def, double fastest, double decay,
                         struct limit *out);

#endif
