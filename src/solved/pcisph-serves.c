/* pcisph-serves.c -- which plans have a pressure that prediction and correction find. */
#include "solved/pcisph-inside.h"

#include <string.h>

static bool reads_pressure(const struct part *part)
{
    return part->as.law && (part->needs & FIELD_PRESSURE);
}

static bool is_force(const struct plan_part *one)
{
    return strcmp(one->path, "effects.pressure") == 0;
}

static const char *laws(const struct plan *p)
{
    bool force = false;

    for (int i = 0; i < p->parts; i++) {
        if (reads_pressure(p->part[i].part) && !is_force(&p->part[i]))
            return "an effect beside effects.pressure reads the pressure, which the iteration "
                   "does not know of; leave it out (artificial-stress, pressure-printed)";
        force |= is_force(&p->part[i]);
    }
    if (p->table.mixed)
        return "an effect changes densities and velocities in one; leave it out";
    return force ? NULL : "it solves for a pressure; name effects.pressure = { }";
}

const char *pcisph_serves(const struct plan *p)
{
    if (particles_count(p->particles, KIND_FLUID) == 0)
        return "there is no fluid whose pressure it could solve for";
    for (int k = 0; k < KINDS; k++)
        if (particles_count(p->particles, k) > 0 && p->row.density[k] < 0)
            return "it keeps pressures as densities of fluid and solids; name "
                   "effects.continuity = { } and walls = \"own-density\"";
    if (p->passes.filters)
        return "it keeps pressures as densities, which effects.shepard-filter would mix; leave that "
               "effect out";
    if (p->passes.press || p->in.walls->as.wall->only)
        return "solids need a pressure of their own; set walls = \"own-density\"";
    if (p->kernel[PART_DENSITY] != p->kernel[PART_PRESSURE]
        && strcmp(p->in.pcisph.delta, "toth") != 0)
        return "the kernels of density and pressure differ, so that no delta is right for both: "
               "the iteration corrects too much and diverges; give kernel.density and "
               "kernel.pressure the same one, or ask for the mix of Toth (2012) by "
               "pcisph.delta = \"toth\"";
    return laws(p);
}
