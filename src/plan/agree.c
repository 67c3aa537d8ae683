/* agree.c -- do the parts of a scene go together: needs, kernels, walls. */
#include "plan/inside.h"

#include "base/status.h"
#include "plan/kernels.h"
#include "scene/scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct plan_part *find_effect(const struct plan *p, const char *name)
{
    for (int i = 0; i < p->parts; i++)
        if (strncmp(p->part[i].path, "effects.", 8) == 0
            && strcmp(p->part[i].part->name, name) == 0)
            return &p->part[i];
    return NULL;
}

/* What one part cannot go with: another that does the same, a kernel. */
static int check_part(const struct plan *p, const struct scene *scene, const struct plan_part *one)
{
    const char *kernel, *why = kernels_forbid(p->kernel, one->part, &kernel);

    if (one->part->instead && find_effect(p, one->part->instead))
        return status_fail(STATUS_BAD_SCENE, "%s: %s stands for effects.%s, which the scene names "
                           "too; leave one of them out", scene_path(scene), one->path,
                           one->part->instead);
    if (why)
        return status_fail(STATUS_BAD_SCENE, "%s: %s with the kernel \"%s\": it %s",
                           scene_path(scene), one->path, kernel, why);
    return STATUS_DONE;
}

static bool repeats(const struct plan *p)
{
    for (int d = 0; d < DIM; d++)
        if (p->scales.period[d] > 0)
            return true;
    return false;
}

/* A drift across other body forces than the weight is energy that is not booked. */
static int check_drift(const struct plan *p, const struct scene *scene)
{
    const struct plan_part *drift = NULL, *pull = NULL;

    for (int i = 0; i < p->parts; i++) {
        const struct part *part = p->part[i].part;
        if (part_drifts(part) && drift)
            return status_fail(STATUS_BAD_SCENE, "%s: %s and %s both move particles beside their "
                               "velocity; leave one of them out", scene_path(scene), drift->path,
                               p->part[i].path);
        if (part_drifts(part))
            drift = &p->part[i];
        if (part->as.force && !part->as.force->weight)
            pull = &p->part[i];
    }
    if (drift && pull)
        return status_fail(STATUS_BAD_SCENE, "%s: %s does not go with %s, whose work on the drift "
                           "would be in no book; leave one of them out", scene_path(scene),
                           drift->path, pull->path);
    return STATUS_DONE;
}

/* Every field that a part needs, some part must provide. */
static int check_needs(const struct plan *p, const struct scene *scene)
{
    unsigned provided = 0;

    for (int i = 0; i < p->parts; i++)
        provided |= p->part[i].part->provides;
    for (int i = 0; i < p->parts; i++) {
        const unsigned missing = p->part[i].part->needs & ~provided;
        TRY(check_part(p, scene, &p->part[i]));
        if (p->part[i].part->as.force && p->part[i].part->as.force->placed && repeats(p))
            return status_fail(STATUS_BAD_SCENE, "%s: %s depends on the place, and so does not go "
                               "with domain.periodic; leave one of them out", scene_path(scene),
                               p->part[i].path);
        if (missing & FIELD_DENSITY)
            return status_fail(STATUS_BAD_SCENE, "%s: %s (%s) needs a density, which no effect "
                               "provides: name effects.continuity = { }", scene_path(scene),
                               p->part[i].path, p->part[i].part->name);
        if (missing & FIELD_DENSITY_RATE)
            return status_fail(STATUS_BAD_SCENE, "%s: %s changes a density that evolves, but this "
                               "scene's density is a sum over neighbours; leave %s out, or name "
                               "effects.continuity instead of effects.summation",
                               scene_path(scene), p->part[i].path, p->part[i].path);
    }
    return STATUS_DONE;
}

/* Which density would the fluid have? */
static int check_density(const struct plan *p, const struct scene *scene)
{
    const struct plan_part *first = NULL;

    for (int i = 0; i < p->parts; i++) {
        if (!(p->part[i].part->provides & FIELD_DENSITY))
            continue;
        if (first)
            return status_fail(STATUS_BAD_SCENE, "%s: %s and %s both give the fluid its density; "
                               "leave one of them out", scene_path(scene), first->path,
                               p->part[i].path);
        first = &p->part[i];
    }
    return STATUS_DONE;
}

/* Which wall models the density of the fluid goes with, for the message. */
static void list_walls(const struct plan *p, const char *density, char *text, size_t room)
{
    size_t n = 0;

    for (int i = 0; p->engine->walls[i]; i++)
        for (const char *const *w = p->engine->walls[i]->as.wall->with; *w; w++)
            if (strcmp(*w, density) == 0 && n < room)
                n += (size_t)snprintf(text + n, room - n, "%s\"%s\"", n ? " or " : "",
                                      p->engine->walls[i]->name);
}

static bool has_solids(const struct plan *p)
{
    return p->in.wall_count + p->in.bodies > 0;
}

/* A wall model goes with some ways to a density and not with others: the rule of
 * doc/scene.md, "Walls". */
