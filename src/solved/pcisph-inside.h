/* pcisph-inside.h -- prediction and correction, as the files of this solve see it.
 *
 * Vectors are by place of the list, [n] or, with images and the dummy, [places]. */
#ifndef SOLVED_PCISPH_INSIDE_H
#define SOLVED_PCISPH_INSIDE_H

#include "eval/inside.h"
#include "kernels/kernel.h"
#include "matter/eos.h"
#include "solved/pcisph.h"
#include "space/nabla.h"

struct pcisph {
    struct moment *m;
    const struct settings_pcisph *set;
    const struct eos *eos;
    struct list *list;          /* of all kinds with all, made anew at each step */
    unsigned meets[KINDS];
    const struct kernel_use *density, *force;
    double full;                /* density of a full lattice          [kg/m^D] */
    double response;            /* (PC4)                              [m^-(2D+2)] */
    size_t slots;               /* room for so many places                    */
    double *here, *there;       /* [places][RECORD] at t, and predicted       */
    double *ones, *P;           /* [places]; p/rho0^2                         */
    double *sum;                /* [n] sums of (PC2)                          */
    double *push;               /* [n][DIM] G P                               */
};

/* pcisph-create.c: room for the places of a list that was made anew, as there may be more
 * images than before; ones are 1, all else is 0. */
int pcisph_fit(struct pcisph *p);

/* A particle that is too dense, and by how much. */
struct pcisph_worst {
    double compression; /* of the lattice's density */
    int place;
};

/* pcisph-lattice.c: what a full lattice of this spacing has: the density at a particle of
 * mass m [kg/m^D], and the response of (PC4) [m^-(2D+2)]. */
double pcisph_lattice_density(const struct kernel_use *kernel, double m, double dx);
double pcisph_lattice_response(const struct kernel_use *density, const struct kernel_use *force,
                               double dx);

/* The density whose pressure is P rho^2 [kg/m^D]; not finite: there is none. */
double pcisph_density_of(const struct eos *eos, double P);

#endif
