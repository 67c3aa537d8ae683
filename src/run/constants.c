/* constants.c -- the numbers that every plot of a run begins with. */
#include "run/inside.h"

#include "output/figures.h"
#include "plan/input.h"
#include "run/looks.h"

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

static bool is_inside(const struct scales *s, const double *x)
{
    for (int d = 0; d < DIM; d++)
        if (!(x[d] > s->low[d] && x[d] < s->high[d]))
            return false;
    return true;
}

/* Left face of the first solid within the domain at the start, a beam or a wall [m], NAN without
 * any. */
static double first_solid(const struct particles *all)
{
    double low = HUGE_VAL;

    for (int i = 0; i < all->n; i++)
        if (all->object[all->object_of[i]].kind != KIND_FLUID && is_inside(all->scales, all->x0[i]))
            low = fmin(low, all->x0[i][0] - all->scales->dx / 2);
    return low < HUGE_VAL ? low : NAN;
}

/* Is the fluid a block in the low corner of the domain, as wide as that across, under gravity along
 * the last axis?  As a dam break that experiments can be held against. */
static bool is_column(const struct particles *all)
{
    const struct scales *s = all->scales;
    const int n = particles_count(all, KIND_FLUID);
    double low[DIM], volume = 1;

    for (int d = 0; d < DIM; d++) {
        const double wide = extent(all, d);
        low[d] = HUGE_VAL;
        for (int i = 0; i < n; i++)
            low[d] = fmin(low[d], all->x0[i][d]);
        if (!(fabs(low[d] - s->low[d] - s->dx / 2) < s->dx / 4)
            || (d > 0 && d < DIM - 1 && wide < s->high[d] - s->low[d] - s->dx / 2)
            || (d < DIM - 1 && s->g[d] != 0))
            return false;
        volume *= wide;
    }
    return s->g[DIM - 1] < 0 && n * pow(s->dx, DIM) > 0.99 * volume;
}

struct beams {
    char names[INPUT_BODIES * 65], sections[INPUT_BODIES * 25], rigid[INPUT_BODIES * 65],
         masses[INPUT_BODIES * 25];
};

/* Names of all, masses of the rigid, and sections of the beams, as they are in the last state. */
static void list_beams(const struct run *r, struct beams *to)
{
    size_t n = 0, m = 0, k = 0, l = 0;

    for (int i = 0; i < plan_bodies(r->plan); i++) {
        struct body_view view;
        if (plan_body_rigid(r->plan, i)) {
            k += (size_t)snprintf(to->rigid + k, sizeof to->rigid - k, " %s",
                                  plan_body_name(r->plan, i));
            l += (size_t)snprintf(to->masses + l, sizeof to->masses - l, " %.17g",
                                  plan_body_mass(r->plan, i));
            continue;
        }
        observe_body(r->moment, i, r->past.tally.t, r->method->state(r->self), &view);
        n += (size_t)snprintf(to->names + n, sizeof to->names - n, " %s",
                              plan_body_name(r->plan, i));
        m += (size_t)snprintf(to->sections + m, sizeof to->sections - m, " %.17g", view.section);
    }
}

int run_constants(const struct run *r)
{
    struct beams beams = { .names = "", .rigid = "", .masses = "" };
    const struct particles *all = plan_particles(r->plan);
    const struct scales *s = plan_scales(r->plan);
    struct figures_constants c = {
        .title = plan_settings(r->plan)->title, .dim = DIM,
        .a = extent(all, 0), .n2 = extent(all, DIM - 1) / extent(all, 0),
        .g = sqrt(s->g[0] * s->g[0] + s->g[1] * s->g[1] + s->g[2] * s->g[2]),
        .until = r->until, .beam_x = first_solid(all), .column = is_column(all),
        .rings = plan_hydrostatic(r->plan), .moves = plan_walls_move(r->plan),
        .dx = looks_grain(r->plan), .rho0 = s->rho0, .c0 = s->c0,
        .E0 = outputs_energy_initial(r->outputs), .beams = beams.names,
        .sections = beams.sections, .bodies = beams.rigid, .masses = beams.masses,
    };

    list_beams(r, &beams);
    memcpy(c.low, s->low, sizeof c.low);
    memcpy(c.high, s->high, sizeof c.high);
    return figures_constants(r->directory, &c);
}
