/* ahead.c -- what a pressure that looks ahead goes with. */
#include "plan/inside.h"

#include "base/status.h"
#include "scene/scene.h"

double plan_ahead(const struct plan *p)
{
    double residual;

    if (!p->pressure || !p->pressure->part->as.pressure->ahead
        || particles_count(p->particles, KIND_FLUID) == 0)
        return 0;
    return p->pressure->part->as.pressure->ahead(p->pressure->self, &residual);
}

static bool bodies_yield(const struct plan *p)
{
    for (int i = 0; i < p->bodies; i++)
        if (!p->body[i].kind->role.ahead)
            return false;
    return true;
}

/* Do solids say what their pressure is one of: a density of their own, or means of these? */
static bool walls_predict(const struct plan *p)
{
    const struct part_wall *wall = p->in.walls->as.wall;

    return wall->as_fluid && !wall->only && p->passes.fields == 0
           && (!wall->press || wall->press->mean);
}

/* Is there a beam that its mass alone moves? */
static bool own_way(const struct plan *p)
{
    for (int i = 0; i < p->bodies; i++)
        if (p->body[i].skin > 0 && !p->body[i].kind->role.ahead->moves)
            return true;
    return false;
}

/* What it cannot go with, and what to do; NULL: nothing.  Measured: between walls that press one way
 * a beam that moves by its mass alone chatters (doc/pressure.md). */
static const char *reason(const struct plan *p)
{
    if (p->row.density[KIND_FLUID] < 0)
        return "it predicts a density that evolves: take effects.continuity";
    if (p->particles->n > particles_count(p->particles, KIND_FLUID)
        && !walls_predict(p))
        return "it is solved for in the fluid and in solids with a density of their own: set "
               "walls = \"contact\" or \"own-density\"";
    if (!bodies_yield(p))
        return "one of the bodies does not say how it yields to pressure within a time: leave it "
               "out, or take another eos.type";
    if (p->passes.press && own_way(p))
        return "a beam that its mass alone moves chatters between such walls: set its response = "
               "\"predicted\", or walls = \"own-density\"";
    if (p->stiff)
        return "a viscosity that is implicit is solved for apart: set its side = \"explicit\"";
    if (p->passes.filters)
        return "it holds the energy of a density and a pressure, not of a filtered density: leave "
               "effects.shepard-filter out";
    if (p->drifter)
        return "it does not predict what particle shifting changes: leave that effect out";
    if (p->kernel[PART_DENSITY] != p->kernel[PART_PRESSURE])
        return "forces must be the transpose of the rate of density: take one kernel for both";
    return NULL;
}

/* Measured: a plate of a thirtieth of the water that its skin displaces takes 3.6 times the
 * right-hand sides by M alone, one of an eight-hundredth none that is short enough. */
static void doubt_light(const struct plan *p, const struct scene *scene)
{
    const double light = 1.0 / 20;

    for (int i = 0; i < p->bodies; i++) {
        const struct plan_body *b = &p->body[i];
        const double weight = b->kind->weight(b->body);
        double displaced = 0;
        for (int j = 0; j < b->skin; j++)
            displaced += p->particles->m[p->particles->object[b->object].from + j];
        if (b->kind->implicit && weight < light * displaced)
            status_warn("%s: %s weighs %g kg/m and its skin displaces %g kg/m of water: moved by its "
                        "mass alone it makes steps short, or finds none at last; set its response "
                        "= \"predicted\", or a smaller eos.tau", scene_path(scene),
                        b->path, weight, displaced);
    }
}

/* Sound takes no shorter steps than 1/tau then, and the solve buys nothing. */
static void doubt_short(const struct plan *p, const struct scene *scene)
{
    const struct scales *s = &p->scales;
    const double least = s->hs / (SCALES_WAVE * s->wave * s->c0);

    if (plan_ahead(p) < least)
        status_warn("%s: eos.tau = %g dx/U looks ahead by less than sound needs for a particle: sound "
                    "still bounds the steps, and each has a solve; take eos.tau above %g, or "
                    "eos.type = \"linear\"", scene_path(scene), plan_ahead(p) * s->speed / s->dx,
                    least * s->speed / s->dx);
}

/* A body that moves as this pressure predicts, under another. */
static int refuse_moved(const struct plan *p, const struct scene *scene)
{
    for (int i = 0; i < p->bodies; i++)
        if (p->body[i].kind->role.ahead && p->body[i].kind->role.ahead->moves)
            return status_fail(STATUS_BAD_SCENE, "%s: %s moves as a pressure that looks ahead takes it "
                               "to, and there is none: set eos.type = \"look-ahead\" with eos.tau "
                               "above 0, or leave its response out", scene_path(scene),
                               p->body[i].path);
    return STATUS_DONE;
}

int plan_ahead_agree(const struct plan *p, const struct scene *scene)
{
    const char *why = plan_ahead(p) > 0 ? reason(p) : NULL;

    if (plan_ahead(p) == 0)
        return refuse_moved(p, scene);
    if (!why) {
        doubt_light(p, scene);
        doubt_short(p, scene);
        return STATUS_DONE;
    }
    return status_fail(STATUS_BAD_SCENE, "%s: eos.type = \"%s\": %s", scene_path(scene),
                       p->pressure->part->name, why);
}