static int check_walls(const struct plan *p, const struct scene *scene)
{
    char fits[128] = "";

    for (int i = 0; i < p->parts; i++) {
        const struct part *density = p->part[i].part;
        bool good = false;
        if (!(density->provides & FIELD_DENSITY) || !has_solids(p))
            continue;
        for (const char *const *w = p->in.walls->as.wall->with; *w; w++)
            good |= strcmp(*w, density->name) == 0;
        list_walls(p, density->name, fits, sizeof fits);
        if (!good)
            return status_fail(STATUS_BAD_SCENE, "%s: walls = \"%s\" does not go with "
                               "effects.%s, where solids would have no density; set walls = %s",
                               scene_path(scene), p->in.walls->name, density->name, fits);
    }
    return STATUS_DONE;
}

/* The wall model whose only law this is; NULL: none has it. */
static const struct part *walls_of(const struct plan *p, const char *effect)
{
    for (int i = 0; p->engine->walls[i]; i++) {
        const char *only = p->engine->walls[i]->as.wall->only;
        if (only && strcmp(only, effect) == 0)
            return p->engine->walls[i];
    }
    return NULL;
}

/* An effect that takes the place of all others between fluid and solids, and its wall model: one
 * without the other would count twice, or not at all. */
static int check_only(const struct plan *p, const struct scene *scene)
{
    const char *only = p->in.walls->as.wall->only;

    if (only && has_solids(p) && !find_effect(p, only))
        return status_fail(STATUS_BAD_SCENE, "%s: with walls = \"%s\" nothing but effects.%s acts between "
                           "fluid and solids, and the scene does not name it: name effects.%s = { }",
                           scene_path(scene), p->in.walls->name, only, only);
    for (int i = 0; i < p->parts; i++) {
        const struct part *part = p->part[i].part, *walls = walls_of(p, part->name);
        if (walls && walls != p->in.walls)
            return status_fail(STATUS_BAD_SCENE, "%s: %s would push beside the pressure of walls = "
                               "\"%s\", and so count twice: set walls = \"%s\"", scene_path(scene),
                               p->part[i].path, p->in.walls->name, walls->name);
        if (only && part->as.operator && part->as.operator->stiff(p->part[i].self))
            return status_fail(STATUS_BAD_SCENE, "%s: %s is implicit, and so acts on solids, but with "
                               "walls = \"%s\" effects.%s alone does: set its side = \"explicit\"",
                               scene_path(scene), p->part[i].path, p->in.walls->name, only);
    }
    return STATUS_DONE;
}

/* What is allowed and still hardly meant. */
static void doubt_tension(const struct plan *p)
{
    if (find_effect(p, "summation") && p->pressure && !p->scales.clamped)
        status_warn("effects.summation with eos.tension = true: a free surface has half its "
                    "neighbours, a density below rho0, and pulls itself into clumps; set "
                    "eos.tension = false");
}

/* Steps that an explicit viscosity allows shrink like rho hs^2/mu, those of sound like
 * hs/c0.  An implicit one costs a step more: measured on dam breaks, as much CPU time at
 * a ratio of 0.4 to 0.5, a tenth of it at 5. */
static void advise_side(const struct plan *p)
{
    const double ratio_of_1 = p->scales.rho0 * p->scales.c0 * p->scales.hs;

    for (int i = 0; i < p->parts; i++) {
        const struct plan_part *one = &p->part[i];
        if (!one->part->as.operator)
            continue;
        const double ratio = one->part->as.operator->mu(one->self) / ratio_of_1;
        if (!one->part->as.operator->stiff(one->self) && ratio > 0.2)
            status_warn("%s: mu/(rho0 c0 hs) = %.3g: the viscosity keeps explicit steps short; "
                        "above 0.5 or so side = \"implicit\" is cheaper", one->path, ratio);
        if (one->part->as.operator->stiff(one->self) && ratio < 0.1)
            status_warn("%s: mu/(rho0 c0 hs) = %.3g: sound keeps steps shorter than this "
                        "viscosity does; side = \"explicit\" is cheaper", one->path, ratio);
    }
}

/* Single precision holds 1e-38 to 1e38.  The smallest and the largest that pairs form are
 * m^2 and 1/H^(D+4), by which laws get to a force; both with some room. */
static int check_precision(const struct plan *p, const struct scene *scene)
{
    const double m = p->scales.mass, h = p->scales.support;
    const double least = m * m, most = 1 / pow(h, DIM + 4);
    const double held = 1e30;

    if (strcmp(p->in.set.precision, "single") != 0 || !p->scales.fluid
        || (least > 1 / held && least < held && most > 1 / held && most < held))
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "%s: precision = \"single\" holds numbers from 1e-30 to 1e30, "
                       "and with spacing = %g m pairs form such as m^2 = %g kg^2 and 1/H^%d = %g: "
                       "set precision = \"double\"", scene_path(scene), p->scales.dx, least, DIM + 4,
                       most);
}

int plan_agree(const struct plan *p, const struct scene *scene)
{
    TRY(check_precision(p, scene));
    TRY(check_needs(p, scene));
    TRY(check_density(p, scene));
    TRY(check_walls(p, scene));
    TRY(check_only(p, scene));
    TRY(check_drift(p, scene));
    doubt_tension(p);
    advise_side(p);
    return STATUS_DONE;
}
