/* gravity.c -- weight of the fluid; in the plan when the scene's gravity is
 * not zero.  It books no power: what it does is potential energy, counted from
 * the lowest point of the domain.  (32) of Toth (2012). */
#include "effects/effects.h"

struct gravity {
    double g[DIM];      /* [m/s^2]                          */
    double lowest[DIM]; /* corner of the domain, lowest [m] */
};

static int prepare(void *self, const struct scales *scales)
{
    struct gravity *s = self;

    for (int d = 0; d < DIM; d++) {
        s->g[d] = scales->g[d];
        s->lowest[d] = scales->g[d] > 0 ? scales->high[d] : scales->low[d];
    }
    return 0;
}

static void accelerate(const void *self, const struct view *v, int from, int to,
                       double (*rate)[DIM])
{
    const struct gravity *s = self;

    (void)v;
    for (int i = from; i < to; i++)
        for (int d = 0; d < DIM; d++)
            rate[i][d] += s->g[d];
}

static void energy(const void *self, const struct view *v, struct energy_sums *to)
{
    const struct gravity *s = self;
    const double *x = v->x[KIND_FLUID];
    struct exact_terms terms = { .to = &to->potential };

    for (int i = 0; i < particles_count(v->p, KIND_FLUID); i++) {
        double height = 0; /* times g [m^2/s^2] */
        if (!view_has(v, i))
            continue;
        for (int d = 0; d < DIM; d++)
            height -= s->g[d] * (x[(size_t)i * DIM + d] - s->lowest[d]);
        exact_terms_add(&terms, v->p->m[i] * height);
    }
    exact_terms_end(&terms);
}

static const struct part_force force = {
    .accelerate = accelerate,
    .weight = true,
};

const struct part LANE_NAME(effects_gravity) = {
    .name = "gravity",
    .about = "weight of the fluid (the scene's `gravity` calls for it)",
    .equation = "(G1) dv_a/dt = g",
    .source = "Toth 2012, (32)",
    .size = sizeof(struct gravity),
    .prepare = prepare,
    .energy = energy,
    .as.force = &force,
};
