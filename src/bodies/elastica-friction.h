/* elastica-friction.h -- damping of a beam that bends far, by the rate at which it bends. */
#ifndef BODIES_ELASTICA_FRICTION_H
#define BODIES_ELASTICA_FRICTION_H

#include "bodies/elastica-element.h"

/* Of an element at q [8] with rates v [8]; beta [s].
 * f [8] += the resisting force, which stands beside dE/dq. */
void elastica_friction_force(const struct elastica_element *e, double beta, const double *q,
                             const double *v, double *f);

/* k [8][8] += gamma d(force)/dv at q = r + gamma v, which is not symmetric. */
void elastica_friction_tangent(const struct elastica_element *e, double beta, double gamma,
                               const double *q, const double *v,
                               double k[ELASTICA_ELEMENT][ELASTICA_ELEMENT]);

/* Power of that force against the beam, -v . f <= 0 [W, 2D: W/m]. */
double elastica_friction_power(const struct elastica_element *e, double beta, const double *q,
                               const double *v);

#endif
