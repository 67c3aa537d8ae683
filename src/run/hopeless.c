/* hopeless.c -- scenes that can be run and lead nowhere: water without a floor, probes inside
 * solids, water as fast as its sound. */
#include "run/inside.h"

#include "base/status.h"
#include "shapes/buckets.h"
#include "scene/scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double near = 1.1;      /* particles around a point in a solid [dx] */
static const double fast_mach = 0.3; /* density varies by a tenth                */

/* How far x lies along gravity [m]. */
static double depth(const struct scales *s, const double *x)
{
    double sum = 0;

    for (int d = 0; d < DIM; d++)
        sum += s->g[d] * x[d];
    return sum;
}

/* Does it repeat along gravity?  Then it falls for ever, or stays, by design. */
static bool falls_round(const struct scales *s)
{
    for (int d = 0; d < DIM; d++)
        if (s->period[d] > 0 && s->g[d] != 0)
            return true;
    return false;
}

static void doubt_floor(const struct run *r)
{
    const struct particles *p = plan_particles(r->plan);
    const struct scales *s = plan_scales(r->plan);
    double fluid = -HUGE_VAL, solid = -HUGE_VAL;

    for (int i = 0; i < p->n; i++) {
        const bool is_fluid = p->object[p->object_of[i]].kind == KIND_FLUID;
        double *most = is_fluid ? &fluid : &solid;
        *most = fmax(*most, depth(s, p->x0[i]));
    }
    if (fluid > solid && depth(s, s->g) > 0 && !falls_round(s))
        status_warn("%s: no wall lies below the lowest fluid, which will fall out of the domain: "
                    "is there a wall missing, or a side of a frame in `open`?",
                    scene_path(r->scene));
}

/* The last axis is the one that points up: levels, fronts and pictures go by it. */
static void doubt_up(const struct run *r)
{
    const struct scales *s = plan_scales(r->plan);
    const char up = "xyz"[DIM - 1];

    if (s->g[DIM - 1] > 0 && s->period[DIM - 1] == 0)
        status_warn("%s: gravity points up, along %c: is a minus missing?", scene_path(r->scene), up);
    else if (DIM == 3 && s->g[2] == 0 && s->g[1] != 0 && s->period[1] == 0)
        status_warn("%s: gravity is along y, and in 3D %c points up: gravity = [0, 0, %g]?",
                    scene_path(r->scene), up, s->g[1]);
}

/* Half a spacing is less than a lattice tells. */
static void doubt_rim(const struct run *r)
{
    double rim;
    const char *name = plan_rim(r->plan, &rim);
    const double reach = plan_reach(r->plan);
    char how[80];

    if (!name || !(reach > rim + 0.5 * plan_scales(r->plan)->dx))
        return;
    if (reach < HUGE_VAL)
        snprintf(how, sizeof how, "up to %.3g m", reach);
    else
        snprintf(how, sizeof how, "anywhere, as no gravity holds it");
    status_warn("%s: water may spill: it can rise %s, and the sides of wall.%s end at rim = %g m; what "
                "goes over them leaves the domain and is lost", scene_path(r->scene), how, name, rim);
}

static void doubt_mach(const struct run *r)
{
    const double c0 = plan_scales(r->plan)->c0, speed = plan_speed_expected(r->plan);

    if (speed > fast_mach * c0)
        status_warn("%s: Mach %.2g: speeds of %.3g m/s are to be expected and sound has %.3g m/s, so "
                    "density will vary by %.0f %%: take eos.c0 = %.2g or more",
                    scene_path(r->scene), speed / c0, speed, c0, 100 * pow(speed / c0, 2),
                    10 * speed);
}

/* Solid particles in one orthant around a point: bit d of `side` is set: above it along d. */
struct orthant {
    const struct particles *p;
    const double *x;
    double slack;
    int side;
};

static bool is_there(const void *self, int j)
{
    const struct orthant *o = self;

    if (o->p->object[o->p->object_of[j]].kind == KIND_FLUID)
        return false;
    for (int d = 0; d < DIM; d++) {
        const double way = o->p->x0[j][d] - o->x[d];
        if ((o->side >> d & 1 ? way : -way) < -o->slack)
            return false;
    }
    return true;
}

/* On a face of a solid there are none on the side of the water. */
static bool is_in_solid(const struct run *r, const struct buckets *b, const double *x)
{
    const double dx = plan_scales(r->plan)->dx;
    struct orthant o = { plan_particles(r->plan), x, 1e-6 * dx, 0 };

    for (; o.side < 1 << DIM; o.side++)
        if (buckets_find(b, x, near * dx, is_there, &o) < 0)
            return false;
    return true;
}

static void doubt_probe(const struct run *r, const struct buckets *b, int i)
{
    const char *name;
    const struct settings_probe *probe = plan_probe(r->plan, i, &name);

    if (strcmp(probe->what, "height") == 0 || !isnan(probe->to[0]) || !isnan(probe->radius)
        || !is_in_solid(r, b, probe->at))
        return;
    status_warn("%s: probe.%s stands inside a solid, where there is no water at the start: it will "
                "read 0 there; put it on the face of the solid or before it",
                scene_path(r->scene), name);
}

static int doubt_probes(const struct run *r)
{
    const struct particles *p = plan_particles(r->plan);
    struct buckets b;

    if (plan_probes(r->plan) == 0)
        return STATUS_DONE;
    TRY(buckets_create(&b, (const double (*)[DIM])p->x0, p->n, near * p->scales->dx));
    for (int i = 0; i < plan_probes(r->plan); i++)
        doubt_probe(r, &b, i);
    buckets_free(&b);
    return STATUS_DONE;
}

int run_doubt_hopes(const struct run *r)
{
    doubt_floor(r);
    doubt_up(r);
    doubt_rim(r);
    doubt_mach(r);
    return doubt_probes(r);
}
