/* tait.c -- pressure from density by Tait's equation (E2), the seed's (20).
 * No clamp: tension stays, or the density of spray would drift.  Holds the
 * fluid's internal energy and its fastest waves. */
#include "pressure/pressure.h"

#include <math.h>

struct tait {
    struct eos eos;
    double hs; /* half the support [m] */
};

static const struct param params[] = {
    { .key = "rho0", .unit = "kg/m^3", .offset = offsetof(struct tait, eos.rho0),
      .fallback = 1000, .min = 1e-3, .max = 1e5, .about = "density at rest" },
    { .key = "c0", .unit = "m/s", .offset = offsetof(struct tait, eos.c0),
      .fallback = NAN, .min = 1e-6, .max = 1e5,
      .about = "sound speed; computed: 10 sqrt(2 g H), H the height of the fluid at the start" },
    { .key = "gamma", .unit = "1", .offset = offsetof(struct tait, eos.gamma),
      .fallback = 7, .min = 1, .max = 20, .about = "exponent; 7 is water" },
    { 0 },
};

static int prepare(void *self, const struct scales *s)
{
    struct tait *t = self;

    t->hs = s->hs;
    return 0;
}

static void pressures(const void *self, int n, const double *rho, double *p)
{
    const struct tait *t = self;

    eos_pressures(&t->eos, n, rho, p);
}

/* Sound and flow together: the fastest particle carries the fastest wave. */
static void limit(const void *self, const struct view *v, struct limit *out)
{
    const struct tait *t = self;
    const int n = particles_count(v->p, KIND_FLUID);
    const double *u = v->u[KIND_FLUID];
    double most = -1;

    for (int i = 0; i < n; i++) {
        double u2 = 0;
        for (int d = 0; d < DIM; d++)
            u2 += u[i * DIM + d] * u[i * DIM + d];
        if (u2 > most) {
            most = u2;
            out->where = i;
        }
    }
    if (most >= 0)
        out->rate = SCALES_WAVE * (t->eos.c0 + sqrt(most)) / t->hs;
}

static void energy(const void *self, const struct view *v, struct energies *to)
{
    const struct tait *t = self;
    double sum = 0;

    for (int k = 0; k < KINDS; k++) {
        const int n = v->rho[k] ? particles_count(v->p, k) : 0;
        for (int i = 0; i < n; i++)
            sum += v->p->m[v->p->from[k] + i] * eos_energy(&t->eos, v->rho[k][i]);
    }
    to->internal += sum;
}

const struct part pressure_tait = {
    .name = "tait",
    .about = "pressure of a slightly compressible liquid",
    .equation = "(E2) p = rho0 c0^2/gamma ((rho/rho0)^gamma - 1)",
    .source = "Monaghan, J. Comput. Phys. 110 (1994) 399-406; Toth 2012, (20)",
    .size = sizeof(struct tait),
    .params = params,
    .needs = FIELD_DENSITY,
    .provides = FIELD_PRESSURE,
    .prepare = prepare,
    .pressure = pressures,
    .limit = limit,
    .energy = energy,
};
