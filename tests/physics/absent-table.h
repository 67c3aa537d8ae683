/* absent-table.h -- the table of effects with a line more, for the lane width LANES;
 * the including file sets it.  The linker takes this table instead of the library's. */
#if LANES > 2 /* slow without AVX, but right: no vector leaves this file */
#pragma GCC diagnostic ignored "-Wpsabi"
#endif
#include "effects/effects.h"

#include <stddef.h>

/* An effect that would cost a lot: all columns, all rows, a density of its own. */
static void pairs(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    (void)self;
    for (int k = 0; k < b->n; k++) {
        for (int d = 0; d < DIM; d++)
            to->f[d] += b->w[k] * (a->rho - b->rho[k]) * b->v[d][k];
        to->drho += b->w[k] * b->xv[k];
    }
}

static void gather(const void *self, const struct side *a, const struct block *b,
                   struct field_sum *to)
{
    (void)self;
    (void)a;
    for (int k = 0; k < b->n; k++)
        to->s[0] += b->w[k];
}

static void densities(const void *self, const struct part_sums *s, double *rho)
{
    const int first = s->v->p->from[s->kind];

    (void)self;
    for (int i = 0; i < s->n; i++)
        rho[s->owner[i] - first] = 1000 + 1e-9 * s->sum[i][0];
}

static const struct part_law law = {
    .rows = 0x3ff, .columns = COLUMN_FORCE | COLUMN_DRHO, .acts = EFFECTS_ACT_ALL, .pairs = pairs,
};

static const struct part_summed summed = {
    .meets = EFFECTS_ACT_ALL, .rows = 0x3ff, .gather = gather, .densities = densities,
};

extern const struct part LANE_NAME(absent_effect);
const struct part LANE_NAME(absent_effect) = {
    .name = "absent", .about = "an effect for tests", .equation = "none", .source = "none",
    .needs = FIELD_DENSITY | FIELD_PRESSURE, .as.law = &law, .as.summed = &summed,
};

/* The table is the library's own text; its end becomes one line more and the end. */
#undef NULL
#define NULL &LANE_NAME(absent_effect), (const struct part *)0
#include "../../src/effects/effects.c"
