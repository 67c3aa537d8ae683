/* rigid-make.h -- makes a rigid body from its parameters; takes all its memory. */
#ifndef BODIES_RIGID_MAKE_H
#define BODIES_RIGID_MAKE_H

#include "bodies/bodies.h"
#include "bodies/rigid-def.h"
#include "bodies/touch.h"

struct rigid_sides { /* of the domain that stop it                       */
    int sides, places;                /* each corner meets each side           */
    int axis[2 * DIM];                /* [sides]                               */
    double sign[2 * DIM], at[2 * DIM]; /* of the normal; coordinate [m]         */
    double ball, depth;               /* radius of a corner; d_U [m]           */
    struct touch_law law;
};

struct body {
    struct rigid_def def;
    char path[64];
    double mass, inertia[TURNING_SPINS]; /* [kg, 2D: kg/m], [kg m^2, 2D: kg m]      */
    double g[DIM], low[DIM];             /* gravity [m/s^2], corner of the domain [m] */
    double length, speed;                /* that errors are measured by [m], [m/s]  */
    double rate;                         /* the fastest: (RB4), touch_rate(); 0: none [1/s] */
    int points;
    double (*arm)[DIM];                  /* [points], in the frame of the body [m]  */
    int row[6];                          /* x, turn, v, spin; where it is stopped xi, work */
    struct rigid_sides stops;
};

struct body_work {
    double R[DIM][DIM];
    const double *x, *turn, *v, *spin; /* in y */
};

/* As in struct body_making. */
int rigid_make(const void *params, const struct scales *s, const char *name, const char *path,
               struct body **out);
void rigid_make_free(struct body **body);
int rigid_make_work(const struct body *b, struct body_work **out);
void rigid_make_work_free(struct body_work **work);

#endif
