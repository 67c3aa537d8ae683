/* adami.c -- solids with the pressure of the fluid, carried over to them:
 *
 *   p_w = sum_f (p_f + rho_f (g - a_w) . (x_w - x_f)) W_wf / sum_f W_wf        (W1)
 *
 * over fluid neighbours, a_w the acceleration of the wall (0 for the skin of a body:
 * the right-hand side may not depend on what it has not worked out yet).  rho_w
 * follows from p_w by the equation of state.  No state, no gap at the wall; but its
 * pressure work is no change of any energy, so the book shows a pressure_defect.
 * Their velocity of walls for the viscous force is a thing of its own, eval/face-forces.c.
 * Adami, Hu, Adams, J. Comput. Phys. 231 (2012) 7057-7075, eq. 27.  Checked in
 * tests/physics/walls.c. */
#include "matter/eos.h"
#include "space/pairs.h"
#include "walls/walls.h"

struct adami {
    struct eos eos;
    double g[DIM]; /* [m/s^2] */
    double least;  /* pressure of half the density at rest [Pa] */
};

static const char *const with[] = { "continuity", "summation", NULL };

static int prepare(void *self, const struct scales *s)
{
    struct adami *w = self;

    w->eos = (struct eos){ .rho0 = s->rho0, .c0 = s->c0, .gamma = s->gamma,
                           .clamped = s->clamped };
    w->least = eos_pressure(&w->eos, s->rho0 / 2);
    for (int d = 0; d < DIM; d++)
        w->g[d] = s->g[d];
    return 0;
}

/* s[0] = sum W, s[1] = sum p_f W, s[2..] = sum rho_f x W, all times the masses. */
static void gather(const void *self, const struct side *a, const struct block *b,
                   struct field_sum *to)
{
    struct field_sum t = *to; /* registers, not memory */

    (void)self;
    (void)a;
    for (int k = 0; k < b->n; k++) {
        const lanes rho_w = b->rho[k] * b->w[k];
        t.s[0] += b->w[k];
        t.s[1] += b->p2[k] * b->rho[k] * rho_w;
        for (int d = 0; d < DIM; d++)
            t.s[2 + d] += rho_w * b->x[d][k];
    }
    *to = t;
}

/* A wall that no fluid is near has the density at rest; tension is carried over as
 * far as half that density goes, for beyond the equation of state has no inverse. */
static double density(const struct adami *w, const double *acceleration, const double *sum)
{
    double p = sum[1];

    if (!(sum[0] > 0))
        return w->eos.rho0;
    for (int d = 0; d < DIM; d++)
        p += (w->g[d] - acceleration[d]) * sum[2 + d];
    p /= sum[0];
    return eos_density(&w->eos, p > w->least ? p : w->least);
}

static void densities(const void *self, const struct part_sums *s, double *rho)
{
    const struct particles *p = s->v->p;
    const int first = p->from[s->kind];

    for (int i = 0; i < s->n; i++) {
        const int c = s->owner[i];
        double a[DIM];
        object_acceleration(&p->object[p->object_of[c]], p->x[c], a);
        rho[c - first] = density(self, a, s->sum[i]);
    }
}

#define FLUID KIND_BIT(KIND_FLUID)

static const struct part_summed summed = {
    .meets = { [KIND_WALL] = FLUID, [KIND_WALL_SLIP] = FLUID, [KIND_SKIN] = FLUID,
               [KIND_SKIN_SLIP] = FLUID },
    .rows = NEED_X | NEED_RHO | NEED_P2 | NEED_W,
    .gather = gather,
    .densities = densities,
};

static const struct part_wall wall = {
    .with = with,
};

const struct part LANE_NAME(walls_adami) = {
    .name = "adami",
    .about = "solids with the pressure of the fluid before them, extrapolated",
    .equation = "(W1) p_w = sum_f (p_f + rho_f (g - a_w).(x_w - x_f)) W_wf / sum_f W_wf",
    .source = "Adami, Hu, Adams, J. Comput. Phys. 231 (2012) 7057-7075",
    .size = sizeof(struct adami),
    .needs = FIELD_DENSITY | FIELD_PRESSURE,
    .prepare = prepare,
    .as.summed = &summed,
    .as.wall = &wall,
};
