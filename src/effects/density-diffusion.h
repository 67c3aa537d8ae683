/* density-diffusion.h -- (D2), diffusion of density on one row:
 *
 *   m_a d rho_a/dt = sum_b m_a m_b 2 delta hs c0 (rho_a - rho_b - rho_H)
 *                    / rhobar  x.gradW_ab / (r^2 + 0.01 hs^2)               (D2) */
#ifndef EFFECTS_DENSITY_DIFFUSION_H
#define EFFECTS_DENSITY_DIFFUSION_H

#include "space/pairs.h"

#include <stdbool.h>

struct density_diffusion {
    double delta;
    double strength; /* delta hs c0               [m^2/s]    */
    double slope[3]; /* rho0 g / c0^2             [kg/m^4]   */
    double rate;     /* fastest decay             [1/s]      */
};

/* Of what gravity alone makes of the densities: slopes from direction `from` on are not 0. */
LANES_INLINE void density_diffusion_from(const struct density_diffusion *s, int from,
                                         const struct side *a, const struct row *b,
                                         struct sum *to)
{
    lanes hydrostatic = (real)s->slope[from] * b->x[from];

    for (int d = from + 1; d < DIM; d++)
        hydrostatic += (real)s->slope[d] * b->x[d];
    to->drho += (real)s->strength * (a->irho + b->irho) * (a->rho - b->rho - hydrostatic)
              * (b->gw_r2 * b->r2);
}

LANES_INLINE void density_diffusion_row(const void *self, const struct side *a,
                                        const struct row *b, struct sum *to)
{
    density_diffusion_from(self, 0, a, b, to);
}

/* Does gravity pull along the last direction, or nowhere? */
LANES_INLINE bool density_diffusion_is_upright(const void *self)
{
    const struct density_diffusion *s = self;
    bool upright = true;

    for (int d = 0; d < DIM - 1; d++)
        upright &= s->slope[d] == 0;
    return upright;
}

/* Then this gives the same: to subtract a 0 changes nothing. */
LANES_INLINE void density_diffusion_upright_row(const void *self, const struct side *a,
                                                const struct row *b, struct sum *to)
{
    density_diffusion_from(self, DIM - 1, a, b, to);
}

#endif
