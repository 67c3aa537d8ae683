/* part.h -- the contract of a piece of physics: one file, one const struct at
 * its end, one line in its room's table.
 *
 * A part's parameters are read into a struct of its own (`self`, `size` bytes)
 * by its rows; prepare() then derives constants.  Members that are NULL are
 * never called. */
#ifndef STATE_PART_H
#define STATE_PART_H

#include "base/param.h"
#include "state/layout.h"
#include "state/limit.h"
#include "state/particles.h"
#include <stdbool.h>

struct side;  /* space/pairs.h, lanes wide: only hot rooms look inside */
struct block;
struct sum;
struct field_sum;
struct coupling; /* effects/effects.h */

enum { /* fields */
    FIELD_DENSITY = 1 << 0,
    FIELD_PRESSURE = 1 << 1,
    FIELD_DENSITY_RATE = 1 << 2 /* a density that evolves: rates may be added */
};

/* Whose kernel a law is weighed with: a scene may give each use its own. */
enum part_kernel { PART_DENSITY, PART_PRESSURE, PART_VISCOSITY, PART_KERNELS };

enum { /* columns of a pair law's sum */
    COLUMN_FORCE = 1 << 0,
    COLUMN_DRHO = 1 << 1
};

struct energies {
    double kinetic, potential, internal, elastic; /* [J, 2D: J/m] */
};

typedef void part_pairs(const void *self, const struct side *a, const struct block *b,
                        struct sum *to);
typedef void part_gather(const void *self, const struct side *a, const struct block *b,
                         struct field_sum *to);
typedef void part_couple(const void *self, const struct side *a, const struct block *b,
                         struct coupling *to);

enum { PART_SUMS = 2 + DIM }; /* numbers that a field's gather() may add up     */

/* What settle() makes densities of: owners of kind k with what gather() added up
 * for them. */
struct settle {
    const struct view *v;
    enum kind kind;
    int n;                           /* owners                                  */
    const int *owner;                /* [n] creation index                      */
    const double (*sum)[PART_SUMS];  /* [n]                                     */
    double *rho;                     /* [count of kind], creation order, to fill
                                        where there is an owner       [kg/m^D]  */
};

struct part {
    const char *name, *about;
    const char *equation; /* in plain characters, with its label              */
    const char *source;
    size_t size;
    const struct param *params;

    unsigned needs, provides; /* FIELD_ bits                                  */
    const char *instead;      /* name of the effect it stands for: not both   */
    enum part_kernel kernel;  /* that pairs() is weighed with                 */
    unsigned rows;            /* NEED_ bits of pairs()                        */
    unsigned columns;         /* COLUMN_ bits of pairs()                      */
    unsigned acts[KINDS];     /* pairs(): partner kinds by owner kind         */
    bool conservative;        /* its power only moves energy between kinetic
                                 and internal: booked as pressure_defect      */

    /* Completes what its rows have read: called once, before anything else. */
    int (*complete)(void *self);

    /* Adds rows to y; density_row[k] becomes the row that holds the density of
     * kind k, for kinds whose density it evolves. */
    int (*blocks)(void *self, const struct scales *s, const struct particles *p,
                  struct layout *l, int density_row[KINDS]);

    /* Derives constants from parameters; refuses what makes no sense. */
    int (*prepare)(void *self, const struct scales *s);

    /* Adds to the owners' own sum; written symmetric in its two sides. */
    part_pairs *pairs;

    /* Picks another law than pairs by what the parameters say, once. */
    part_pairs *(*choose)(const void *self);

    /* Of a law that is linear in velocities, F_ab = -c (v_a - v_b): the c >= 0 of rows,
     * without v; stiff(): its parameters ask for the implicit side; faces(): the fluid is
     * to stick at the faces of solids; its mu [Pa s]. */
    part_couple *couple;
    bool (*stiff)(const void *self);
    bool (*faces)(const void *self);
    double (*mu)(const void *self);

    /* A density that does not evolve: gather() visits pairs before the forces are
     * known, weighed with the kernel of densities, and settle() makes the density
     * of its sums. */
    unsigned meets[KINDS];    /* gather(): partner kinds by owner kind        */
    unsigned gather_rows;     /* NEED_ bits of gather()                       */
    part_gather *gather;
    void (*settle)(const void *self, const struct settle *s);

    /* Instead of settle(): velocities that fluid moves with beside those in y, of the
     * sums, added to drift [count of kind][DIM] [m/s]. */
    void (*carry)(const void *self, const struct settle *s, double (*drift)[DIM]);

    /* Of a wall model: solids get their density by the part that gives the fluid
     * its own, and store energy by it; else the model settles it itself. */
    bool as_fluid;
    const char *const *with;  /* effects that may give the fluid its density  */

    /* p [Pa] of n densities [kg/m^D] (parts that provide FIELD_PRESSURE). */
    void (*pressure)(const void *self, int n, const double *rho, double *p);

    /* Adds to the acceleration of the fluid, rate [n fluid][DIM] [m/s^2]; `placed`:
     * one that depends on the place, and so does not repeat. */
    void (*field)(const void *self, const struct view *v, double (*rate)[DIM]);
    bool placed;

    void (*limit)(const void *self, const struct view *v, struct limit *out);

    /* Adds what it stores. */
    void (*energy)(const void *self, const struct view *v, struct energies *to);
};

#endif
