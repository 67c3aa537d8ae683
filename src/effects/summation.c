/* summation.c -- density as a sum over neighbours, not as state.
 *
 *   rho_a = sum_b m_b W_ab,  b = a included                           (D3), (14)
 *
 * Its rate is (D1) exactly, so with the same kernel in the pressure force (P1) the
 * energy closes, but for solids that move against each other: they meet in the sum
 * and not in the force.  The rate is summed for the book only.  At a free surface
 * half of the neighbours are missing: rho < rho0 there, which pulls the surface into
 * clumps unless the equation of state has tension = false.  Toth 2012, (14).
 * Checked in tests/physics/summation.c. */
#include "effects/density-rate.h"
#include "effects/effects.h"

struct summation {
    double centre; /* W(0) [1/m^D] */
};

static int prepare(void *self, const struct scales *s)
{
    struct summation *o = self;

    o->centre = s->centre;
    return 0;
}

static void gather(const void *self, const struct side *a, const struct block *b,
                   struct field_sum *to)
{
    lanes sum = to->s[0];

    (void)self;
    (void)a;
    for (int k = 0; k < b->n; k++)
        sum += b->w[k];
    to->s[0] = sum;
}

static void densities(const void *self, const struct part_sums *s, double *rho)
{
    const struct summation *o = self;
    const int first = s->v->p->from[s->kind];

    for (int i = 0; i < s->n; i++) {
        const double m = s->v->p->m[s->owner[i]];
        rho[s->owner[i] - first] = s->sum[i][0] / m + m * o->centre;
    }
}

static void pairs(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    pairs_rows(density_rate_row, self, a, b, to);
}

#define ALL_KINDS (KIND_BIT(KIND_FLUID) | KIND_SOLIDS)
#define MEETS_ALL                                                                        \
    { [KIND_FLUID] = ALL_KINDS, [KIND_WALL] = ALL_KINDS, [KIND_WALL_SLIP] = ALL_KINDS,   \
      [KIND_SKIN] = ALL_KINDS, [KIND_SKIN_SLIP] = ALL_KINDS }

static const struct part_law law = {
    .rows = NEED_XV | NEED_GRADW,
    .columns = COLUMN_DRHO,
    .acts = MEETS_ALL,
    .conservative = true,
    .pairs = pairs,
};

static const struct part_summed summed = {
    .meets = MEETS_ALL,
    .rows = NEED_W,
    .gather = gather,
    .densities = densities,
};

const struct part LANE_NAME(effects_summation) = {
    .name = "summation",
    .about = "density as a sum over neighbours; take eos.tension = false with it",
    .equation = "(D3) rho_a = sum_b m_b W_ab",
    .source = "Toth 2012, (14)",
    .size = sizeof(struct summation),
    .provides = FIELD_DENSITY,
    .instead = "continuity",
    .prepare = prepare,
    .as.law = &law,
    .as.summed = &summed,
};
