/* pressure-force.h -- (P1), the force of the pressure on one row:
 *
 *   F_ab = -m_a m_b (p_a/rho_a^2 + p_b/rho_b^2) gradW_ab                   (P1) */
#ifndef EFFECTS_PRESSURE_FORCE_H
#define EFFECTS_PRESSURE_FORCE_H

#include "space/pairs.h"

LANES_INLINE void pressure_force_row(const void *self, const struct side *a,
                                     const struct row *b, struct sum *to)
{
    const lanes c = (a->p2 + b->p2) * b->gw;

    (void)self;
    for (int d = 0; d < DIM; d++)
        to->f[d] -= c * b->x[d];
}

#endif
