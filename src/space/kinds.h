/* kinds.h -- what a particle is.  Kinds are contiguous ranges, of rows as well as
 * of the order of the pair list. */
#ifndef SPACE_KINDS_H
#define SPACE_KINDS_H

#include "base/dim.h"

#include <stdbool.h>

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

/* Numbers of particles of a kind that stand elsewhere, by row of the kind: those of rows from `from` on.
 * x NULL: there are none. */
struct rows_beyond {
    const double *x, *u; /* [][DIM] position [m], velocity [m/s]               */
    const double *rho;   /* [] density [kg/m^D]                                */
    int from;
};

static inline bool is_beyond(const struct rows_beyond *of, int row)
{
    return of->x && row >= of->from;
}

/* Positions of all particles.  A row is where the numbers of a particle stand, in any
 * order; its id is its own for ever. */
struct cloud {
    int from[KINDS + 1];    /* kind k: rows from[k] .. from[k+1]-1           */
    const double *x[KINDS]; /* [count of kind][DIM] position [m]             */
    const int *row[KINDS];  /* [count of kind] row, counted from from[k], of the
                               particle with the i-th smallest id of the kind;
                               NULL: rows ascend by id                       */
    struct rows_beyond beyond; /* of the first kind, their x alone: for what is asked of a list
                                  that stands, none where one is made        */
};

#endif
