/* density-healing.c -- the density of water without pressure comes back to that at rest.
 *
 *   d rho_a/dt = strength c0/hs x^3/(x^2 + d^2),  x = max(0, rho0 - rho_a)         (D5)
 *   d = 0.1 rho0 (U/c0)^2
 *
 * With eos.tension = false nothing holds water together that is drawn apart: its density
 * falls by (D1), and no pressure pushes until it is back at rho0, which water that meets
 * again may be long before its particles are at their distances.  This brings it back in
 * some hs/(strength c0), differences much below d, those of water at rest, hardly at all.
 * Where it acts pressure and stored energy are 0, so that it has no power and the books stay
 * exact; with tension it would have, and only strength = 0 is accepted.  The price is volume:
 * particles that are rho0 again and still apart push one another away before they have met.
 * So it is to be weak.  Ours; checked in tests/physics/healing.c. */
#include "effects/effects.h"

#include "base/status.h"

struct density_healing {
    double strength;
    double rho0;
    double square;   /* d^2                        [kg^2/m^2D] */
    double rate;     /* strength c0/hs             [1/s]       */
};

static const struct param params[] = {
    { .key = "strength", .unit = "1", .offset = offsetof(struct density_healing, strength),
      .fallback = 0.01, .min = 0, .max = 1,
      .about = "rate at which it comes back, in c0/hs, hs half the support" },
    { 0 },
};

static int prepare(void *self, const struct scales *scales)
{
    struct density_healing *s = self;
    const double mach = scales->speed / scales->c0, d = 0.1 * scales->rho0 * mach * mach;

    if (!scales->clamped && s->strength > 0)
        return status_fail(STATUS_BAD_SCENE, "effects.density-healing acts below rho0 = %g kg/m^3 "
                           "where no pressure is, but eos.tension = true has tension there: set "
                           "eos.tension = false, or strength = 0", scales->rho0);
    s->rho0 = scales->rho0;
    s->square = d * d;
    s->rate = s->strength * scales->c0 / scales->hs;
    return STATUS_DONE;
}

/* (D5) */
static void densify(const void *self, const struct view *v, int from, int to, double *rate)
{
    const struct density_healing *s = self;
    const double *rho = v->rho[KIND_FLUID];

    for (int i = from; i < to; i++) {
        const double lack = s->rho0 - rho[i], x = lack > 0 ? lack : 0, x2 = x * x;
        rate[i] += s->rate * x * x2 / (x2 + s->square);
    }
}

/* The slope of x^3/(x^2 + d^2) is largest at x^2 = 3 d^2: 9/8. */
static void limit(const void *self, const struct view *v, struct limit *out)
{
    const struct density_healing *s = self;

    (void)v;
    out->rate = 9. / 8 * s->rate;
    out->decay = true;
    out->where = -1; /* the same everywhere */
}

static const struct part_source source = {
    .densify = densify,
};

const struct part LANE_NAME(effects_density_healing) = {
    .name = "density-healing",
    .about = "brings the density of spray back to that at rest; with eos.tension = false only",
    .equation = "(D5) d rho_a/dt = strength c0/hs x^3/(x^2 + d^2), x = max(0, rho0 - rho_a), "
                "d = 0.1 rho0 (U/c0)^2",
    .source = "ours",
    .size = sizeof(struct density_healing),
    .params = params,
    .needs = FIELD_DENSITY | FIELD_DENSITY_RATE,
    .prepare = prepare,
    .limit = limit,
    .as.source = &source,
};
