/* kernel-viscosity.c -- a viscosity that takes the kernel itself, not its gradient.
 *
 *   F_ab = -c_ab (v_a - v_b),  c_ab = m_a m_b mu/(rho0 l^2) W_ab/rhobar        (S2)
 *   l^2 = 5/144 H^2 in the plane, H^2/30 in space
 *
 * (S1) with the k that makes it a viscosity: to second order sum_b m_b/rho_b W_ab v_ab is
 * -l^2 lap v, with 2 D l^2 the mean of r^2 below the kernel.  The numbers are those of
 * Wendland's C2; with another kernel mu is not what the scene says.  c is no function of
 * velocities, and so velocities can be solved for: side = "implicit". */
#include "effects/effects.h"
#include "effects/viscosity-side.h"

struct kernel_viscosity {
    double mu;        /* [Pa s] */
    const char *side;
    double k;         /* rate of (S1), mu/(rho0 l^2) [1/s] */
};

static const struct param params[] = {
    { .key = "mu", .unit = "Pa s", .offset = offsetof(struct kernel_viscosity, mu),
      .fallback = 1e-3, .min = 0, .max = 1e4, .about = "dynamic viscosity; 0.001 is water" },
    VISCOSITY_SIDE(struct kernel_viscosity),
    { 0 },
};

static int prepare(void *self, const struct scales *scales)
{
    struct kernel_viscosity *s = self;
    const double l2 = (DIM == 2 ? 5.0 / 144 : 1.0 / 30) * scales->support * scales->support;

    s->k = s->mu / (scales->rho0 * l2);
    return 0;
}

LANES_INLINE lanes coupling(const struct kernel_viscosity *s, const struct side *a,
                            const struct block *b, int i)
{
    return (real)(s->k / 2) * (a->irho + b->irho[i]) * b->w[i];
}

static void pairs(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    struct sum t = *to; /* registers, not memory */

    for (int i = 0; i < b->n; i++) {
        const lanes c = coupling(self, a, b, i);
        for (int d = 0; d < DIM; d++)
            t.f[d] -= c * b->v[d][i];
    }
    *to = t;
}

/* There are no rows of velocities here: they are what is solved for. */
static void couple(const void *self, const struct side *a, const struct block *b,
                   struct coupling *to)
{
    for (int i = 0; i < b->n; i++)
        to->c[i] = coupling(self, a, b, i);
}

static bool stiff(const void *self)
{
    return viscosity_is_implicit(((const struct kernel_viscosity *)self)->side);
}

static bool faces(const void *self)
{
    (void)self;
    return false; /* it sticks where the particles of solids are */
}

static double mu(const void *self)
{
    return ((const struct kernel_viscosity *)self)->mu;
}

static void limit(const void *self, const struct view *v, struct limit *out)
{
    const struct kernel_viscosity *s = self;

    (void)v;
    out->rate = 1.5 * s->k; /* as in velocity-smoothing.c */
    out->decay = true;
    out->where = -1;
}

static const struct part_law law = {
    .rows = NEED_V | NEED_IRHO | NEED_W,
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

const struct part LANE_NAME(effects_kernel_viscosity) = {
    .name = "kernel-viscosity",
    .about = "viscosity by the kernel itself",
    .equation = "(S2) F_ab = -m_a m_b mu/(rho0 l^2) W_ab/rhobar (v_a - v_b)",
    .source = "(S1) with the rate of a viscosity",
    .size = sizeof(struct kernel_viscosity),
    .params = params,
    .needs = FIELD_DENSITY,
    .prepare = prepare,
    .limit = limit,
    .as.law = &law,
    .as.operator = &operator,
};
