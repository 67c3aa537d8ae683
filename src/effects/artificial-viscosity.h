/* artificial-viscosity.h -- (V2), Monaghan's viscosity on one row:
 *
 *   F_ab = m_a m_b alpha c0 hs (v.x) / (rhobar (r^2 + 0.01 hs^2)) gradW_ab  (V2) */
#ifndef EFFECTS_ARTIFICIAL_VISCOSITY_H
#define EFFECTS_ARTIFICIAL_VISCOSITY_H

#include "space/pairs.h"
#include <stdbool.h>

struct artificial_viscosity {
    double alpha;
    bool only_approaching;
    const char *stick;
    double strength; /* alpha c0 hs / 2        [m^2/s] */
    double rate;     /* fastest decay          [1/s]   */
};

/* With this v.x. */
LANES_INLINE void artificial_viscosity_along(const struct artificial_viscosity *s,
                                             const struct side *a, const struct row *b,
                                             lanes xv, struct sum *to)
{
    const lanes c = (real)s->strength * (a->irho + b->irho) * (xv * b->gw_r2);

    for (int d = 0; d < DIM; d++)
        to->f[d] += c * b->x[d];
}

LANES_INLINE void artificial_viscosity_row(const void *self, const struct side *a,
                                           const struct row *b, struct sum *to)
{
    artificial_viscosity_along(self, a, b, b->xv, to);
}

#endif
