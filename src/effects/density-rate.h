/* density-rate.h -- (D1), the rate at which neighbours change a density:
 *
 *   d rho_a/dt = sum_b m_b (v_a - v_b) . gradW_ab                          (D1)
 *
 * Monaghan, J. Comput. Phys. 110 (1994) 399-406, eq. 2.3; it is also the exact rate
 * of the sum (D3). */
#ifndef EFFECTS_DENSITY_RATE_H
#define EFFECTS_DENSITY_RATE_H

#include "space/pairs.h"

/* Adds m_a times the rate. */
LANES_INLINE void density_rate_row(const void *self, const struct side *a, const struct row *b,
                                   struct sum *to)
{
    (void)self;
    (void)a;
    to->drho += b->gw * b->xv;
}

#endif
