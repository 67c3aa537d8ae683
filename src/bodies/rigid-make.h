/* rigid-make.h -- makes a rigid body from its parameters; takes all its memory. */
#ifndef BODIES_RIGID_MAKE_H
#define BODIES_RIGID_MAKE_H

#include "bodies/bodies.h"
#include "bodies/rigid-figure.h"
#include "bodies/rigid-joint.h"
#include "bodies/rigid-spring.h"

struct body {
    struct rigid_def def;
    char path[64];
    double mass, inertia[TURNING_SPINS]; /* [kg, 2D: kg/m], [kg m^2, 2D: kg m]      */
    double g[DIM], low[DIM];             /* gravity [m/s^2], corner of the domain [m] */
    double length, speed;                /* that errors are measured by [m], [m/s]  */
    double rate;                         /* the fastest: (RB4), touch_rate(); 0: none [1/s] */
    int points;
    double (*arm)[DIM];                  /* [points], in the frame of the body [m]  */
    int row[4];                          /* x, turn, v, spin                       */
    double margin, depth, film;          /* of contacts: rounds edges; d_U; gap to walls [m] */
    struct rigid_figure figure;
    int cores;
    struct core *core;                   /* [cores] what contacts take it for     */
    struct rigid_joint joint;
    int joint_row[3];                    /* with a joint: q, q', time             */
    struct rigid_rope rope[RIGID_SPRINGS]; /* [def.ties.springs]                  */
    double decay;                        /* the fastest of dampers [1/s]           */
};

struct body_work {
    double R[DIM][DIM];
    const double *x, *turn, *v, *spin; /* in y, with a joint in place */
    struct rigid_place place;
    struct rigid_link link;
    struct body_push push;             /* of contacts */
};

/* As in struct body_making. */
int rigid_make(const void *params, const struct scales *s, const char *name, const char *path,
               struct body **out);
void rigid_make_free(struct body **body);
int rigid_make_work(const struct body *b, struct body_work **out);
void rigid_make_work_free(struct body_work **work);

#endif
