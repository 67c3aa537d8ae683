/* rigid-ties.h -- what holds, drives or pulls a rigid body, as a scene gives it: the groups
 * motion, hinge, slider and spring of body.NAME. */
#ifndef BODIES_RIGID_TIES_H
#define BODIES_RIGID_TIES_H

#include "bodies/group.h"
#include "state/motion.h"

#include <stdbool.h>

enum { RIGID_SPRINGS = 16 };

struct rigid_hinge {
    double at[3], axis[3];     /* as it stands at t = 0 [m]; of any length, 3D only */
    double stiffness, damping; /* against turning from there [N m, 2D: N], [N m s, 2D: N s] */
};

struct rigid_slider {
    double along[3]; /* of any length */
};

struct rigid_spring {
    const char *name;
    double on[3], to[3];       /* place on the body at t = 0, fixed place in space [m] */
    double stiffness, damping; /* [N/m, 2D: N/m^2], [N s/m, 2D: N s/m^2]    */
    double rest;               /* length without force [m], NAN: that at t = 0 */
    bool slack;                /* pulls only                                */
};

struct rigid_ties {
    int motions, hinges, sliders, springs; /* given: 0 or 1, of springs the number */
    struct motion motion;
    struct rigid_hinge hinge;
    struct rigid_slider slider;
    struct rigid_spring spring[RIGID_SPRINGS];
};

/* The groups' keys and where they go, in a struct rigid_def; its last has no name. */
extern const struct body_group rigid_ties_groups[];

struct rigid_def;

/* Refuses (BAD_SCENE) what cannot stand; makes the tracks of the motion, which
 * rigid_ties_free() frees.  `path` is "body.NAME". */
int rigid_ties_prepare(struct rigid_def *d, const char *path);
void rigid_ties_free(struct rigid_def *d);

#endif
