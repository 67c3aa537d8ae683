/* weights.h -- the weight function of MPS and its constants on the square or cubic lattice.
 *
 *     w(r) = re/r - 1 for 0 < r < re, else 0                                     (M1)
 *
 * Koshizuka and Oka, Nucl. Sci. Eng. 123 (1996) 421-434. */
#ifndef SOLVED_WEIGHTS_H
#define SOLVED_WEIGHTS_H

#include "base/dim.h"

struct weights {
    double re;      /* [m]                                                     */
    double n0;      /* sum of w over a lattice's neighbours          [1]      */
    double lambda;  /* mean of r^2 with the weights w                [m^2]    */
    double kappa;   /* (dn/n0)/(drho/rho0) of a uniform compression: sum of re/r over D n0 */
    double inverse; /* sum of re/r                                   [1]      */
};

/* For the radius re of spacings l0 [m]. */
struct weights weights_of(double re, double l0);

static inline double weights_w(const struct weights *s, double r)
{
    return r > 0 && r < s->re ? s->re / r - 1 : 0;
}

#endif
