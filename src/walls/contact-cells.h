/* contact-cells.h -- which of many points are near a place, periodic directions included. */
#ifndef WALLS_CONTACT_CELLS_H
#define WALLS_CONTACT_CELLS_H

#include "state/scales.h"

struct contact_cells {
    const struct scales *scales;
    const double (*x)[DIM]; /* [points] lent                  */
    double low[DIM], width; /* of the first cell, of all [m]  */
    double reach;           /* [m]                            */
    int count[DIM];         /* cells along each axis          */
    int *start;             /* [cells + 1] into member        */
    int *member;            /* [points] cell by cell          */
};

/* What is told of each: point j, distance r [m], step [DIM] from the place to it. */
typedef void contact_cells_see(void *self, int j, double r, const double *step);

/* n points; neighbours are asked for up to `reach` [m]. */
int contact_cells_create(struct contact_cells *c, const struct scales *s,
                         const double (*x)[DIM], int n, double reach);
void contact_cells_free(struct contact_cells *c); /* twice is welcome */

/* Tells of each point nearer to x than the reach, and perhaps of some just beyond it, always
 * in the same order. */
void contact_cells_visit(const struct contact_cells *c, const double *x,
                         contact_cells_see *see, void *self);

#endif
