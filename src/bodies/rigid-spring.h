/* rigid-spring.h -- springs, dampers and lines from rigid bodies to fixed points. */
#ifndef BODIES_RIGID_SPRING_H
#define BODIES_RIGID_SPRING_H

#include "bodies/rigid-joint.h"

struct rigid_rope { /* a spring, ready to pull */
    const struct rigid_spring *def;
    double arm[DIM]; /* where it is tied, from the centre in the frame of the body [m] */
    double rest;     /* [m] */
};

/* What a spring does at a state. */
struct rigid_pull {
    double force[DIM], moment[TURNING_SPINS]; /* on the body, in space; about its own axes */
    double damping;                           /* power of the damper, never positive [W] */
    double elastic;                           /* what it stores [J]                  */
};

void rigid_spring_make(const struct rigid_def *d, const struct rigid_spring *s,
                       struct rigid_rope *to);

/* (RP1); v, spin and x of the body's centre, R of (RB1). */
void rigid_spring_pull(const struct rigid_rope *s, double (*const R)[DIM], const double *x,
                       const double *v, const double *spin, struct rigid_pull *to);

/* Bounds on the rates of a free body by all springs [1/s]: of swinging and of decay. */
void rigid_spring_rates(const struct rigid_rope *s, int springs, double mass,
                        const double *inertia, double *swing, double *decay);

/* The largest |length at t = 0 - rest| [m]. */
double rigid_spring_stretch(const struct rigid_rope *s, int springs);

#endif
