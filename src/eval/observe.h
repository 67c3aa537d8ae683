/* observe.h -- what can be known of a run at a (t, y) without disturbing it.
 *
 * Outputs must not shift list rebuilds, so they look through a moment of their own, made
 * beside the run's at the first look; it brings a list of its own when the run's does not
 * fit. */
#ifndef EVAL_OBSERVE_H
#define EVAL_OBSERVE_H

#include "bodies/bodies.h"
#include "book/book.h"
#include "eval/moment.h"
#include "plan/facts.h"

/* What the last evaluation of a moment found: force on an object [DIM] [N]. */
const double *moment_force(const struct moment *moment, int object);

/* --- looks ----------------------------------------------------------------------- */

/* At own rows of y, all ranks together, where each has these alone (moment_is_packed()). */
void observe_sheet(struct moment *run, double t, const double *y, struct book_sheet *sheet);

/* All particles at (t, y); lent until the next look. */
void observe_view(struct moment *run, double t, const double *y, struct view *v);

/* The same where only the fluid is looked at: solids may lack their pressure, and show the
 * densities that their rows hold. */
void observe_fluid(struct moment *run, double t, const double *y, struct view *v);

/* The same at a y that has this rank's rows alone, where it has them alone: see `others` there. */
void observe_own(struct moment *run, double t, const double *y, struct view *v);

/* Has each of many ranks a second moment with all pairs, as it has to look at sums over sums for itself?
 * Else the first alone, where own rows do not stand before others (moment_is_packed()). */
bool observe_each(const struct moment *run);

/* After observe_forces() at the same (t, y): the fluid of this rank, and where that of others is near to it;
 * where it has all rows, the fluid.  All that is within a support of an own particle is there. */
void observe_near(struct moment *run, double t, const double *y, struct view *v);

/* Forces on solids at (t, y), on all ranks at own rows of y, where each has these alone
 * (moment_is_packed()): afterwards observe_force() and observe_body() speak of it, but
 * where the pressure was solved for once a step: forces on objects, panels and bodies are then
 * those of the last step (given.h).  Before any look observe_body() knows where a body is, not
 * the forces on it.  STATUS_FAILED when the right-hand side cannot answer. */
int observe_forces(struct moment *run, double t, const double *y);
const double *observe_force(const struct moment *run, int object); /* [DIM] [N] */
/* The same of a panel; its moment [3] (2D: the last) and drag [N], NaN without `along`. */
struct observe_panel {
    double force[DIM], turn[3], drag;
};
void observe_panel(const struct moment *run, int panel, struct observe_panel *out);
void observe_body(const struct moment *run, int body, double t, const double *y,
                  struct body_view *out);
/* The same of a rigid body (plan_body_rigid()). */
void observe_pose(const struct moment *run, int body, const double *y, struct body_pose *out);
/* And where the frame stands in which plan_body_look() tells its surface. */
void observe_stand(const struct moment *run, int body, const double *y, struct solid_place *out);

/* For the message of a run that failed after the state (t, y): for which particle -- the
 * one that the last refusal named, or the one that is pushed hardest --, where, and which
 * part does most to it there; "" when there are no particles. */
void observe_blame(struct moment *run, double t, const double *y, char *text, size_t room);

/* STATUS_FAILED when no run should go on from here: fluid moves faster than eos.fastest
 * times the sound speed. */
int observe_runaway(struct moment *run, double t, const double *y);

/* Can that be where fluid moves at most at this speed [m/s]? */
bool observe_may_run_away(const struct moment *run, double speed);

/* STATUS_FAILED when a body has met a wall or another body, with no contact between them. */
int observe_meeting(struct moment *run, double t, const double *y);

/* What body i makes of itself: judge() of bodies/bodies.h. */
int observe_judge(const struct moment *run, int body, double t, const double *y, char *doubt,
                  size_t room);

int observe_escaped(struct moment *run, double t, const double *y); /* fluid outside the box */

/* Fluid in solids, more than half a spacing deep: how many, and the first of them. */
enum { PLAN_PLACE = 64 };
struct observe_sunk {
    int n;
    double t;               /* [s]                                            */
    int particle;                /* particle, -1: none                             */
    const char *solid;      /* name of the wall or beam                       */
    char place[PLAN_PLACE]; /* "(x, y)" [m]                                   */
};
void observe_sunk(struct moment *run, double t, const double *y, struct observe_sunk *out);

/* The same on all ranks together at own rows of y, where each has these alone. */
void observe_sunk_together(struct moment *run, double t, const double *y, struct observe_sunk *out);

#endif
