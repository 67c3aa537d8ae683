/* solid.h -- what contacts see of a solid that keeps its shape: a rigid body, or a wall. */
#ifndef BODIES_SOLID_H
#define BODIES_SOLID_H

#include "bodies/core.h"
#include "bodies/turning.h"

struct solid_place {   /* where it is, and how it moves                          */
    double x[DIM], v[DIM];      /* of its centre [m], [m/s]                      */
    double R[DIM][DIM];         /* takes vectors of its frame into space         */
    double spin[TURNING_SPINS]; /* in its frame [rad/s]                          */
};

struct solid {
    const char *path;    /* "body.NAME", "wall.NAME"; lent                       */
    struct core core;
    double middle[DIM], around; /* of the ball around the core, core_around() [m] */
    bool flat;           /* half a space, whose face only corners meet           */
    unsigned stops;      /* of a body: sides of the domain that stop it, shape_side() */
    struct solid_place start;      /* at t = 0                                   */
    double mass, inertia[TURNING_SPINS]; /* [kg, 2D: kg/m], [kg m^2, 2D: kg m]; of a wall
                                            infinite                             */
    double margin;       /* that edges are rounded by [m]                        */
    bool uplift;         /* water in narrow gaps has its pressure at its faces   */
    double film;         /* gap that is kept open around it [m]                   */
    double together;     /* balls of its body that touch at once, at most; 0: it is no clump */
    double speed, depth; /* at that speed it gets so deep, d_U [m/s], [m]; of a wall 0 */
    double restitution, friction; /* of a wall NaN: those of the other           */
};

/* One that nothing moves, without core and place; path is lent. */
void solid_unmoved(const char *path, struct solid *out);

/* A ball that does not turn, as points of a skin are. */
struct solid solid_ball(double radius, double mass);

/* What is beyond a side of the box low..high, for instance the bottom. */
void solid_of_side(int axis, bool high_side, const double *low, const double *high, double margin,
                   struct solid *out);

/* Where a place at t = 0 is after space has been carried along with a frame that stood at the
 * origin; that frame is at `by` now. */
void solid_carry(const struct solid_place *by, const struct solid_place *start,
                 struct solid_place *out);

/* From space into the frame of the solid, and back. */
static inline void solid_own(const struct solid_place *s, const double *vector, double *to)
{
    for (int k = 0; k < DIM; k++) {
        to[k] = 0;
        for (int d = 0; d < DIM; d++)
            to[k] += s->R[d][k] * vector[d];
    }
}

static inline void solid_space(const struct solid_place *s, const double *own, double *to)
{
    for (int d = 0; d < DIM; d++) {
        to[d] = 0;
        for (int k = 0; k < DIM; k++)
            to[d] += s->R[d][k] * own[k];
    }
}

#endif
