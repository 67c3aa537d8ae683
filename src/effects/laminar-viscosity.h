/* laminar-viscosity.h -- (V1), laminar viscosity on one row:
 *
 *   F_ab = m_a m_b 2 mu/(rho_a rho_b) (x . gradW)/(r^2 + 0.01 hs^2) v       (V1) */
#ifndef EFFECTS_LAMINAR_VISCOSITY_H
#define EFFECTS_LAMINAR_VISCOSITY_H

#include "space/pairs.h"

struct laminar_viscosity {
    double mu;   /* dynamic viscosity                 [Pa s] */
    double rate; /* fastest decay with nu = 1         [1/m^2] */
    const char *side, *stick;
};

/* The c >= 0 of F_ab = -c v. */
LANES_INLINE lanes laminar_viscosity_coupling(const struct laminar_viscosity *s,
                                              const struct side *a, const struct row *b)
{
    return (real)(-2 * s->mu) * (a->irho * b->irho) * (b->gw_r2 * b->r2);
}

LANES_INLINE void laminar_viscosity_row(const void *self, const struct side *a,
                                        const struct row *b, struct sum *to)
{
    const lanes c = laminar_viscosity_coupling(self, a, b);

    for (int d = 0; d < DIM; d++)
        to->f[d] -= c * b->v[d];
}

#endif
