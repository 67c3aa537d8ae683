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

static bool sources(const struct plan *p)
{
    for (int i = 0; i < p->parts; i++)
        if (p->part[i].part->as.source)
            return true;
    return false;
}

/* What it cannot go with, and what to do; NULL: nothing. */
static const char *reason(const struct plan *p)
{
    if (p->row.density[KIND_FLUID] < 0)
        return "it predicts a density that evolves: take effects.continuity";
    if (p->particles->n > particles_count(p->particles, KIND_FLUID)
        && (p->passes.press || !p->in.walls->as.wall->as_fluid || p->passes.fields > 0))
        return "it is solved for in the fluid and in solids with a density of their own: set "
               "walls = \"own-density\"";
    if (p->bodies > 0)
        return "bodies do not yield in its solve yet: leave them out, or take another eos.type";
    if (p->stiff)
        return "a viscosity that is implicit is solved for apart: set its side = \"explicit\"";
    if (sources(p))
        return "its power is that of flow alone, and density healing has pressure before density "
               "is back: leave out effects.density-healing";
    if (p->drifter)
        return "it does not predict what particle shifting changes: leave that effect out";
    if (p->kernel[PART_DENSITY] != p->kernel[PART_PRESSURE])
        return "forces must be the transpose of the rate of density: take one kernel for both";
    return NULL;
}

int plan_ahead_agree(const struct plan *p, const struct scene *scene)
{
    const char *why = plan_ahead(p) > 0 ? reason(p) : NULL;

    if (!why)
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "%s: eos.type = \"%s\": %s", scene_path(scene),
                       p->pressure->part->name, why);
}
