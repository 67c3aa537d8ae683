/* laminar-viscosity.c -- laminar viscosity between neighbouring particles.
 *
 *   F_ab = m_a m_b 2 mu/(rho_a rho_b) (x . gradW)/(r^2 + 0.01 hs^2) v       (V1)
 *
 * with x = x_a - x_b, v = v_a - v_b, hs half the support.  x . gradW is never
 * positive, so F_ab . v is not either: this effect only takes energy out.
 * Morris, Fox, Zhu, J. Comput. Phys. 136 (1997) 214-226, constant mu.  It
 * stands for (28)-(31) of Toth (2012), whose printed kernel is wrong in sign and
 * dimension.  Checked in tests/physics/laws.c. */
#include "effects/effects.h"
#include "effects/laminar-viscosity.h"
#include "effects/lightest.h"
#include "effects/viscosity-side.h"

static const char *const sticks[] = { "face", "particles", NULL };

static const struct param params[] = {
    { .key = "mu", .unit = "Pa s", .offset = offsetof(struct laminar_viscosity, mu),
      .fallback = 1e-3, .min = 0, .max = 1e4, .about = "dynamic viscosity; 0.001 is water" },
    VISCOSITY_SIDE(struct laminar_viscosity),
    VISCOSITY_STICK(struct laminar_viscosity),
    { 0 },
};

static void pairs(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    pairs_rows(laminar_viscosity_row, self, a, b, to);
}

static void couple(const void *self, const struct side *a, const struct block *b,
                   struct coupling *to)
{
    for (int k = 0; k < b->n; k++) {
        const struct row row = pairs_row(b, k);
        to->c[k] = laminar_viscosity_coupling(self, a, &row);
    }
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
    out->rate = s->rate * s->mu / lightest_fluid(v, out);
    out->decay = true;
}

static const struct part_law law = {
    .rows = NEED_V | NEED_IRHO | NEED_R2 | NEED_GRADW_R2,
    .columns = COLUMN_FORCE,
    .kernel = PART_VISCOSITY,
    .acts = EFFECTS_ACT_STICKY,
    .pairs = pairs,
};

static const struct part_operator operator = {
    .couple = couple,
    .stiff = stiff,
    .faces = faces,
    .mu = mu,
};

const struct part LANE_NAME(effects_laminar_viscosity) = {
    .name = "laminar-viscosity",
    .about = "laminar viscosity between neighbours",
    .equation = "(V1) F_ab = m_a m_b 2 mu/(rho_a rho_b) (x.gradW)/(r^2 + 0.01 hs^2) v",
    .source = "Morris, Fox, Zhu, J. Comput. Phys. 136 (1997) 214-226",
    .size = sizeof(struct laminar_viscosity),
    .params = params,
    .needs = FIELD_DENSITY,
    .prepare = prepare,
    .limit = limit,
    .as.law = &law,
    .as.operator = &operator,
};
