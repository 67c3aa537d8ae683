/* observe.h -- what can be known of a plan at a moment, without disturbing the
 * run: outputs must not shift list rebuilds, so the observer brings a list of
 * its own when the run's list does not fit the moment. */
#ifndef PLAN_OBSERVE_H
#define PLAN_OBSERVE_H

#include "bodies/bodies.h"
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

int plan_work_names(const struct plan *plan, char (*name)[80]); /* their number */
void plan_sheet_make(struct plan *plan, double t, const double *y, struct plan_sheet *sheet);

/* Everybody at (t, y); lent until the next call of any plan function. */
void plan_view(struct plan *plan, double t, const double *y, struct view *v);

/* Forces on solids at (t, y): afterwards plan_force() and plan_body_view() speak
 * of this moment.  STATUS_FAILED when the right-hand side cannot answer. */
int plan_observe(struct plan *plan, double t, const double *y);
const double *plan_force(const struct plan *plan, int object);   /* [DIM] [N] */
int plan_bodies(const struct plan *plan);
const char *plan_body_name(const struct plan *plan, int body);
void plan_body_view(struct plan *plan, int body, double t, const double *y,
                    struct body_view *out);
const double *plan_impulse(const struct plan *plan, const double *y, int object); /* [DIM] [N s] */

/* For the message of a run that failed after the state (t, y): for whom -- the particle
 * that the last refusal named, or the one that is pushed hardest --, where, and which
 * part does most to it there; "" when there are no particles. */
void plan_blame(struct plan *plan, double t, const double *y, char *text, size_t room);

/* NULL, or why no run should go on from here: fluid that moves faster than
 * eos.fastest times the sound speed.  Static buffer. */
const char *plan_runaway(struct plan *plan, double t, const double *y);

/* Pressure [Pa] of n densities. */
void plan_pressures(const struct plan *plan, int n, const double *rho, double *p);

const struct particles *plan_particles(const struct plan *plan);
const struct scales *plan_scales(const struct plan *plan);
const struct settings *plan_settings(const struct plan *plan);
const struct settings_output *plan_output(const struct plan *plan);
int plan_probes(const struct plan *plan);
const struct settings_probe *plan_probe(const struct plan *plan, int i, const char **name);
int plan_escaped(struct plan *plan, double t, const double *y); /* fluid outside the box */

/* Fluid in solids, more than half a spacing deep: how many, and the first of them. */
enum { PLAN_PLACE = 64 };
struct plan_sunk {
    int n;
    double t;               /* [s]                                            */
    int who;                /* particle, -1: nobody                           */
    const char *solid;      /* name of the wall or beam                       */
    char place[PLAN_PLACE]; /* "(x, y)" [m]                                   */
};
void plan_sunk(struct plan *plan, double t, const double *y, struct plan_sunk *out);

int plan_lanes(const struct plan *plan);

/* Speed that the scene lets expect [m/s]: of the fluid at the start, of walls, of a
 * fall through the domain. */
double plan_speed_expected(const struct plan *plan);

/* Parts in the plan, a line each, for `check`. */
int plan_parts(const struct plan *plan);
const struct part *plan_part(const struct plan *plan, int i, const char **path);

#endif
