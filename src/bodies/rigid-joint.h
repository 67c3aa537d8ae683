/* rigid-joint.h -- a rigid body with a hinge or slider, or driven: where it is, and how forces
 * move it.
 *
 * What is left free is the state: an angle or a length q and its rate, so that no error of a
 * step can break the joint.  What the joint is fixed to may be driven by a motion of time;
 * a body without a joint that is driven has no q. */
#ifndef BODIES_RIGID_JOINT_H
#define BODIES_RIGID_JOINT_H

#include "bodies/rigid-ties.h"
#include "bodies/turning.h"

enum rigid_joint_kind { RIGID_FREE, RIGID_FIXED, RIGID_HINGE, RIGID_SLIDER };

struct rigid_joint {
    enum rigid_joint_kind kind;  /* RIGID_FREE: no joint, and not driven           */
    const struct motion *motion; /* of what it is fixed to; NULL: that stands      */
    double axis[3];              /* of turning, or the line; of length 1           */
    double pivot[3], arm[3];     /* point of the hinge; centre from there [m]      */
    double at[3], turn[TURNING_NUMBERS];     /* at t = 0 and q = 0 [m]             */
    double rate;                             /* q' at t = 0                        */
    double mass, inertia[TURNING_SPINS];     /* [kg, 2D: kg/m], [kg m^2, 2D: kg m] */
    double stiffness, damping;               /* of the hinge                       */
};

struct rigid_place { /* as the state of a free body */
    double x[DIM], turn[TURNING_NUMBERS], v[DIM], spin[TURNING_SPINS];
};

/* Accelerations are a q'' + a_0 and, about its own axes, b q'' + b_0. */
struct rigid_link {
    double a[DIM], a_0[DIM], b[TURNING_SPINS], b_0[TURNING_SPINS];
    double q, rate;
};

struct rigid_answer { /* what a joint answers forces with */
    double second;          /* q''                                                 */
    double force[DIM];      /* on the body [N, 2D: N/m]                            */
    double driven, damping; /* power of the motion, of the hinge's damper [W]      */
};

struct rigid_def;

/* Makes the joint of a body of this mass and inertia; `d` must stay where it is. */
void rigid_joint_make(const struct rigid_def *d, double mass, const double *inertia,
                      struct rigid_joint *to);

/* (RJ1), (RJ2): where it is at time t by q and its rate. */
void rigid_joint_at(const struct rigid_joint *j, double t, double q, double rate,
                    struct rigid_place *to, struct rigid_link *link);

/* (RJ3): how it moves by force [DIM] and moment [TURNING_SPINS], about its own axes, with the
 * weight in them. */
void rigid_joint_answer(const struct rigid_joint *j, const struct rigid_place *at,
                        const struct rigid_link *link, const double *force, const double *moment,
                        struct rigid_answer *to);

double rigid_joint_elastic(const struct rigid_joint *j, double q); /* stored in a hinge [J] */

#endif
