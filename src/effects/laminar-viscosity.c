/* laminar-viscosity.c -- laminar viscosity between neighbouring particles.
 *
 *   F_ab = m_a m_b 2 mu/(rho_a rho_b) (x . gradW)/(r^2 + 0.01 hs^2) v       (V1)
 *
 * with x = x_a - x_b, v = v_a - v_b, hs half the support.  x . gradW is never
 * positive, so F_ab . v is not either: this effect only takes energy out.
 * Morris, Fox, Zhu, J. Comput. Phys. 136 (1997) 214-226, constant mu.  It
 * stands for the seed's (28)-(31), whose printed kernel is wrong in sign and
 * dimension.  Checked in tests/physics/laws.c. */
#include "effects/effects.h"
#include "effects/lightest.h"
#include "effects/viscosity-side.h"

struct laminar_viscosity {
    double mu;   /* dynamic viscosity                 [Pa s] */
    double rate; /* fastest decay with nu = 1         [1/m^2] */
    const char *side, *stick;
};

static const char *const sticks[] = { "face", "particles", NULL };

static const struct param params[] = {
    { .key = "mu", .unit = "Pa s", .offset = offsetof(struct laminar_viscosity, mu),
      .fallback = 1e-3, .min = 0, .max = 1e4, .about = "dynamic viscosity; 0.001 is water" },
    VISCOSITY_SIDE(struct laminar_viscosity),
    VISCOSITY_STICK(struct laminar_viscosity),
    { 0 },
};

/* The c of rows k, F_ab = -c v. */
LANES_INLINE lanes coupling(const struct laminar_viscosity *s, const struct side *a,
                            const struct block *b, int k)
{
    return -2 * s->mu * (a->irho * b->irho[k]) * (b->gw_r2[k] * b->r2[k]);
}

static void pairs(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    const struct laminar_viscosity *s = self;
    struct sum t = *to; /* registers, not memory */

    for (int k = 0; k < b->n; k++) {
        const lanes c = coupling(s, a, b, k);
        for (int d = 0; d < DIM; d++)
            t.f[d] -= c * b->v[d][k];
    }
    *to = t;
}

static void couple(const void *self, const struct side *a, const struct block *b,
                   struct coupling *to)
{
    for (int k = 0; k < b->n; k++)
        to->c[k] = coupling(self, a, b, k);
}

static bool stiff(const void *self)
{
    const struct laminar_viscosity *s = self;
    return viscosity_is_implicit(s->side);
}

static bool faces(const void *self)
{
    const struct laminar_viscosity *s = self;
    return viscosity_at_faces(s->stick);
}

static double mu(const void *self)
{
    return ((const struct laminar_viscosity *)self)->mu;
}

static int prepare(void *self, const struct scales *scales)
{
    struct laminar_viscosity *s = self;

    s->rate = SCALES_LAPLACE * scales->laplace_viscosity / (scales->hs * scales->hs);
    return 0;
}

static void limit(const void *self, const struct view *v, struct limit *out)
{
    const struct laminar_viscosity *s = self;
    out->rate = s->rate * s->mu / lightest_fluid(v, &out->where);
    out->decay = true;
}

const struct part LANE_NAME(effects_laminar_viscosity) = {
    .name = "laminar-viscosity",
    .about = "laminar viscosity between neighbours",
    .equation = "(V1) F_ab = m_a m_b 2 mu/(rho_a rho_b) (x.gradW)/(r^2 + 0.01 hs^2) v",
    .source = "Morris, Fox, Zhu, J. Comput. Phys. 136 (1997) 214-226",
    .size = sizeof(struct laminar_viscosity),
    .params = params,
    .needs = FIELD_DENSITY,
    .rows = NEED_V | NEED_IRHO | NEED_R2 | NEED_GRADW_R2,
    .columns = COLUMN_FORCE,
    .kernel = PART_VISCOSITY,
    .acts = EFFECTS_ACT_STICKY,
    .prepare = prepare,
    .pairs = pairs,
    .couple = couple,
    .stiff = stiff,
    .faces = faces,
    .mu = mu,
    .limit = limit,
};
