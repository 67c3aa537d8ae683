/* rigid-def.h -- a rigid body as a scene gives it, and what follows from that. */
#ifndef BODIES_RIGID_DEF_H
#define BODIES_RIGID_DEF_H

#include "base/param.h"
#include "bodies/rigid-ties.h"
#include "bodies/turning.h"

#include <stdbool.h>

struct rigid_def {
    const char *shape;    /* "box", "disc" (2D), "sphere" (3D)                */
    double at[3];         /* centre                                 [m]       */
    double size[3];       /* sides of a box                         [m]       */
    double radius;        /* of the others                          [m]       */
    double density, mass; /* [kg/m^3], [kg, 2D: kg/m]; 0: not given           */
    double angle[3];      /* [TURNING_SPINS] as turning_about()     [deg]     */
    double velocity[3];   /* of the centre at t = 0                 [m/s]     */
    double spin[3];       /* [TURNING_SPINS] about its own axes     [rad/s]   */
    unsigned held;        /* bit d: direction d keeps its velocity; bit DIM: the spin is kept */
    unsigned stops;       /* sides of the domain, bits as shape_side()        */
    double restitution, friction; /* there                         [1]        */
    double margin;        /* that edges are rounded by, 0: own      [m]       */
    double softness;      /* depth at speed U in margins, halved; 0: own      */
    double film;          /* that contacts keep open                [spacings] */
    int layers;           /* of the skin; 0: as many as the kernel needs      */
    bool slip;
    bool uplift;          /* water in narrow gaps has its pressure at faces of a box */
    struct rigid_ties ties; /* groups motion, hinge, slider, spring         */
};

extern const struct param rigid_def_params[];

/* Refuses (BAD_SCENE) what cannot stand; path is "body.NAME". */
int rigid_def_check(const struct rigid_def *d, const char *path);

bool rigid_def_round(const struct rigid_def *d); /* a disc or sphere? */

/* Volume [m^3, 2D: m^2], surface [m^2, 2D: m], mass [kg, 2D: kg/m]. */
double rigid_def_volume(const struct rigid_def *d);
double rigid_def_surface(const struct rigid_def *d);
double rigid_def_mass(const struct rigid_def *d);

/* q at t = 0, [TURNING_NUMBERS]. */
void rigid_def_turned(const struct rigid_def *d, double *q);

/* Half the longest way through it [m]. */
double rigid_def_reach(const struct rigid_def *d);

/* Principal moments of inertia to [TURNING_SPINS] [kg m^2, 2D: kg m]. */
void rigid_def_inertia(const struct rigid_def *d, double *to);

#endif
