/* facts.h -- what is known of a plan before it runs. */
#ifndef PLAN_FACTS_H
#define PLAN_FACTS_H

#include "plan/plan.h"
#include "plan/settings.h"
#include "state/part.h"

struct surface;

const struct particles *plan_particles(const struct plan *plan); /* at t = 0 */
const struct scales *plan_scales(const struct plan *plan);
const struct settings *plan_settings(const struct plan *plan);
const struct settings_output *plan_output(const struct plan *plan);
int plan_probes(const struct plan *plan);
const struct settings_probe *plan_probe(const struct plan *plan, int i, const char **name);
bool plan_profiles(const struct plan *plan); /* has any probe a profile? */
int plan_bodies(const struct plan *plan);
const char *plan_body_name(const struct plan *plan, int body);
/* Its path, and how far water at the reference speed would bend it, in parts of what its theory
 * allows. */
double plan_body_foresee(const struct plan *plan, int body, const char **path);
bool plan_body_rigid(const struct plan *plan, int body); /* it has a pose, no tip */
double plan_body_mass(const struct plan *plan, int body); /* [kg, 2D: kg/m] */
bool plan_body_tied(const struct plan *plan, int body); /* and joints, a motion or springs? */
int plan_body_look(const struct plan *plan, int body, struct surface *to); /* of a rigid one */
const char *plan_object_group(const struct plan *plan, int object); /* "fluid", "wall", "beam" */
bool plan_body_stiff(const struct plan *plan, int body); /* has it an implicit side? */
int plan_lanes(const struct plan *plan);

/* Pressure [Pa] of n densities. */
void plan_pressures(const struct plan *plan, int n, const double *rho, double *p);

/* Panels: parts of solids whose forces are told apart. */
int plan_panels(const struct plan *plan);
const char *plan_panel_name(const struct plan *plan, int panel);
bool plan_panel_drags(const struct plan *plan, int panel); /* has it a direction of drag? */
const double *plan_panel_impulse(const struct plan *plan, const double *y, int panel);

/* Impulse that the fluid gave a solid so far, [DIM] [N s]. */
const double *plan_impulse(const struct plan *plan, const double *y, int object);

/* Speed that the scene lets expect [m/s]: of the fluid at the start, of walls, of a
 * fall through the domain with what it begins with. */
double plan_speed_expected(const struct plan *plan);

bool plan_walls_move(const struct plan *plan); /* does any? */

/* Does any fluid begin with the pressure of its depth? */
bool plan_hydrostatic(const struct plan *plan);

double plan_driven(const struct plan *plan); /* that of the fluid at the start, and of walls */
/* Does fluid stand so much higher than spread over the domain that it will fall? */
bool plan_falls(const struct plan *plan);

/* Height up to which fluid may rise [m]: its own, and what its speed or that of walls adds; when
 * it stands higher than spread over the domain and so will fall, spray reaches three times the
 * height of its top above the domain's floor (dam break of 0.2 m on a wall: 0.6 m).  HUGE_VAL
 * without gravity downwards.  The lowest rim of a frame, and which wall; NULL: there is none. */
double plan_reach(const struct plan *plan);
const char *plan_rim(const struct plan *plan, double *rim);

/* Parts in the plan, a line each, for `check`. */
int plan_parts(const struct plan *plan);
const struct part *plan_part(const struct plan *plan, int i, const char **path);

/* Passes of an evaluation in order; what each goes over, which fields it provides, adds
 * to, and reads of neighbours. */
struct plan_pass_show {
    const char *name, *over;
    char provides[200], adds[200], neighbours[200];
};
int plan_passes(const struct plan *plan);
void plan_pass_show(const struct plan *plan, int i, struct plan_pass_show *out);

/* Field i < PASS_FIELDS of plan/passes.h; false: no pass of the plan has to do with it. */
struct plan_pass_field {
    const char *name, *unit;
    int width; /* numbers of a particle, 0: not of particles                  */
};
bool plan_pass_field(const struct plan *plan, int i, struct plan_pass_field *out);

#endif
