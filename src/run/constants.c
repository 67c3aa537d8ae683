/* constants.c -- the numbers that every plot of a run begins with. */
#include "run/inside.h"

#include "output/figures.h"

#include <math.h>
#include <string.h>

/* Extent of the fluid at the start along one axis [m], NAN without fluid. */
static double extent(const struct particles *all, int axis)
{
    double low = HUGE_VAL, high = -HUGE_VAL;

    for (int i = 0; i < particles_count(all, KIND_FLUID); i++) {
        low = fmin(low, all->x0[i][axis]);
        high = fmax(high, all->x0[i][axis]);
    }
    return high >= low ? high - low + all->scales->dx : NAN;
}

/* Left face of the first skin at the start [m], NAN without any. */
static double first_skin(const struct particles *all)
{
    double low = HUGE_VAL;

    for (int i = all->from[KIND_SKIN]; i < all->from[KIND_SKIN_SLIP + 1]; i++)
        low = fmin(low, all->x0[i][0] - all->scales->dx / 2);
    return low < HUGE_VAL ? low : NAN;
}

int run_constants(const struct run *r)
{
    const struct particles *all = plan_particles(r->plan);
    const struct scales *s = plan_scales(r->plan);
    struct figures_constants c = {
        .title = plan_settings(r->plan)->title, .dim = DIM,
        .a = extent(all, 0), .n2 = extent(all, DIM - 1) / extent(all, 0),
        .g = sqrt(s->g[0] * s->g[0] + s->g[1] * s->g[1] + s->g[2] * s->g[2]),
        .until = r->until, .beam_x = first_skin(all), .dx = s->dx, .rho0 = s->rho0, .c0 = s->c0,
        .E0 = outputs_energy_initial(r->outputs),
    };

    memcpy(c.low, s->low, sizeof c.low);
    memcpy(c.high, s->high, sizeof c.high);
    return figures_constants(r->directory, &c);
}
