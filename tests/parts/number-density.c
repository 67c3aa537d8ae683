/* number-density.c -- density as the number of particles around, times the own mass.
 *
 *   rho_a = m_a sum_b W_ab,  b = a included                                   (N1)
 *
 * A heavy particle beside light ones keeps its density, where (D3) mixes both.  With
 * equal masses (N1) is (D3).  Its rate is in no law, so the work of pressure closes in
 * no column of the book; summation.c has one.  Hu, Adams, J. Comput. Phys. 213 (2006)
 * 844-861, eq. 6. */
#include "effects/effects.h"

struct number_density {
    double centre; /* W(0) [1/m^D] */
};

static int prepare(void *self, const struct scales *s)
{
    struct number_density *o = self;

    o->centre = s->centre;
    return 0;
}

/* b->w is m_a m_b W: the neighbour's mass goes here, the own one in densities(). */
static void gather(const void *self, const struct side *a, const struct block *b,
                   struct field_sum *to)
{
    lanes sum = to->s[0]; /* registers, not memory */

    (void)self;
    (void)a;
    for (int i = 0; i < b->n; i++)
        sum += b->w[i] / b->m[i];
    to->s[0] = sum;
}

static void densities(const void *self, const struct part_sums *s, double *rho)
{
    const struct number_density *o = self;
    const int first = s->v->p->from[s->kind];

    for (int i = 0; i < s->n; i++)
        rho[s->owner[i] - first] = s->sum[i][0] + s->v->p->m[s->owner[i]] * o->centre;
}

static const struct part_summed summed = {
    .meets = { [KIND_FLUID] = KIND_BIT(KIND_FLUID) | KIND_SOLIDS },
    .rows = NEED_W | NEED_MASS,
    .gather = gather,
    .densities = densities,
};

const struct part LANE_NAME(effects_number_density) = {
    .name = "number-density",
    .about = "density as the number of particles around, times the own mass",
    .equation = "(N1) rho_a = m_a sum_b W_ab",
    .source = "Hu, Adams, J. Comput. Phys. 213 (2006) 844-861",
    .size = sizeof(struct number_density),
    .provides = FIELD_DENSITY,
    .instead = "continuity",
    .prepare = prepare,
    .as.summed = &summed,
};
