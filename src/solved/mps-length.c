/* mps-length.c -- how long a step of MPS may be. */
#include "solved/largest.h"
#include "solved/mps-inside.h"

#include <math.h>
#include <stdio.h>

/* The fastest fluid, or the reference speed when that is more. */
static double fastest(const struct mps *s, const double *y, struct limit *limit)
{
    const double least = s->moment->plan->scales.speed;
    int where = -1;
    const double most = largest_inside(s->moment, y, y, &where);

    *limit = (struct limit){ .where = -1, .part = "mps, reference speed" };
    if (most > least)
        *limit = (struct limit){ .where = where, .part = "mps, speed" };
    return fmax(most, least);
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
