/* space-laws.h -- two laws to sum, for the lane width LANES; the including file
 * sets it.  They mean nothing, but use every row and are symmetric. */
#if LANES > 2 /* slow without AVX, but right: no vector leaves this file */
#pragma GCC diagnostic ignored "-Wpsabi"
#endif
#include "space/pairs.h"

/* force -(p2_a + p2_b) gradW, rate v.gradW (times both masses) */
static void first(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    (void)self;
    for (int k = 0; k < b->n; k++) {
        for (int d = 0; d < DIM; d++)
            to->f[d] -= (a->p2 + b->p2[k]) * b->gw[k] * b->x[d][k];
        to->drho += b->gw[k] * b->xv[k];
    }
}

/* force W v r^2 (1/rho_a + 1/rho_b), rate W (rho_a + rho_b): not 0 at r = 0 */
static void second(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    const double strength = *(const double *)self;

    for (int k = 0; k < b->n; k++) {
        for (int d = 0; d < DIM; d++)
            to->f[d] += strength * b->w[k] * b->r2[k] * (a->irho + b->irho[k]) * b->v[d][k];
        to->drho += strength * b->w[k] * (a->rho + b->rho[k]);
    }
}

extern pairs_law *const LANE_NAME(space_laws)[];
pairs_law *const LANE_NAME(space_laws)[] = { first, second };
