/* mps-length.c -- how long a step of MPS may be. */
#include "solved/mps-inside.h"

#include <math.h>
#include <stdio.h>

/* The largest speed of fluid in the domain, and whose; the reference speed when that is more.
 * What has left falls for ever, alone. */
static double fastest(const struct mps *s, const double *y, struct limit *limit)
{
    const struct moment *m = s->moment;
    const double *u = y + layout_at(&m->layout, m->plan->row.u);
    const double *x = y + layout_at(&m->layout, m->plan->row.x);
    double most = m->plan->scales.speed;

    *limit = (struct limit){ .where = -1, .part = "mps, reference speed" };
    for (int id = 0; id < particles_count(m->particles, KIND_FLUID); id++) {
        const size_t at = (size_t)particles_row(m->particles, KIND_FLUID, id) * DIM;
        double square = 0;
        for (size_t d = 0; d < DIM; d++)
            square += u[at + d] * u[at + d];
        if (sqrt(square) > most && list_inside(&m->plan->list_def, x + at)) {
            most = sqrt(square);
            *limit = (struct limit){ .where = id, .part = "mps, speed" };
        }
    }
    return most;
}

/* Laws of the scene that decay and are taken explicitly: rate times step is at most 1/2. */
static double shortened(const struct mps *s, double t, const double *y, double h,
                        struct limit *limit)
{
    const struct plan *p = s->moment->plan;
    struct view v;

    moment_view(s->moment, t, y, &v);
    for (int i = 0; i < p->parts; i++) {
        struct limit one = { .where = -1 };
        if (!p->part[i].part->limit || mps_density_law(p->part[i].part))
            continue;
        p->part[i].part->limit(p->part[i].self, &v, &one);
        if (one.decay && one.rate * h > 0.5) {
            h = 0.5 / one.rate;
            *limit = one;
            snprintf(limit->part, sizeof limit->part, "%s", p->part[i].part->name);
        }
    }
    return h;
}

/* number l0/U; the Laplacian of (M3): nu dt 2 D/lambda <= 1/2.  The bound of a first step in
 * published codes, sqrt(2 C l0/g), kicks still water (doc/pressure.md). */
double mps_length(const struct mps *s, double number, double t, const double *y,
                  struct limit *limit)
{
    double h = number * s->moment->plan->scales.dx / fastest(s, y, limit);

    if (s->key->nu > 0 && s->laplacian.lambda / (4 * DIM * s->key->nu) < h) {
        h = s->laplacian.lambda / (4 * DIM * s->key->nu);
        *limit = (struct limit){ .where = -1, .part = "mps.nu" };
    }
    return shortened(s, t, y, h, limit);
}
