/* constants.c -- the numbers that every plot of a run begins with. */
#include "run/inside.h"

#include "output/figures.h"
#include "plan/input.h"

#include <math.h>
#include <stdio.h>
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

struct beams {
    char names[INPUT_BODIES * 65], sections[INPUT_BODIES * 25];
};

/* Names and sections of the beams, as they are in the last state. */
static void list_beams(const struct run *r, struct beams *to)
{
    size_t n = 0, m = 0;

    for (int i = 0; i < plan_bodies(r->plan); i++) {
        struct body_view view;
        if (plan_body_rigid(r->plan, i))
            continue;
        observe_body(r->moment, i, r->past.tally.t, r->method->state(r->self), &view);
        n += (size_t)snprintf(to->names + n, sizeof to->names - n, " %s",
                              plan_body_name(r->plan, i));
        m += (size_t)snprintf(to->sections + m, sizeof to->sections - m, " %.17g", view.section);
    }
}

int run_constants(const struct run *r)
{
    struct beams beams = { .names = "" };
    const struct particles *all = plan_particles(r->plan);
    const struct scales *s = plan_scales(r->plan);
    struct figures_constants c = {
        .title = plan_settings(r->plan)->title, .dim = DIM,
        .a = extent(all, 0), .n2 = extent(all, DIM - 1) / extent(all, 0),
        .g = sqrt(s->g[0] * s->g[0] + s->g[1] * s->g[1] + s->g[2] * s->g[2]),
        .until = r->until, .beam_x = first_skin(all), .dx = s->dx, .rho0 = s->rho0, .c0 = s->c0,
        .E0 = outputs_energy_initial(r->outputs), .beams = beams.names,
        .sections = beams.sections,
    };

    list_beams(r, &beams);
    memcpy(c.low, s->low, sizeof c.low);
    memcpy(c.high, s->high, sizeof c.high);
    return figures_constants(r->directory, &c);
}
