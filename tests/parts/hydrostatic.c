/* hydrostatic.c -- solids with the mean density of the fluid before them, and of the
 * water that would stand between:
 *
 *   rho_w = sum_f (rho_f + rho0 g.(x_w - x_f)/c0^2) W_wf / sum_f W_wf            (W9)
 *
 * over fluid neighbours: (W1) of adami.c with dp = c0^2 drho, for walls at rest and
 * water that is hardly compressed. */
#include "space/pairs.h"
#include "walls/walls.h"

struct hydrostatic {
    double rho0;       /* [kg/m^D] */
    double slope[DIM]; /* of the density of water at rest, rho0 g/c0^2 [kg/m^D / m] */
};

static const char *const with[] = { "continuity", "summation", NULL };

static int prepare(void *self, const struct scales *s)
{
    struct hydrostatic *w = self;

    w->rho0 = s->rho0;
    for (int d = 0; d < DIM; d++)
        w->slope[d] = s->rho0 * s->g[d] / (s->c0 * s->c0);
    return 0;
}

/* s[0] = sum W, s[1] = sum rho_f W, s[2..] = sum (x_w - x_f) W, all times the masses. */
static void gather(const void *self, const struct side *a, const struct block *b,
                   struct field_sum *to)
{
    struct field_sum t = *to; /* registers, not memory */

    (void)self;
    (void)a;
    for (int i = 0; i < b->n; i++) {
        t.s[0] += b->w[i];
        t.s[1] += b->w[i] * b->rho[i];
        for (int d = 0; d < DIM; d++)
            t.s[2 + d] += b->w[i] * b->x[d][i];
    }
    *to = t;
}

/* A wall that no fluid is near has the density at rest. */
static double density(const struct hydrostatic *w, const double *sum)
{
    double rho = sum[1];

    if (!(sum[0] > 0))
        return w->rho0;
    for (int d = 0; d < DIM; d++)
        rho += w->slope[d] * sum[2 + d];
    return rho / sum[0];
}

static void densities(const void *self, const struct part_sums *s, double *rho)
{
    const int first = s->v->p->from[s->kind];

    for (int i = 0; i < s->n; i++)
        rho[s->owner[i] - first] = density(self, s->sum[i]);
}

#define FLUID KIND_BIT(KIND_FLUID)

static const struct part_summed summed = {
    .meets = { [KIND_WALL] = FLUID, [KIND_WALL_SLIP] = FLUID, [KIND_SKIN] = FLUID,
               [KIND_SKIN_SLIP] = FLUID },
    .rows = NEED_X | NEED_RHO | NEED_W,
    .gather = gather,
    .densities = densities,
};

static const struct part_wall wall = {
    .with = with,
};

const struct part LANE_NAME(walls_hydrostatic) = {
    .name = "hydrostatic",
    .about = "solids with the density of the fluid before them, as in water at rest",
    .equation = "(W9) rho_w = sum_f (rho_f + rho0 g.(x_w - x_f)/c0^2) W_wf / sum_f W_wf",
    .source = "after Adami, Hu, Adams, J. Comput. Phys. 231 (2012) 7057-7075",
    .size = sizeof(struct hydrostatic),
    .needs = FIELD_DENSITY | FIELD_PRESSURE,
    .prepare = prepare,
    .as.summed = &summed,
    .as.wall = &wall,
};
