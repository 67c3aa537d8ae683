/* motion.h -- prescribed motion of walls and bodies. */
#ifndef STATE_MOTION_H
#define STATE_MOTION_H

#include "base/param.h"
#include "space/kinds.h"

#include <stdbool.h>

struct track; /* state/track.h */

/* Keys of wall.NAME, and of body.NAME.motion: it turns about `pivot`, in the plane
 * of x and the last coordinate, and is shifted:
 *
 *   x = pivot + R(angle) (x0 - pivot) + shift,           s = t - start, held in 0 .. stop - start
 *   shift = velocity s + amplitude (sin(2 pi f s + phase) - sin phase) + path(s) direction
 *   angle = spin s + swing (sin(2 pi f s + phase) - sin phase) + turn(s) */
struct motion {
    double velocity[3];  /* [m/s]                                              */
    double amplitude[3]; /* [m]                                                */
    double frequency;    /* f [Hz]                                             */
    double phase;        /* [deg]                                              */
    double start, stop;  /* [s]                                                */
    double direction[3]; /* of the path, made of length 1                      */
    struct param_points path; /* pairs of time [s] and distance [m]            */
    double pivot[3];     /* [m]                                                */
    double spin, swing;  /* [deg/s], [deg]                                     */
    struct param_points turn; /* pairs of time [s] and angle [deg]             */

    struct track *path_track, *turn_track; /* made by motion_prepare()         */
};
extern const struct param motion_params[];

/* Where it is at a moment; struct object has the part that others need. */
struct motion_place {
    double shift[DIM], u[DIM], a[DIM];     /* of the pivot [m], [m/s], [m/s^2] */
    double angle, cosine, sine;            /* [rad]                            */
    double omega, alpha;                   /* its rates [1/s], [1/s^2]         */
};

/* Checks keys and makes the tracks.  BAD_SCENE names the key; `path` is "wall.NAME",
 * `where` "FILE:LINE". */
int motion_prepare(struct motion *m, const char *path, const char *where);
void motion_free(struct motion *m);

/* Does it move at all, and does it turn? */
bool motion_any(const struct motion *m);
bool motion_turns(const struct motion *m);

/* Are they the same motion? */
bool motion_same(const struct motion *a, const struct motion *b);

void motion_at(const struct motion *m, double t, struct motion_place *to);

/* Position [m] and velocity [m/s] of the particle that was at x0; each [DIM]. */
void motion_point(const struct motion *m, const struct motion_place *p,
                        const double *x0, double *x, double *u);

/* Where the particle that is at x was: the inverse. */
void motion_back(const struct motion *m, const struct motion_place *p, const double *x,
                       double *x0);

/* Next time after t at which its velocity may jump, HUGE_VAL: never [s]. */
double motion_event(const struct motion *m, double t);

/* The same of its acceleration: at every pair of path and turn, too. */
double motion_bend(const struct motion *m, double t);

/* What the box low..high [DIM] sees until t = until: the farthest that a corner gets
 * away from its place along each axis, reach [DIM] [m], and the largest speed [m/s];
 * by looking at many moments. */
double motion_extent(const struct motion *m, const double *low, const double *high,
                           double until, double *reach);

#endif
