/* doubts.c -- what a user should hear, even of a quiet run, though it is no error: of a
 * scene before it runs, and of a run that came to its end. */
#include "run/inside.h"

#include "base/status.h"
#include "scene/scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double energy_share = 0.01; /* of the energy there is: a defect that matters */
static const double energy_made = 0.5;   /* and one that makes a run a failure   */

/* By how much x lies outside the domain along its first `axes` axes [m]; below 0: inside.
 * Where the domain repeats there is no outside. */
static double outside(const struct scales *s, const double *x, int axes)
{
    double most = -HUGE_VAL;

    for (int d = 0; d < axes; d++)
        if (!(s->period[d] > 0))
            most = fmax(most, fmax(s->low[d] - x[d], x[d] - s->high[d]));
    return most;
}

static const char *where(const struct run *r, const char *group, const char *name)
{
    const struct scene_node *node = scene_child(scene_root(r->scene), group);

    node = node ? scene_child(node, name) : NULL;
    return node ? scene_where(node) : scene_path(r->scene);
}

static void doubt_probes(const struct run *r)
{
    const struct scales *s = plan_scales(r->plan);

    for (int i = 0; i < plan_probes(r->plan); i++) {
        const char *name;
        const struct settings_probe *probe = plan_probe(r->plan, i, &name);
        const bool height = strcmp(probe->what, "height") == 0;
        const bool out = outside(s, probe->at, height ? DIM - 1 : DIM) > 0;
        if (out && isnan(probe->to[0]) && isnan(probe->radius))
            status_warn("%s: probe.%s lies outside the domain, where fluid counts as lost: it will "
                        "read 0", where(r, "probe", name), name);
        else if (out || (!isnan(probe->to[0]) && outside(s, probe->to, DIM) > 0))
            status_warn("%s: the area of probe.%s reaches out of the domain, where fluid counts as "
                        "lost: a part of it will read 0", where(r, "probe", name), name);
    }
}

static void doubt_place(const struct run *r, const struct object *beam)
{
    const struct scales *s = plan_scales(r->plan);

    for (int i = beam->from; i < beam->from + beam->n; i++) {
        const double *x = plan_particles(r->plan)->x0[i];
        if (outside(s, x, DIM) < s->dx)
            continue;
        status_warn("%s: beam.%s reaches out of the domain near (%g, %g) m, where fluid counts as "
                    "lost", where(r, "beam", beam->name), beam->name, x[0], x[1]);
        return;
    }
}

static void doubt_skins(const struct run *r)
{
    const struct particles *p = plan_particles(r->plan);

    for (int i = 0; i < p->objects; i++)
        if (p->object[i].kind == KIND_SKIN || p->object[i].kind == KIND_SKIN_SLIP)
            doubt_place(r, &p->object[i]);
}

/* A tolerance that no step obeys.  Solves of the implicit side do obey it. */
static void doubt_tol(const struct run *r)
{
    const struct scene_node *node = scene_child(scene_root(r->scene), "tol");
    const double usual = method_def_default().tol;

    if ((r->method->adaptive && !(r->def.seconds > 0)) || plan_stiff(r->plan)
        || r->def.tol == usual)
        return;
    status_warn("%s: tol = %g does nothing with %s, whose steps do not follow their errors",
                node ? scene_where(node) : scene_path(r->scene), r->def.tol,
                r->def.seconds > 0 ? "steps of a constant length" : r->method->name);
}

int run_doubt_scene(const struct run *r)
{
    doubt_tol(r);
    if (!plan_scales(r->plan)->fluid)
        return STATUS_DONE;
    doubt_probes(r);
    TRY(run_doubt_hopes(r));
    run_doubt_lacks(r);
    doubt_skins(r);
    return STATUS_DONE;
}

/* Has it a beam, whose vibrations this method damps? */
static bool damps(const struct run *r)
{
    return plan_stiff(r->plan) && !plan_viscous(r->plan) && strcmp(r->method->name, "imex4") != 0
        && outputs_energy_made(r->outputs) < 0.5 * outputs_defect_max(r->outputs);
}

static void advise_step(const struct run *r, char *to, size_t room)
{
    if (r->def.seconds > 0)
        snprintf(to, room, "take steps shorter than %g s", r->def.seconds);
    else if (r->method->adaptive && damps(r))
        snprintf(to, room, "take method = \"imex4\", which hardly damps the vibration of a beam, "
                 "or a tol below %g", r->def.tol);
    else if (r->method->adaptive)
        snprintf(to, room, "take a tol below %g", r->def.tol);
    else
        snprintf(to, room, "take a smaller CFL number (%s@...), or a method that controls its "
                 "error", r->method->name);
}

/* The defect of the book is the error of time integration; energy made so may drive what
 * a figure shows.  Methods that brake by design lose, and are not failures for it. */
static int doubt_energy(const struct run *r)
{
    const double defect = outputs_defect_max(r->outputs), there = outputs_energy_most(r->outputs);
    char advice[160];

    if (!(defect > energy_share * there))
        return STATUS_DONE;
    advise_step(r, advice, sizeof advice);
    if (outputs_energy_made(r->outputs) > energy_made * there)
        return status_fail_with(STATUS_FAILED, (struct status_advice){ .remedy = advice },
                                "energy out of nothing: by t = %g s time integration made %.3g J, "
                                "%.3g %% of the %.3g J there were, and nothing in this run can be "
                                "trusted, though it came to its end", r->past.tally.t,
                                outputs_energy_made(r->outputs),
                                100 * outputs_energy_made(r->outputs) / there, there);
    status_warn("energy: the book missed by %.3g J at its worst, %.3g %% of the %.3g J there were; "
                "that is the error of time integration, so %s", defect,
                100 * defect / there, there, advice);
    return STATUS_DONE;
}

/* Where walls are hollow or thin, fluid may be inside. */
static void doubt_solids(const struct run *r)
{
    const struct observe_sunk *s = outputs_sunk(r->outputs);
    const bool contact = strcmp(plan_settings(r->plan)->walls, "contact") == 0;
    const bool clamped = plan_scales(r->plan)->clamped;

    if (s->n > 0)
        status_warn("fluid in solids: %d particles are in solids at t = %g s, more than half a "
                    "spacing deep, particle %d (%s at %s m) among them; what it does to forces "
                    "and levels means nothing: take %s%sa higher eos.c0 (it is %.3g m/s), "
                    "a smaller tol or thicker solids", s->n, s->t, s->particle, s->solid, s->place,
                    contact ? "" : "walls = \"contact\", ", clamped ? "" : "eos.tension = false, ",
                    plan_scales(r->plan)->c0);
}

int run_doubt_end(const struct run *r, const double *y)
{
    const double rho0 = plan_scales(r->plan)->rho0;
    const int out = observe_escaped(r->moment, r->past.tally.t, y);

    if (out > 0)
        status_warn("%d fluid particle%s left the domain and fall%s for ever, and the energies of the "
                    "book count them: a larger domain.to, its lid or a rim keeps spray in", out,
                    out == 1 ? "" : "s", out == 1 ? "s" : "");
    doubt_solids(r);
    if (r->past.tally.density[1] > 1.2 * rho0 && moment_counts(r->moment)->iterations == 0)
        status_warn("density reached %g kg/m^3, %.0f %% above rho0: take a higher eos.c0 (10 times "
                    "the largest speed)", r->past.tally.density[1],
                    100 * (r->past.tally.density[1] / rho0 - 1));
    return doubt_energy(r);
}
