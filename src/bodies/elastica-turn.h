/* elastica-turn.h -- how the tangent of an element turns along it, and how fast that changes.
 *
 *   kappa = (r' x r'')/|r'|^2 = dtheta/ds                                       (BE4)
 *
 * a function of z = (r', r'') at a point. */
#ifndef BODIES_ELASTICA_TURN_H
#define BODIES_ELASTICA_TURN_H

#include "bodies/elastica-element.h"

struct elastica_turn {
    double kappa;        /* [1/m]                     */
    double by[4];        /* its derivatives by z      */
    double twice[4][4];  /* its second ones           */
};

/* r' - e [1] and r'' [1/m] at a point; q [8] is of the element.  By rates of q, theirs. */
void elastica_turn_derive(const struct elastica_point *p, const double *q, double *slope,
                          double *curve);

struct elastica_turn elastica_turn_at(const struct elastica_point *p, const double *q);

/* From z to q: f [8] += c dz/dq^T by, k [8][8] += dz/dq^T h dz/dq. */
void elastica_turn_spread(const struct elastica_point *p, const double by[4], double c, double *f);
void elastica_turn_spread_twice(const struct elastica_point *p, double h[4][4],
                                double k[ELASTICA_ELEMENT][ELASTICA_ELEMENT]);

#endif
