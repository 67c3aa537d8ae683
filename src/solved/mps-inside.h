/* mps-inside.h -- a step of MPS as its files see it.  Arrays are by place of the list, fluid
 * first: [n] particles. */
#ifndef SOLVED_MPS_INSIDE_H
#define SOLVED_MPS_INSIDE_H

#include "eval/inside.h"
#include "solved/mps.h"
#include "solved/near.h"
#include "solved/poisson.h"
#include "solved/weights.h"

#include <string.h>

struct mps;
typedef double mps_pair(const struct mps *s, int i, int j);

/* Corrections that the book tells apart. */
enum mps_work { MPS_PRESSURE, MPS_COLLISIONS, MPS_STABILISATION, MPS_VISCOSITY, MPS_WORKS };

/* What corrections of a step gave, by id. */
struct mps_gave {
    double (*kick[MPS_WORKS])[DIM]; /* [n] to velocities of the fluid      [m/s]   */
    double (*push)[DIM];            /* [n] to solids                       [N s]   */
    double walls[MPS_WORKS];        /* to moving walls                     [J]     */
    int column[MPS_WORKS];          /* where the book has it                       */
};

struct mps {
    struct moment *moment;
    const struct settings_mps *key;
    struct list *list;
    struct near near;             /* at r*, with velocities u*                     */
    struct weights density, gradient, laplacian;
    struct poisson poisson;
    bool *face;                   /* [particles] by id: in the first layer of a wall */
    char *role;                   /* [n] enum poisson_role                         */
    double *number, *rate;        /* [n] number density at r*, and its rate        */
    double *before, *rate_before; /* [n] of r^k, by id; where ECS asks              */
    double *source, *p, *lowest;  /* [n] b of (M7); pressure; its minimum around   */
    double (*du)[DIM];            /* [n] corrections of one kind           [m/s]   */
    double (*was)[DIM];           /* [n] places before the pressure        [m]     */
    struct mps_gave gave;         /* in this step                                  */
    double reach, h;              /* of the list [m]; of the step [s]              */
    mps_pair *rise;               /* of the gradient: what a pair counts with [Pa] */
};

static inline bool mps_is(const char *word, const char *what)
{
    return strcmp(word, what) == 0;
}

/* mps-source.c: number densities, or their rates, of all particles. */
void mps_number(const struct mps *s, double *number);
void mps_rate(const struct mps *s, double *rate);
void mps_roles(struct mps *s);
void mps_source(struct mps *s);
poisson_weight *mps_laplacian(const struct mps *s);

/* mps-gradient.c: du = -dt/rho grad p of the fluid, and what it gives to solids. */
void mps_gradient(struct mps *s);

/* mps-collide.c: du of pairs that are too near to each other. */
void mps_collide(struct mps *s);
void mps_stabilise(struct mps *s);

/* mps-viscosity.c: du = dt nu lap u, at r^k, and what it gives to solids. */
void mps_viscosity(struct mps *s);

/* mps-book.c: corrections of a step are none yet; adds du of the fluid to velocities and places,
 * and to what the step gave; writes the step to y. */
void mps_begin(struct mps *s);
void mps_apply(struct mps *s, enum mps_work what);
void mps_write(struct mps *s, double t, const double *y, double *to);

/* mps-book.c: where the book has powers of pressure and continuity. */
int mps_conserved(const struct plan *p);

/* Does this part change densities alone?  Here these are those of pressures. */
static inline bool mps_density_law(const struct part *part)
{
    return part->as.law && !(part->as.law->columns & ~(unsigned)COLUMN_DRHO);
}

/* The id of the particle in a place, of all kinds; its object. */
static inline int mps_id(const struct mps *s, int i)
{
    return particles_id_of(s->moment->particles, s->list->order[i]);
}

static inline int mps_object(const struct mps *s, int i)
{
    return s->moment->particles->object_of[s->list->order[i]];
}

/* A correction gives `by` times the way `step` [DIM] to the solid in place j [N s]. */
static inline void mps_push(struct mps *s, enum mps_work what, int j, double by,
                            const double *step)
{
    double *push = s->gave.push[mps_id(s, j)];

    for (int d = 0; d < DIM; d++) {
        push[d] += by * step[d];
        s->gave.walls[what] += by * step[d] * s->near.u[j][d];
    }
}

/* Mass of a particle of the fluid [kg]. */
static inline double mps_mass(const struct mps *s, int i)
{
    return s->moment->particles->m[s->list->order[i]];
}

#endif
