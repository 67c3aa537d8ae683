/* liquid.c -- pressures, energy and waves of a liquid with an equation of state. */
#include "pressure/liquid.h"

#include "base/threads.h"
#include "base/waiting.h"

#include <math.h>

int liquid_prepare(void *self, const struct scales *s)
{
    struct liquid *l = self;

    l->reach = SCALES_WAVE * s->wave / s->hs;
    return 0;
}

static void pressures(const void *self, int n, const double *rho, double *p)
{
    const struct liquid *l = self;

    eos_pressures(&l->eos, n, rho, p);
}

static void moduli(const void *self, int n, const double *rho, const double *p, double *modulus)
{
    const struct liquid *l = self;

    (void)rho; /* p says as much */
    eos_moduli(&l->eos, n, p, modulus);
}

const struct part_pressure liquid_pressure = { .pressures = pressures, .moduli = moduli,
                                              .speeds = 10 };

/* The fastest particle: of several, that with the smallest id. */
struct fastest {
    double speed; /* [m/s], -1: there is none */
    int id;
};

/* Row i, where sound has the speed c, against the fastest so far. */
static inline void take(const struct view *v, int i, double c, double u2, struct fastest *most)
{
    const int *id = v->p->id[KIND_FLUID];
    const double speed = c + sqrt(u2);

    if (speed > most->speed || (speed == most->speed && id && id[i] < most->id))
        *most = (struct fastest){ speed, id ? id[i] : i };
}

/* Of rows from..to-1.  Few need a root: all others are slower by more than roundings. */
static struct fastest find_fastest(const struct liquid *l, const struct view *v, int from, int to)
{
    enum { BLOCK = 256 };
    const double *u = v->u[KIND_FLUID];
    struct fastest most = { -1, -1 };
    double c[BLOCK];

    for (int at = from; at < to; at += BLOCK) {
        const int n = to - at < BLOCK ? to - at : BLOCK;

        eos_sounds(&l->eos, n, v->rho[KIND_FLUID] + at, c);
        for (int k = 0; k < n; k++) {
            const double need = most.speed * (1 - 1e-12) - c[k];
            double u2 = 0;

            for (int d = 0; d < DIM; d++)
                u2 += u[(at + k) * DIM + d] * u[(at + k) * DIM + d];
            if (need <= 0 || u2 >= need * need)
                take(v, at + k, c[k], u2, &most);
        }
    }
    return most;
}

static void keep_faster(struct fastest *all, const struct fastest *mine)
{
    if (mine->speed > all->speed || (mine->speed == all->speed && mine->id < all->id))
        *all = *mine;
}

/* Of this thread's rows. */
static void find_part(const struct liquid *l, const struct view *v, int n, struct fastest *all)
{
    const struct threads_part part = threads_part(n);
    const struct fastest mine = find_fastest(l, v, part.from, part.to);

    THREADS_IN_TURN(keep_faster(all, &mine));
}

/* Sound and flow together, sound where it is: it is faster in what is pressed. */
void liquid_limit(const void *self, const struct view *v, struct limit *out)
{
    const struct liquid *l = self;
    const int n = particles_count(v->p, KIND_FLUID) - v->others;
    struct fastest most = { -1, -1 };

    THREADS(waiting_repays(n), find_part(l, v, n, &most));
    if (most.speed < 0)
        return;
    out->where = most.id;
    out->found = most.speed;
    out->rate = l->reach * most.speed;
}

void liquid_energy(const void *self, const struct view *v, struct energy_sums *to)
{
    const struct liquid *l = self;
    struct exact_terms terms = { .to = &to->internal };

    for (int k = 0; k < KINDS; k++) {
        const int from = v->p->from[k];
        const int n = v->rho[k] && v->stores[k] ? particles_count(v->p, k) : 0;
        for (int i = 0; i < n; i++)
            if (view_has(v, from + i))
                exact_terms_add(&terms, v->p->m[from + i] * eos_energy(&l->eos, v->rho[k][i]));
    }
    exact_terms_end(&terms);
}
