/* scales.c -- the constants of a scene that every part may read. */
#include "plan/inside.h"

#include "base/status.h"
#include "matter/eos.h"
#include "scene/scene.h"

#include <math.h>
#include <string.h>

static bool repeats(const struct plan *p, int d)
{
    return p->in.domain.periodic & 1u << d;
}

/* Is there a depth along d? */
static bool weighs(const struct plan *p, int d)
{
    return p->in.set.gravity[d] != 0 && !repeats(p, d);
}

/* Highest minus lowest point of all fluid along gravity [m]. */
static double fluid_height(const struct plan *p)
{
    double low[DIM], high[DIM], best = 0;

    for (int d = 0; d < DIM; d++) {
        double least = HUGE_VAL, most = -HUGE_VAL;
        for (int i = 0; i < p->in.fluids; i++) {
            shape_bounds(&p->in.fluid[i].set.shape, low, high);
            least = fmin(least, low[d]);
            most = fmax(most, high[d]);
        }
        if (weighs(p, d) && p->in.fluids > 0)
            best = fmax(best, most - least);
    }
    return best;
}

static int make_sound(struct plan *p, struct scene *scene)
{
    const double speeds = p->in.pressure->as.pressure->speeds;
    struct eos *e = p->in.pressure_self;
    double g2 = 0;

    for (int d = 0; d < DIM; d++)
        if (weighs(p, d))
            g2 += p->in.set.gravity[d] * p->in.set.gravity[d];
    if (isnan(e->c0)) {
        if (p->in.fluids > 0 && g2 == 0)
            return status_fail(STATUS_BAD_SCENE, "%s: eos.c0 is needed: without gravity (along a "
                               "direction that is not periodic) the sound speed cannot be "
                               "computed; take 10 times the largest speed that "
                               "you expect", scene_path(scene));
        e->c0 = p->in.fluids > 0 ? speeds * sqrt(2 * sqrt(g2) * fluid_height(p)) : 1;
        scene_computed(scene, "eos", "c0", e->c0);
    }
    if (isnan(p->in.reference.speed)) {
        p->in.reference.speed = e->c0 / speeds;
        scene_computed(scene, "reference", "speed", p->in.reference.speed);
    }
    return STATUS_DONE;
}

/* A particle must not meet another and its image, too, nor its own image. */
static int make_periods(struct plan *p, const struct scene *scene)
{
    const struct scene_node *domain = scene_child(scene_root(scene), "domain");
    const double least = 2 * (1 + p->in.kernel.skin) * p->scales.support;

    for (int d = 0; d < DIM; d++) {
        const double length = p->scales.high[d] - p->scales.low[d];
        p->scales.period[d] = repeats(p, d) ? length : 0;
        if (repeats(p, d) && p->scales.fluid && !(length >= least))
            return status_fail(STATUS_BAD_SCENE, "%s: domain.periodic: along %c the domain is %g m "
                               "long, but a direction that repeats needs at least %g m, 2 (kernel."
                               "support + Verlet margin), so that none meets another twice; make "
                               "it longer or the spacing smaller", scene_where(domain), "xyz"[d],
                               length, least);
    }
    return STATUS_DONE;
}

int plan_scales_make(struct plan *p, struct scene *scene)
{
    const struct eos *e = p->in.pressure_self;
    struct scales *s = &p->scales;

    TRY(make_sound(p, scene));
    s->dimension = DIM;
    s->fluid = p->in.fluids > 0;
    s->dx = p->in.set.spacing;
    if (isnan(s->dx))
        s->dx = 1; /* no particles: a beam alone */
    s->support = p->in.kernel.support * s->dx;
    s->hs = s->support / 2;
    s->rho0 = e->rho0;
    s->c0 = e->c0;
    s->gamma = e->gamma;
    s->clamped = e->clamped;
    s->mass = p->in.set.particle_mass;
    if (isnan(s->mass)) {
        s->mass = s->rho0 * pow(s->dx, DIM);
        if (s->fluid)
            scene_computed(scene, "", "particle_mass", s->mass);
    }
    s->speed = p->in.reference.speed;
    memcpy(s->g, p->in.set.gravity, sizeof s->g);
    for (int d = 0; d < DIM; d++) { /* a beam alone needs no domain */
        s->low[d] = isnan(p->in.domain.from[d]) ? 0 : p->in.domain.from[d];
        s->high[d] = isnan(p->in.domain.to[d]) ? 0 : p->in.domain.to[d];
    }
    return make_periods(p, scene);
}

/* By (E1) a density off by rho0 (U/c0)^2 makes a pressure of rho0 U^2.  By (E3) one that is off
 * with the wave number k = 1/hs, as errors of particles are, makes 1 + (c0 tau k)^2 times
 * less: the pressure also meets the motion that it would cause. */
void plan_scales_density(struct plan *p)
{
    struct scales *s = &p->scales;
    const double mach = s->speed / s->c0, reach = plan_ahead(p) * s->speed / s->hs;

    s->density = s->rho0 * mach * mach + s->rho0 * reach * reach;
}
