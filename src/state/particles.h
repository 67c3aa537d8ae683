/* particles.h -- all particles: fluid, walls, skins.  Only what does not evolve is held
 * here; what evolves is in y.
 *
 * Three indices, three words.  The id of a particle is the order of creation, its own for
 * ever; its row is where its numbers stand, in y and in the arrays below, in any order
 * within its kind; its place is that in the pair list (space/list.h).  The particles of a
 * plan stand in rows of their ids for good, those of a moment until it is rearranged. */
#ifndef STATE_PARTICLES_H
#define STATE_PARTICLES_H

#include "algebra/exact-sum.h"
#include "space/kinds.h"
#include "state/scales.h"
#include <stdbool.h>
#include <stddef.h>

/* A named thing of the scene that has particles: fluid, wall, beam, body. */
struct object {
    char name[64];   /* "tank", without the group                             */
    enum kind kind;
    int from, n;     /* ids from .. from+n-1                                  */
    int carved;      /* of a fluid: sites that it left to solids              */
    int carver;      /* object that took most of these                        */
    double a[DIM];   /* of a wall: acceleration of its centre now [m/s^2]     */
    double centre[DIM]; /* about which it turns now               [m]         */
    double slide[DIM];   /* of a wall: velocity of its surface beside that of its
                            particles                     [m/s]               */
    double omega, alpha; /* its angle's rates, in the plane of x and the last
                            coordinate                   [1/s], [1/s^2]       */
};

struct particles {
    const struct scales *scales;
    int n, from[KINDS + 1];
    double *m;            /* [n] mass                           [kg, 2D: kg/m] */
    int *object_of;       /* [n] index into object                             */
    unsigned char *dye;   /* [n] colour 0, 1, ...                              */
    double (*x0)[DIM];    /* [n] position at t = 0; where rows were rearranged, of solids
                             only                               [m]            */
    double (*x)[DIM];     /* [n] solids only: position now      [m]            */
    double (*u)[DIM];     /* [n] solids only: velocity now      [m/s]; both NULL
                             where there is no moment                          */
    int *id[KINDS];       /* [count of kind] of the particle in a row, both counted
                             from from[kind]; NULL: rows are ids               */
    int *row[KINDS];      /* [count of kind] of the particle with an id, likewise */
    void *own;            /* of a moment: memory of what moves, and of rows that were
                             rearranged                                        */
    int objects;
    struct object *object; /* [objects] in creation order                     */
};

/* All particles at one moment: where to read x, u, rho of each kind, by row. */
struct view {
    const struct particles *p;
    double t;
    const double *x[KINDS];   /* [count of kind][DIM] position   [m]           */
    const double *u[KINDS];   /* [count of kind][DIM] velocity   [m/s]         */
    const double *rho[KINDS]; /* [count of kind]      density    [kg/m^D]      */
    const double *p2[KINDS];  /* [count of kind] p/rho^2 that solids press with;
                                 NULL: that of their density                  */
    bool stores[KINDS];       /* that density holds internal energy            */
    struct rows_beyond beyond; /* of the fluid: rows that other ranks own     */
    int others;               /* rows of the fluid that are not here, the last ones: of other
                                 ranks                                        */
    const bool *mine;         /* [n] by row: this rank's, of whose sums others have the rest;
                                 NULL: all rows are                           */
    const int *near;          /* [nears] rows of fluid that others own and whose places are here */
    int nears;
};

/* Where the position of row i of a kind stands, and its density, which there must be. */
static inline const double *view_x(const struct view *v, int kind, int i)
{
    return (kind == KIND_FLUID && is_beyond(&v->beyond, i) ? v->beyond.x : v->x[kind]) + (size_t)i * DIM;
}

static inline const double *view_rho(const struct view *v, int kind, int i)
{
    return (kind == KIND_FLUID && is_beyond(&v->beyond, i) ? v->beyond.rho : v->rho[kind]) + i;
}

/* Is row c of all kinds one that this rank adds up? */
static inline bool view_has(const struct view *v, int c)
{
    return !v->mine || v->mine[c];
}

/* Energies of particles while they are added up, in no order: of those that are this rank's [J, 2D: J/m]. */
struct energy_sums {
    struct exact_sum kinetic, potential, internal;
};

static inline int particles_count(const struct particles *p, enum kind k)
{
    return p->from[k + 1] - p->from[k];
}

/* The row of the particle with an id, both counted from from[k]. */
static inline int particles_row(const struct particles *p, enum kind k, int id)
{
    return p->row[k] ? p->row[k][id] : id;
}

/* The same, both counted over all kinds. */
static inline int particles_row_of(const struct particles *p, int id)
{
    const enum kind k = p->object[p->object_of[id]].kind; /* a kind keeps its rows */

    return p->from[k] + particles_row(p, k, id - p->from[k]);
}

/* The id of the particle in row c of all kinds. */
static inline int particles_id_of(const struct particles *p, int c)
{
    const enum kind k = p->object[p->object_of[c]].kind;

    return p->id[k] ? p->from[k] + p->id[k][c - p->from[k]] : c;
}

/* Acceleration of the point x of a rigid wall [m/s^2], all [DIM]. */
static inline void object_acceleration(const struct object *o, const double *x, double *a)
{
    const double across = x[0] - o->centre[0], above = x[DIM - 1] - o->centre[DIM - 1];

    for (int d = 0; d < DIM; d++)
        a[d] = o->a[d];
    a[0] -= o->alpha * above + o->omega * o->omega * across;
    a[DIM - 1] += o->alpha * across - o->omega * o->omega * above;
}

void particles_free(struct particles **p);

#endif
