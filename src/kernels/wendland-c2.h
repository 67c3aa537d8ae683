/* wendland-c2.h -- the gradient of (K1) for one row, for loops that do more than that.
 *
 *   W'(r)/r = -20 sigma_D/H^(D+2) (1 - q)^3,   q = r/H */
#ifndef KERNELS_WENDLAND_C2_H
#define KERNELS_WENDLAND_C2_H

#include "base/lanes-max.h"
#include "kernels/rows.h"

struct wendland_c2 {
    real inverse; /* 1/H                                [1/m]              */
    real factor;  /* -20 sigma_D/H^(D+2)                [m^-(D+2)]         */
    real eta2;    /* softens 1/r^2                      [m^2]              */
};

LANES_INLINE struct wendland_c2 wendland_c2_of(double support, double inverse, double scale)
{
    return (struct wendland_c2){ (real)inverse, (real)(-20 * scale * inverse * inverse),
                                 (real)kernel_softening(support) };
}

LANES_INLINE struct wendland_c2 wendland_c2_make(double support, double scale)
{
    return wendland_c2_of(support, 1 / support, scale);
}

/* m W'(r)/r, 0 beyond the support. */
LANES_INLINE lanes wendland_c2_gradient(const struct wendland_c2 *c, lanes r, lanes m)
{
    const lanes t = lanes_positive_at_once(1 - c->inverse * r);

    return c->factor * m * t * (t * t);
}

/* That of a row over its softened r^2. */
LANES_INLINE lanes wendland_c2_softened(const struct wendland_c2 *c, lanes gradient, lanes r2)
{
    return gradient / (r2 + c->eta2);
}

#endif
