/* contact-potential.c -- solids repel the fluid by a potential of their particles' nearness.
 *
 *   E_ab = strength U^2 m_a m_b/m f^n,   f = W(r)/W(dx), m = rho0 dx^D     (W7)
 *   F_ab = -n strength U^2 m_a m_b/m f^(n-1) gradW_ab/W(dx)
 *
 * between a fluid particle and one of a solid: K = strength rho0 U^2 (rho0/m) in the words of
 * Vignjevic, De Vuyst, Campbell, ICCES 3 (2007) 107-112, with their minus, which the force of
 * seed 003 is printed without.  It keeps energy, momentum and moment, knows no friction, and is
 * in the place of a pressure of solids: walls = "potential" are those that nothing else acts on.
 * Checked in tests/physics/potential.c. */
#include "effects/effects.h"

enum { MOST = 8 }; /* n, at most */

struct contact_potential {
    double strength; /* energy of two at dx by m U^2  [1]   */
    int n;           /* power of W                          */
    double nearby;   /* 1/W(dx)                       [m^D] */
    double push;     /* n strength U^2/(m W(dx))            */
    double rate;     /* the fastest                   [1/s] */
};

static const struct param params[] = {
    { .key = "strength", .unit = "1", .offset = offsetof(struct contact_potential, strength),
      .fallback = 0.3, .min = 1e-3, .max = 100,
      .about = "energy that a particle of the fluid and one of a solid have at the spacing dx, over m U^2" },
    { .key = "n", .type = PARAM_INTEGER, .unit = "1", .offset = offsetof(struct contact_potential, n),
      .fallback = 4, .min = 2, .max = MOST,
      .about = "power of the kernel: a larger one makes it stiffer and shorter" },
    { 0 },
};

static void pairs(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    const struct contact_potential *s = self;
    const real nearby = (real)s->nearby, push = (real)s->push;
    const lanes least = lanes_all(LANES_LEAST);
    struct sum t = *to; /* registers, not memory */

    (void)a;
    for (int k = 0; k < b->n; k++) {
        const lanes f = nearby * b->w[k] / lanes_max(b->mm[k], least);
        lanes c = push * b->gw[k] * f;
        for (int i = 2; i < s->n; i++)
            c *= f;
        for (int d = 0; d < DIM; d++)
            t.f[d] -= c * b->x[d][k];
    }
    *to = t;
}

/* Where a particle with U is turned back its energy in the potential is m U^2/2, whatever the
 * strength, and the second derivative of that at most (n |W'|/W)^2 of it, with |W'|/W = 2.2/dx
 * half a support away: omega = 1.6 n U/dx. */
static int prepare(void *self, const struct scales *scales)
{
    struct contact_potential *s = self;

    s->nearby = 1 / scales->nearby;
    s->push = s->n * s->strength * scales->speed * scales->speed / (scales->mass * scales->nearby);
    s->rate = 1.6 * s->n * scales->speed / scales->dx;
    return 0;
}

static void limit(const void *self, const struct view *v, struct limit *out)
{
    const struct contact_potential *s = self;

    (void)v;
    out->rate = s->rate;
    out->where = -1; /* the same everywhere */
}

static const struct part_law law = {
    .rows = NEED_X | NEED_W | NEED_GRADW,
    .columns = COLUMN_FORCE,
    .kernel = PART_PRESSURE,
    .acts = EFFECTS_ACT_SOLIDS,
    .pairs = pairs,
};

const struct part LANE_NAME(effects_contact_potential) = {
    .name = "contact-potential",
    .about = "solids repel the fluid by a potential, without pressure or friction",
    .equation = "(W7) F_ab = -n strength U^2 m_a m_b/(rho0 dx^D) (W/W(dx))^(n-1) gradW_ab/W(dx)",
    .source = "Vignjevic, De Vuyst, Campbell, ICCES 3 (2007) 107-112",
    .size = sizeof(struct contact_potential),
    .params = params,
    .prepare = prepare,
    .limit = limit,
    .as.law = &law,
};
