/* density-diffusion.h -- (D2), diffusion of density on one row:
 *
 *   m_a d rho_a/dt = sum_b m_a m_b 2 delta hs c0 (rho_a - rho_b - rho_H)
 *                    / rhobar  x.gradW_ab / (r^2 + 0.01 hs^2)               (D2) */
#ifndef EFFECTS_DENSITY_DIFFUSION_H
#define EFFECTS_DENSITY_DIFFUSION_H

#include "space/pairs.h"

struct density_diffusion {
    double delta;
    double strength; /* delta hs c0               [m^2/s]    */
    double slope[3]; /* rho0 g / c0^2             [kg/m^4]   */
    double rate;     /* fastest decay             [1/s]      */
};

LANES_INLINE void density_diffusion_row(const void *self, const struct side *a,
                                        const struct row *b, struct sum *to)
{
    const struct density_diffusion *s = self;
    lanes hydrostatic = (real)s->slope[0] * b->x[0];

    for (int d = 1; d < DIM; d++)
        hydrostatic += (real)s->slope[d] * b->x[d];
    to->drho += (real)s->strength * (a->irho + b->irho) * (a->rho - b->rho - hydrostatic)
              * (b->gw_r2 * b->r2);
}

#endif
