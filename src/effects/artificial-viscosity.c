/* artificial-viscosity.c -- Monaghan's viscosity, with or without its switch.
 *
 *   F_ab = m_a m_b alpha c0 hs (v.x) / (rhobar (r^2 + 0.01 hs^2)) gradW_ab  (V2)
 *
 * with x = x_a - x_b, v = v_a - v_b, hs half the support and rhobar the harmonic
 * mean of both densities, 1/rhobar = (1/rho_a + 1/rho_b)/2, which needs no
 * division and is less than the published arithmetic mean by a fraction of
 * (rho_a - rho_b)^2/(4 rhobar^2).
 *
 * The published form acts on approaching pairs (v.x < 0) only; that switch makes
 * f rough and costs two to three digits of accuracy in time, so it is off unless
 * the scene asks.  F_ab . v is never positive: this effect only takes energy out.
 * It is worth a kinematic viscosity of alpha c0 hs / (2 (D + 2)), which keeps the fluid
 * smooth and is no property of it: as friction at walls it brakes thin sheets of water and
 * halves what they do to a wall.  So solids are left out, unless stick = "particles".
 * Monaghan, Annu. Rev. Astron. Astrophys. 30 (1992) 543-574, eq. 4.1-4.2.
 * Checked in tests/physics/laws.c. */
#include "effects/artificial-viscosity.h"
#include "effects/effects.h"

#include <string.h>

/* The default first. */
static const char *const sticks[] = { "none", "particles", NULL };

static const struct param params[] = {
    { .key = "alpha", .unit = "1", .offset = offsetof(struct artificial_viscosity, alpha),
      .fallback = 0.02, .min = 0, .max = 10, .about = "strength of the viscosity" },
    { .key = "only_approaching", .unit = "", .type = PARAM_FLAG,
      .offset = offsetof(struct artificial_viscosity, only_approaching), .fallback = 0,
      .max = 1, .about = "act on approaching pairs only, as published (rough in time)" },
    { .key = "stick", .unit = "", .type = PARAM_WORD,
      .offset = offsetof(struct artificial_viscosity, stick), .words = sticks,
      .about = "which solids brake the fluid: it sticks where their \"particles\" are, or \"none\" "
               "do and it slips along them" },
    { 0 },
};

static void pairs(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    pairs_rows(artificial_viscosity_row, self, a, b, to);
}

LANES_INLINE void approaching_row(const void *self, const struct side *a, const struct row *b,
                                  struct sum *to)
{
    artificial_viscosity_along(self, a, b, -lanes_positive(-b->xv), to);
}

static void pairs_approaching(const void *self, const struct side *a, const struct block *b,
                              struct sum *to)
{
    pairs_rows(approaching_row, self, a, b, to);
}

static part_pairs *choose(const void *self)
{
    const struct artificial_viscosity *s = self;

    return s->only_approaching ? pairs_approaching : pairs;
}

static const unsigned *kinds(const void *self)
{
    static const unsigned sticky[KINDS] = EFFECTS_ACT_STICKY, fluid[KINDS] = EFFECTS_ACT_FLUID;
    const struct artificial_viscosity *s = self;

    return strcmp(s->stick, "none") == 0 ? fluid : sticky;
}

/* Longitudinal waves feel three times the shear viscosity of (V2). */
static int prepare(void *self, const struct scales *scales)
{
    struct artificial_viscosity *s = self;
    const double nu = s->alpha * scales->c0 * scales->hs / (2 * (DIM + 2));

    s->strength = s->alpha * scales->c0 * scales->hs / 2;
    s->rate = 3 * SCALES_LAPLACE * scales->laplace_viscosity * nu / (scales->hs * scales->hs);
    return 0;
}

static void limit(const void *self, const struct view *v, struct limit *out)
{
    const struct artificial_viscosity *s = self;

    (void)v;
    out->rate = s->rate;
    out->decay = true;
    out->where = -1; /* the same everywhere */
}

static const struct part_law law = {
    .rows = NEED_X | NEED_IRHO | NEED_XV | NEED_GRADW_R2,
    .columns = COLUMN_FORCE,
    .kernel = PART_VISCOSITY,
    .pairs = pairs,
    .choose = choose,
    .kinds = kinds,
};

const struct part LANE_NAME(effects_artificial_viscosity) = {
    .name = "artificial-viscosity",
    .about = "Monaghan's viscosity along the line of centres",
    .equation = "(V2) F_ab = m_a m_b alpha c0 hs (v.x)/(rhobar (r^2 + 0.01 hs^2)) gradW_ab",
    .source = "Monaghan, Annu. Rev. Astron. Astrophys. 30 (1992) 543-574",
    .size = sizeof(struct artificial_viscosity),
    .params = params,
    .needs = FIELD_DENSITY,
    .prepare = prepare,
    .limit = limit,
    .as.law = &law,
};
