/* central-force.c -- a pull towards a point that grows with the distance.  It books
 * no power: what it does is potential energy.  Monaghan, Rafiee (2013), Int. J. Numer.
 * Meth. Fluids 71, 537. */
#include "effects/effects.h"

#include <math.h>

struct central_force {
    double omega;     /* [1/s] */
    double centre[3]; /* [m]   */
};

static const struct param params[] = {
    { .key = "omega", .unit = "1/s", .offset = offsetof(struct central_force, omega),
      .fallback = 1, .max = 1e6, .about = "frequency of a free particle about the centre [rad/s]" },
    { .key = "centre", .unit = "m", .type = PARAM_VECTOR,
      .offset = offsetof(struct central_force, centre), .min = -1e6, .max = 1e6,
      .about = "where it pulls to" },
    { 0 },
};

static void accelerate(const void *self, const struct view *v, int from, int to,
                       double (*rate)[DIM])
{
    const struct central_force *s = self;
    const double *x = v->x[KIND_FLUID];

    for (int i = from; i < to; i++)
        for (int d = 0; d < DIM; d++)
            rate[i][d] -= s->omega * s->omega * (x[i * DIM + d] - s->centre[d]);
}

static void energy(const void *self, const struct view *v, struct energy_sums *to)
{
    const struct central_force *s = self;
    const double *x = v->x[KIND_FLUID];
    struct exact_terms terms = { .to = &to->potential };

    for (int i = 0; i < particles_count(v->p, KIND_FLUID); i++) {
        double r2 = 0; /* times omega^2 */
        if (!view_has(v, i))
            continue;
        for (int d = 0; d < DIM; d++) {
            const double r = s->omega * (x[(size_t)i * DIM + d] - s->centre[d]);
            r2 += r * r;
        }
        exact_terms_add(&terms, 0.5 * v->p->m[i] * r2);
    }
    exact_terms_end(&terms);
}

static const struct part_force force = {
    .accelerate = accelerate,
    .placed = true,
};

const struct part LANE_NAME(effects_central_force) = {
    .name = "central-force",
    .about = "a pull towards a point, as of a spring",
    .equation = "(G2) dv_a/dt = -omega^2 (x_a - centre)",
    .source = "Monaghan, Rafiee 2013, Int. J. Numer. Meth. Fluids 71, 537",
    .size = sizeof(struct central_force),
    .params = params,
    .energy = energy,
    .as.force = &force,
};
