/* density-diffusion.c -- density differences diffuse, the hydrostatic ones
 * excepted.
 *
 *   m_a d rho_a/dt = sum_b m_a m_b 2 delta hs c0 (rho_a - rho_b - rho_H)
 *                    / rhobar  x.gradW_ab / (r^2 + 0.01 hs^2)               (D2)
 *   rho_H = rho0 g.(x_a - x_b) / c0^2
 *
 * with rhobar the harmonic mean of both densities, as in (V2).  Antisymmetric,
 * so mass-weighted density is kept.
 * Molteni, Colagrossi, Comput. Phys. Commun. 180 (2009) 861-872; subtracting the
 * hydrostatic part: Fourtakas et al., Comput. Fluids 190 (2019) 346-361, here
 * linearised about rho0 so that both sides agree.
 * Checked in tests/physics/laws.c. */
#include "effects/density-diffusion.h"
#include "effects/effects.h"

static const struct param params[] = {
    { .key = "delta", .unit = "1", .offset = offsetof(struct density_diffusion, delta),
      .fallback = 0.03, .min = 0, .max = 1, .about = "strength of the diffusion" },
    { 0 },
};

static void pairs(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    pairs_rows(density_diffusion_row, self, a, b, to);
}

static int prepare(void *self, const struct scales *scales)
{
    struct density_diffusion *s = self;

    s->strength = s->delta * scales->hs * scales->c0;
    for (int d = 0; d < DIM; d++)
        s->slope[d] = scales->rho0 * scales->g[d] / (scales->c0 * scales->c0);
    s->rate = SCALES_LAPLACE * scales->laplace_density * s->delta * scales->c0 / scales->hs;
    return 0;
}

static void limit(const void *self, const struct view *v, struct limit *out)
{
    const struct density_diffusion *s = self;

    (void)v;
    out->rate = s->rate;
    out->decay = true;
    out->where = -1; /* the same everywhere */
}

static const struct part_law law = {
    .rows = NEED_X | NEED_RHO | NEED_IRHO | NEED_R2 | NEED_GRADW_R2,
    .columns = COLUMN_DRHO,
    .acts = EFFECTS_ACT_FLUID,
    .pairs = pairs,
};

const struct part LANE_NAME(effects_density_diffusion) = {
    .name = "density-diffusion",
    .about = "smooths density, hydrostatic differences excepted",
    .equation = "(D2) m_a d rho_a/dt = sum_b m_a m_b 2 delta hs c0 (rho_a - rho_b - rho_H)/rhobar "
                "x.gradW/(r^2 + 0.01 hs^2)",
    .source = "Molteni, Colagrossi, Comput. Phys. Commun. 180 (2009) 861-872; "
              "Fourtakas et al., Comput. Fluids 190 (2019) 346-361",
    .size = sizeof(struct density_diffusion),
    .params = params,
    .needs = FIELD_DENSITY | FIELD_DENSITY_RATE,
    .prepare = prepare,
    .limit = limit,
    .as.law = &law,
};
