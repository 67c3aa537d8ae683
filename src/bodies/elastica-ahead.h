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

#endif
