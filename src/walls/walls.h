/* walls.h -- how solids meet the fluid, and how walls move. */
#ifndef WALLS_WALLS_H
#define WALLS_WALLS_H

#include "state/part.h"

/* Wall models of the compiled width, NULL-ended; the first is the default.  Rooms
 * without lanes ask the engine for them. */
#ifdef LANES
#define walls_table LANE_NAME(walls_table)
extern const struct part *const walls_table[];
#endif

struct track; /* walls/track.h */

/* Prescribed motion of a wall, keys of wall.NAME: it turns about `pivot`, in the plane
 * of x and the last coordinate, and is shifted:
 *
 *   x = pivot + R(angle) (x0 - pivot) + shift,           s = t - start, held in 0 .. stop - start
 *   shift = velocity s + amplitude (sin(2 pi f s + phase) - sin phase) + path(s) direction
 *   angle = spin s + swing (sin(2 pi f s + phase) - sin phase) + turn(s) */
struct walls_motion {
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

    struct track *path_track, *turn_track; /* made by walls_motion_prepare()   */
};
extern const struct param walls_motion_params[];

/* Where a wall is at a moment; struct object has the part that others need. */
struct walls_place {
    double shift[DIM], u[DIM], a[DIM];     /* of the pivot [m], [m/s], [m/s^2] */
    double cosine, sine;                   /* of the angle                     */
    double omega, alpha;                   /* its rates [1/s], [1/s^2]         */
};

/* Checks keys and makes the tracks.  BAD_SCENE names the key; `path` is "wall.NAME",
 * `where` "FILE:LINE". */
int walls_motion_prepare(struct walls_motion *m, const char *path, const char *where);
void walls_motion_free(struct walls_motion *m);

/* Does it move at all, and does it turn? */
bool walls_motion_any(const struct walls_motion *m);
bool walls_motion_turns(const struct walls_motion *m);

/* Are they the same motion? */
bool walls_motion_same(const struct walls_motion *a, const struct walls_motion *b);

void walls_motion_at(const struct walls_motion *m, double t, struct walls_place *to);

/* Position [m] and velocity [m/s] of the particle that was at x0; each [DIM]. */
void walls_motion_point(const struct walls_motion *m, const struct walls_place *p,
                        const double *x0, double *x, double *u);

/* Where the particle that is at x was: the inverse. */
void walls_motion_back(const struct walls_motion *m, const struct walls_place *p, const double *x,
                       double *x0);

/* Next time after t at which its velocity may jump, HUGE_VAL: never [s]. */
double walls_motion_event(const struct walls_motion *m, double t);

/* What the box low..high [DIM] sees until t = until: the farthest that a corner gets
 * away from its place along each axis, reach [DIM] [m], and the largest speed [m/s];
 * by looking at many moments. */
double walls_motion_extent(const struct walls_motion *m, const double *low, const double *high,
                           double until, double *reach);

#endif
