/* shepard-filter.c -- from time to time the density of the water becomes a mean over neighbours.
 *
 *   rho_a <- sum_b m_b W_ab / sum_b m_b/rho_b W_ab,  b = a included          (D7)
 *
 * over fluid, at t = k T: an event between two segments of the run, no rate.  Noise that (D1)
 * piles up goes; a constant density stays what it is, at a free surface too.  Masses and
 * velocities stay; energy that the densities store changes at once, and the book has that by
 * name.  A slope of the density is flattened where neighbours are missing on one side, so
 * that a deep column loses a little pressure at each event.
 * Seed 003, section 2 (its formula has no self term told); Shepard, Proc. 23rd ACM Nat. Conf.
 * (1968) 517-524.  T defaults to 30 steps of sound, 0.3 hs/c0 each: usual are 20 to 50.
 * Checked in tests/physics/shepard.c. */
#include "effects/effects.h"

#include "base/status.h"

#include <math.h>

struct shepard_filter {
    double interval; /* T                           [s]     */
    double steps;    /* of sound                    [1]     */
    double centre;   /* density kernel at its centre [1/m^D] */
};

static const double step_of_sound = 0.3; /* [hs/c0] */

static const struct param params[] = {
    { .key = "interval", .unit = "s", .offset = offsetof(struct shepard_filter, interval),
      .fallback = 0, .max = 1e6,
      .about = "time from one filtering to the next; 0: by steps, steps 0.3 hs/c0 with hs half "
               "the support" },
    { .key = "steps", .unit = "1", .offset = offsetof(struct shepard_filter, steps),
      .fallback = 30, .min = 1, .max = 1e6,
      .about = "steps of sound, 0.3 hs/c0 each, from one filtering to the next, when interval "
               "is 0" },
    { 0 },
};

static int prepare(void *self, const struct scales *s)
{
    const double least = step_of_sound * s->hs / s->c0;
    struct shepard_filter *o = self;

    o->centre = s->centre;
    if (o->interval == 0)
        o->interval = o->steps * least;
    if (o->interval < least)
        return status_fail(STATUS_BAD_SCENE, "effects.shepard-filter.interval = %g s is shorter "
                           "than a step of sound, 0.3 hs/c0 = %g s, and each filtering ends a "
                           "segment of the run: set %g s or so", o->interval, least, 30 * least);
    return STATUS_DONE;
}

/* t may be an event itself, but for rounding. */
static double event(const void *self, double t)
{
    const struct shepard_filter *o = self;
    double k = floor(t / o->interval);

    while (k * o->interval > t)
        k--;
    while (k * o->interval <= t)
        k++;
    return k * o->interval;
}

/* s[0] = sum m_b W, s[1] = sum m_b/rho_b W without a itself, times m_a. */
static void gather(const void *self, const struct side *a, const struct block *b,
                   struct field_sum *to)
{
    struct field_sum t = *to; /* registers, not memory */

    (void)self;
    (void)a;
    for (int k = 0; k < b->n; k++) {
        t.s[0] += b->w[k];
        t.s[1] += b->irho[k] * b->w[k];
    }
    *to = t;
}

/* (D7) */
static void densities(const void *self, const struct part_sums *s, double *rho)
{
    const struct shepard_filter *o = self;
    const int first = s->v->p->from[s->kind];

    for (int i = 0; i < s->n; i++) {
        const double m = s->v->p->m[s->owner[i]], own = m * m * o->centre;
        double *now = &rho[s->owner[i] - first];
        *now = (s->sum[i][0] + own) / (s->sum[i][1] + own / *now);
    }
}

static const struct part_filter filter = {
    .event = event,
    .meets = { [KIND_FLUID] = KIND_BIT(KIND_FLUID) },
    .rows = NEED_IRHO | NEED_W,
    .gather = gather,
    .densities = densities,
};

const struct part LANE_NAME(effects_shepard_filter) = {
    .name = "shepard-filter",
    .about = "from time to time the density of the water becomes a mean over neighbours",
    .equation = "(D7) rho_a <- sum_b m_b W_ab / sum_b m_b/rho_b W_ab, at t = k interval",
    .source = "seed 003, section 2; Shepard, Proc. 23rd ACM Nat. Conf. (1968) 517-524",
    .size = sizeof(struct shepard_filter),
    .params = params,
    .needs = FIELD_DENSITY | FIELD_DENSITY_RATE,
    .prepare = prepare,
    .as.filter = &filter,
};
