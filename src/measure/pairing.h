/* pairing.h -- do particles stand in pairs and clumps, or each on its own?
 *
 * Distances count in units of the mean spacing that a particle's own density gives,
 * d = (m/rho)^(1/D): 1 on a square lattice, 1.07 on a hexagonal one.  Particles with a
 * neighbour nearer than half of it are paired.  Kernels with a gradient
 * that vanishes at the centre (gauss, poly6) let them under pressure: Toth 2012, figure
 * 5, calls it clustering.  Dehnen, Aly, Mon. Not. R. Astron. Soc. 425 (2012) 1068-1082. */
#ifndef MEASURE_PAIRING_H
#define MEASURE_PAIRING_H

#include "state/particles.h"

struct pairing; /* work arrays, made once for a run */

struct pairing_index {
    double share; /* of the fluid in the domain that is paired, 0 to 1      [1] */
    double mean;  /* distance of the nearest neighbour, in d: mean ...      [1] */
    double least; /* ... and least, of particles with one within the support [1];
                     both NAN when there are none                               */
};

int pairing_create(const struct particles *p, struct pairing **out);
void pairing_free(struct pairing **pairing); /* NULL is welcome */

/* Of the fluid at this moment, O(n); solids are no neighbours here. Fluid
 * outside the domain does not count. */
void pairing_find(struct pairing *g, const struct view *v, struct pairing_index *out);

#endif
