/* particle-shifting.c -- particles drift from where they crowd to where there is room,
 * beside their velocity, so that a flow does not draw them out into threads.
 *
 *   dx_a/dt = v_a + w_a,   w_a = -k U hs s(C_a) grad C_a                      (D4)
 *   C_a = sum_b m_b/rho_b W_ab (a included),  grad C_a = sum_b m_b/rho_b grad W_ab
 *
 * s goes from 0 at C = 0.85 to 1 at 0.95: near a free surface, where C says nothing of
 * crowding, no particle drifts.  |w| stays below U/2.  Velocity and density stay those of the
 * particle: what a drift through their slopes would change is left out, an error that
 * goes with dx.  A drift across the weight is energy, and booked; scenes with other body
 * forces are refused.  After Sun, Colagrossi, Marrone, Zhang, Comput. Methods Appl. Mech.
 * Engrg. 315 (2017) 25-49, eq. 9, without the term against pairing, and per unit of time.
 * Checked in tests/physics/shifting.c. */
#include "effects/effects.h"

#include <math.h>

struct particle_shifting {
    double strength; /* k                       [1]      */
    double reach;    /* k U hs                  [m^2/s]  */
    double most;     /* U/2                     [m/s]    */
    double centre;   /* W(0)                    [1/m^D]  */
    double rate;     /* fastest decay           [1/s]    */
};

static const double bare = 0.85, full = 0.95; /* C where drift begins, where it is full */

static const struct param params[] = {
    { .key = "strength", .unit = "1", .offset = offsetof(struct particle_shifting, strength),
      .fallback = 8, .max = 100, .about = "strength of the drift, in units of U hs" },
    { 0 },
};

static int prepare(void *self, const struct scales *scales)
{
    struct particle_shifting *s = self;

    s->reach = s->strength * scales->speed * scales->hs;
    s->most = scales->speed / 2;
    s->centre = scales->centre;
    s->rate = SCALES_LAPLACE * scales->laplace_density * s->reach / (scales->hs * scales->hs);
    return 0;
}

static void gather(const void *self, const struct side *a, const struct block *b,
                   struct field_sum *to)
{
    struct field_sum t = *to; /* registers, not memory */

    (void)self;
    (void)a;
    for (int k = 0; k < b->n; k++) {
        const lanes gw_rho = b->gw[k] * b->irho[k];
        t.s[0] += b->w[k] * b->irho[k];
        for (int d = 0; d < DIM; d++)
            t.s[1 + d] += gw_rho * b->x[d][k];
    }
    *to = t;
}

/* Smooth from 0 to 1. */
static double inside(double c)
{
    const double s = c <= bare ? 0 : c >= full ? 1 : (c - bare) / (full - bare);

    return s * s * (3 - 2 * s);
}

static void carry(const void *self, const struct part_sums *s, double (*drift)[DIM])
{
    const struct particle_shifting *o = self;
    const struct particles *p = s->v->p;
    const int first = p->from[s->kind];

    for (int i = 0; i < s->n; i++) {
        const int c = s->owner[i];
        const double m = p->m[c], *sum = s->sum[i];
        const double all = sum[0] / m + m / s->v->rho[s->kind][c - first] * o->centre;
        double w[DIM], w2 = 0;
        for (int d = 0; d < DIM; d++) {
            w[d] = -o->reach * inside(all) * sum[1 + d] / m;
            w2 += w[d] * w[d];
        }
        for (int d = 0; d < DIM; d++)
            drift[c - first][d] += w[d] / sqrt(1 + w2 / (o->most * o->most));
    }
}

static void limit(const void *self, const struct view *v, struct limit *out)
{
    const struct particle_shifting *s = self;

    (void)v;
    out->rate = s->rate;
    out->decay = true;
    out->where = -1; /* the same everywhere */
}

#define ALL_KINDS (KIND_BIT(KIND_FLUID) | KIND_SOLIDS)

static const struct part_summed summed = {
    .meets = { [KIND_FLUID] = ALL_KINDS },
    .rows = NEED_X | NEED_IRHO | NEED_W | NEED_GRADW,
    .gather = gather,
    .carry = carry,
};

const struct part LANE_NAME(effects_particle_shifting) = {
    .name = "particle-shifting",
    .about = "particles drift from crowds to gaps: for vortices, and tension far from a surface",
    .equation = "(D4) dx_a/dt = v_a - k U hs s(C_a) grad C_a",
    .source = "Sun, Colagrossi, Marrone, Zhang, Comput. Methods Appl. Mech. Engrg. 315 (2017) "
              "25-49",
    .size = sizeof(struct particle_shifting),
    .params = params,
    .needs = FIELD_DENSITY,
    .prepare = prepare,
    .limit = limit,
    .as.summed = &summed,
};
