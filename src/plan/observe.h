/* observe.h -- what can be known of a plan, and of a run at a (t, y) without disturbing it.
 *
 * Outputs must not shift list rebuilds, so they look through a moment of their own, made
 * beside the run's at the first look; it brings a list of its own when the run's does not
 * fit. */
#ifndef PLAN_OBSERVE_H
#define PLAN_OBSERVE_H

#include "bodies/bodies.h"
#include "plan/moment.h"
#include "plan/plan.h"
#include "plan/settings.h"
#include "state/part.h"

enum { PLAN_WORKS = 72 }; /* of all parts, walls, and two of each body */

/* The book at one moment.  Identity: total - total(0) - sum of work = defect of
 * time integration; momentum - momentum(0) - momentum_given likewise. */
struct plan_sheet {
    double t;
    struct energies energy;
    double total;             /* sum of energies                     [J]      */
    int works;
    double work[PLAN_WORKS];  /* energy each part gave so far        [J]      */
    double pressure_defect;   /* by pressure and continuity together [J]      */
    double mass;              /* of the fluid                        [kg]     */
    double momentum[DIM];     /* of fluid and bodies                 [kg m/s] */
    double momentum_given[DIM]; /* by gravity, walls, supports, loads [N s]   */
};

/* --- what is known of the plan --------------------------------------------------- */

const struct particles *plan_particles(const struct plan *plan); /* at t = 0 */
const struct scales *plan_scales(const struct plan *plan);
const struct settings *plan_settings(const struct plan *plan);
const struct settings_output *plan_output(const struct plan *plan);
int plan_probes(const struct plan *plan);
const struct settings_probe *plan_probe(const struct plan *plan, int i, const char **name);
int plan_bodies(const struct plan *plan);
const char *plan_body_name(const struct plan *plan, int body);
bool plan_body_stiff(const struct plan *plan, int body); /* has it an implicit side? */
int plan_lanes(const struct plan *plan);

/* Pressure [Pa] of n densities. */
void plan_pressures(const struct plan *plan, int n, const double *rho, double *p);

/* Impulse that the fluid gave a solid so far, [DIM] [N s]. */
const double *plan_impulse(const struct plan *plan, const double *y, int object);

/* Speed that the scene lets expect [m/s]: of the fluid at the start, of walls, of a
 * fall through the domain. */
double plan_speed_expected(const struct plan *plan);

/* Parts in the plan, a line each, for `check`. */
int plan_parts(const struct plan *plan);
const struct part *plan_part(const struct plan *plan, int i, const char **path);

int plan_work_names(const struct plan *plan, char (*name)[80]); /* their number */

/* What the last evaluation of a moment found: force on an object [DIM] [N]. */
const double *moment_force(const struct moment *moment, int object);

/* --- looks ----------------------------------------------------------------------- */

void observe_sheet(struct moment *run, double t, const double *y, struct plan_sheet *sheet);

/* All particles at (t, y); lent until the next look. */
void observe_view(struct moment *run, double t, const double *y, struct view *v);

/* Forces on solids at (t, y): afterwards observe_force() and observe_body() speak of it.
 * STATUS_FAILED when the right-hand side cannot answer. */
int observe_forces(struct moment *run, double t, const double *y);
const double *observe_force(const struct moment *run, int object); /* [DIM] [N] */
void observe_body(const struct moment *run, int body, double t, const double *y,
                  struct body_view *out);

/* For the message of a run that failed after the state (t, y): for which particle -- the
 * one that the last refusal named, or the one that is pushed hardest --, where, and which
 * part does most to it there; "" when there are no particles. */
void observe_blame(struct moment *run, double t, const double *y, char *text, size_t room);

/* NULL, or why no run should go on from here: fluid that moves faster than
 * eos.fastest times the sound speed.  Static buffer. */
const char *observe_runaway(struct moment *run, double t, const double *y);

int observe_escaped(struct moment *run, double t, const double *y); /* fluid outside the box */

/* Fluid in solids, more than half a spacing deep: how many, and the first of them. */
enum { PLAN_PLACE = 64 };
struct observe_sunk {
    int n;
    double t;               /* [s]                                            */
    int who;                /* particle, -1: none                             */
    const char *solid;      /* name of the wall or beam                       */
    char place[PLAN_PLACE]; /* "(x, y)" [m]                                   */
};
void observe_sunk(struct moment *run, double t, const double *y, struct observe_sunk *out);

#endif
