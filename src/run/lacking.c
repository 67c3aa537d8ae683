/* lacking.c -- effects that the objects of a scene call for and that it does not name. */
#include "run/inside.h"

#include "base/status.h"
#include "plan/solver.h"
#include "scene/scene.h"
#include "state/part.h"

#include <string.h>

/* What the parts of a scene do between them. */
struct doings {
    bool presses; /* a pressure acts between particles      */
    bool brakes;  /* a viscosity does                       */
    bool pulls;   /* a body force does                      */
    bool evolves, smooths; /* densities; something evens them out */
};

static struct doings look(const struct run *r)
{
    struct doings to = { 0 };

    for (int i = 0; i < plan_parts(r->plan); i++) {
        const char *path;
        const struct part *part = plan_part(r->plan, i, &path);
        const struct part_law *law = part->as.law;
        const bool own = (part->provides & FIELD_DENSITY) != 0;

        to.presses |= law && law->conservative && (law->columns & COLUMN_FORCE);
        to.brakes |= law && law->kernel == PART_VISCOSITY;
        to.pulls |= part->as.force != NULL;
        to.evolves |= (part->provides & FIELD_DENSITY_RATE) != 0;
        to.smooths |= law && !own && (law->columns & COLUMN_DRHO) != 0;
    }
    return to;
}

static void doubt_pressure(const struct run *r)
{
    status_warn("%s: no effect is a pressure: nothing keeps the fluid apart, and solids do not stop "
                "it: name effects.pressure = { } and effects.continuity = { }", scene_path(r->scene));
}

static void doubt_viscosity(const struct run *r)
{
    status_warn("%s: this water falls, and no effect is a viscosity: what breaks up at an impact keeps "
                "its motion below the spacing, as noise in pressures and spray: name "
                "effects.artificial-viscosity = { } or effects.laminar-viscosity = { }",
                scene_path(r->scene));
}

/* A scene that names its gravity means it. */
static void doubt_rest(const struct run *r)
{
    if (scene_child(scene_root(r->scene), "gravity"))
        return;
    status_warn("%s: nothing moves this fluid: there is no gravity, no other body force, no speed at "
                "the start and no wall that moves; is gravity = [%s-9.81] missing?",
                scene_path(r->scene), DIM == 2 ? "0, " : "0, 0, ");
}

static void doubt_density(const struct run *r)
{
    status_warn("%s: this water falls on %s, and no effect evens out its density: loads on it will "
                "be noisy: name effects.density-diffusion = { }", scene_path(r->scene),
                plan_body_name(r->plan, 0));
}

/* A theory, not an effect, but it ends the run as well.  The guess is good to a factor of two. */
static void doubt_theories(const struct run *r)
{
    for (int i = 0; i < plan_bodies(r->plan); i++) {
        const char *path;
        const double share = plan_body_foresee(r->plan, i, &path);
        if (share > 1)
            status_warn("%s: %s may bend too far: this water falls, and at %.3g m/s would bend it by some "
                        "%.1g times what a linear beam is good for, which ends the run: is it as "
                        "stiff as you meant it? If so, set theory = \"elastica\"", scene_path(r->scene),
                        path, plan_scales(r->plan)->speed, share);
    }
}

void run_doubt_lacks(const struct run *r)
{
    const struct doings does = look(r);
    const bool solved = plan_solved(r->method->name) != NULL, falls = plan_falls(r->plan);
    const int bodies = plan_bodies(r->plan);

    if (!does.presses)
        doubt_pressure(r);
    if (does.presses && !does.brakes && falls && !solved)
        doubt_viscosity(r);
    if (!does.pulls && plan_driven(r->plan) == 0 && bodies == 0)
        doubt_rest(r);
    if (falls)
        doubt_theories(r);
    if (does.presses && does.evolves && !does.smooths && falls && !solved && bodies > 0)
        doubt_density(r);
}
