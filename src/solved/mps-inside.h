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
    double (*push)[DIM];          /* [objects] impulses on solids in this step [N s] */
    double made;                  /* energy that corrections of this step made [J] */
    double walls;                 /* energy that moving walls took in it   [J]     */
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

/* mps-viscosity.c: du = dt nu lap u, at r^k. */
void mps_viscosity(struct mps *s);

/* mps-book.c: adds du of the fluid to velocities and places, and what that makes to the book
 * of the step; writes the step to y. */
void mps_apply(struct mps *s);
void mps_write(struct mps *s, double t, const double *y, double *to);

/* Does this part change densities alone?  Here these are those of pressures. */
static inline bool mps_density_law(const struct part *part)
{
    return part->as.law && !(part->as.law->columns & ~(unsigned)COLUMN_DRHO);
}

/* The id of the particle in a place; its object. */
static inline int mps_id(const struct mps *s, int i)
{
    return particles_id_of(s->moment->particles, s->list->order[i]);
}

static inline int mps_object(const struct mps *s, int i)
{
    return s->moment->particles->object_of[s->list->order[i]];
}

/* Mass of a particle of the fluid [kg]. */
static inline double mps_mass(const struct mps *s, int i)
{
    return s->moment->particles->m[s->list->order[i]];
}

#endif
