/* look-ahead.c -- a linear pressure, (E1), of the density that the momentum balance, the
 * pressure's own force included, predicts for a time tau from now:
 *
 *   p = c0^2 (rho + tau rho' + tau^2 rho'' - rho0)                             (E3)
 *
 * which is a linear system, implicit/ahead.h.  tau is a constant, never the step: p is a
 * function of (t, y).  Without tension p >= 0 and that is the complementarity problem
 *
 *   p >= 0,  p >= c0^2 (...),  p = c0^2 (...) where p > 0
 *
 * for a pressure that is cut after the solve makes water collapse.
 *
 * Sound of wave number k has rates s with s^2 + (tau s + 1) w^2/(1 + tau^2 w^2) = 0, w = c0 k:
 * none is faster than 1/tau, none grows. */
#include "pressure/liquid.h"

#include "base/status.h"

#include <math.h>

struct look_ahead {
    struct liquid liquid;
    double tau;      /* [dx/U]                                                */
    double residual; /* of the solve [1]                                      */
    double time;     /* tau [s]                                               */
};

static const struct param params[] = {
    { .key = "rho0", .unit = "kg/m^3", .offset = offsetof(struct look_ahead, liquid.eos.rho0),
      .fallback = 1000, .min = 1e-3, .max = 1e5, .about = "density at rest" },
    { .key = "c0", .unit = "m/s", .offset = offsetof(struct look_ahead, liquid.eos.c0),
      .fallback = NAN, .min = 1e-6, .max = 1e5,
      .about = "sound speed; computed: 30 sqrt(2 g H), H the height of the fluid at the start" },
    { .key = "tau", .unit = "1", .offset = offsetof(struct look_ahead, tau),
      .fallback = 0.5, .min = 0, .max = 10,
      .about = "time that the pressure looks ahead, in dx/U, U the reference speed; 0: that of "
               "the density alone" },
    { .key = "residual", .unit = "1", .offset = offsetof(struct look_ahead, residual),
      .fallback = 0.01, .min = 1e-14, .max = 0.1,
      .about = "residual of the pressure's solve, as a share of what drives it; not above tol" },
    LIQUID_TENSION,
    { 0 },
};

static int complete(void *self)
{
    struct look_ahead *l = self;

    l->liquid.eos.gamma = 1;
    l->liquid.eos.clamped = !l->liquid.tension;
    return STATUS_DONE;
}

static int prepare(void *self, const struct scales *s)
{
    struct look_ahead *l = self;

    l->time = l->tau * s->dx / s->speed;
    return liquid_prepare(self, s);
}

static double ahead(const void *self, double *residual)
{
    const struct look_ahead *l = self;

    *residual = l->residual;
    return l->time;
}

static void pressures(const void *self, int n, const double *rho, double *p)
{
    liquid_pressure.pressures(self, n, rho, p);
}

static void moduli(const void *self, int n, const double *rho, const double *p, double *modulus)
{
    liquid_pressure.moduli(self, n, rho, p, modulus);
}

/* Sound up to 1/tau, and the flow. */
static void limit(const void *self, const struct view *v, struct limit *out)
{
    const struct look_ahead *l = self;
    const double sound = l->liquid.reach * l->liquid.eos.c0;

    liquid_limit(self, v, out);
    if (l->time > 0 && out->rate > 0 && sound * l->time > 1)
        out->rate += 1 / l->time - sound;
}

static const struct part_pressure pressure = { .pressures = pressures, .moduli = moduli,
                                               .ahead = ahead, .speeds = 30 };

const struct part pressure_look_ahead = {
    .name = "look-ahead",
    .about = "pressure of the density that the momentum balance predicts, solved for",
    .equation = "(E3) p = c0^2 (rho + tau rho' + tau^2 rho'' - rho0), rho'' with p's own force",
    .source = "(E1) with a prediction; Baumgarte, Comput. Methods Appl. Mech. Eng. 1 (1972) 1-16 "
              "in the limit of a large c0",
    .size = sizeof(struct look_ahead),
    .params = params,
    .needs = FIELD_DENSITY,
    .provides = FIELD_PRESSURE,
    .complete = complete,
    .prepare = prepare,
    .limit = limit,
    .energy = liquid_energy,
    .as.pressure = &pressure,
};
