/* rigid-def.h -- a rigid body as a scene gives it, and what follows from that. */
#ifndef BODIES_RIGID_DEF_H
#define BODIES_RIGID_DEF_H

#include "base/param.h"
#include "bodies/rigid-ties.h"
#include "bodies/turning.h"

#include <stdbool.h>

enum { RIGID_DEF_CORNERS = 2 }; /* of a part of a compound, unless told: opposite ones of a box */

struct rigid_def {
    const char *shape;    /* "box", "clump"; 2D "disc", "polygon"; 3D "sphere", "cylinder", "hull", "compound" */
    double at[3];         /* centre, or where the origin of points is [m]     */
    double size[3];       /* sides of a box                         [m]       */
    double radius;        /* disc, sphere, cylinder, balls of a clump [m]     */
    double height;        /* cylinder, along its third axis         [m]       */
    struct param_points points; /* polygon: corners in turn; hull; clump: centres [m] */
    int corners;          /* compound: points that each of its parts has      */
    const char *of;       /* clump: the shape that it is made from            */
    double body_radius;   /* clump of a disc, sphere, cylinder: of that [m]   */
    double pitch;         /* clump made from a shape: how far apart centres are [m] */
    double frame[4];      /* 3D: of its axes of inertia in those that a scene tells it by, a
                             quaternion; all 0: they are those                */
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

/* Refuses (BAD_SCENE) a mass that cannot be; path is "body.NAME", volume [m^3, 2D: m^2]. */
int rigid_def_check(const struct rigid_def *d, double volume, const char *path);

/* q at t = 0, [TURNING_NUMBERS]. */
void rigid_def_turned(const struct rigid_def *d, double *q);

/* q and spin as the scene's axes have them, of those of its axes of inertia. */
void rigid_def_tell(const struct rigid_def *d, const double *q, const double *spin,
                    double *told_q, double *told_spin);

#endif
