/* kinds.h -- what a particle is.  Kinds are contiguous ranges, in creation
 * order as well as in the order of the pair list. */
#ifndef SPACE_KINDS_H
#define SPACE_KINDS_H

#include "base/dim.h"

enum kind {
    KIND_FLUID,
    KIND_WALL,      /* solid with prescribed motion, the fluid sticks to it  */
    KIND_WALL_SLIP, /* the same, viscosity does not act                      */
    KIND_SKIN,      /* point of a beam or body, the fluid sticks to it       */
    KIND_SKIN_SLIP, /* the same, viscosity does not act                      */
    KINDS
};

#define KIND_BIT(kind) (1u << (kind))
#define KIND_SOLIDS (KIND_BIT(KIND_WALL) | KIND_BIT(KIND_WALL_SLIP) \
                     | KIND_BIT(KIND_SKIN) | KIND_BIT(KIND_SKIN_SLIP))
#define KIND_STICKY (KIND_BIT(KIND_WALL) | KIND_BIT(KIND_SKIN))

/* Positions of everybody, creation order. */
struct cloud {
    int from[KINDS + 1];    /* kind k: particles from[k] .. from[k+1]-1      */
    const double *x[KINDS]; /* [count of kind][DIM] position [m]             */
};

#endif
