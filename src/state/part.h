/* part.h -- the contract of a piece of physics: one file, one const struct at its
 * end, one line in its room's table.
 *
 * In layers: struct part says which part this is and has what all parts may have;
 * what it does in the sums, it says in one small struct for each role that it plays.
 * Roles that it does not play, and functions that it does not need, are NULL and
 * never called.
 *
 * A part's parameters are read into a struct of its own (`self`, `size` bytes)
 * by its rows; complete() and prepare() derive constants.  After that nothing of it
 * changes: all other functions get it const, and write to what they get without. */
#ifndef STATE_PART_H
#define STATE_PART_H

#include "base/param.h"
#include "state/layout.h"
#include "state/limit.h"
#include "state/particles.h"
#include <stdbool.h>

struct shape;      /* shapes/shape.h */
struct kernel_use; /* kernels/kernel.h */
struct side;  /* space/pairs.h, lanes wide: only hot rooms look inside */
struct block;
struct sum;
struct field_sum;
struct coupling; /* effects/effects.h */

enum { /* what parts need and provide */
    FIELD_DENSITY = 1 << 0,
    FIELD_PRESSURE = 1 << 1,
    FIELD_DENSITY_RATE = 1 << 2 /* a density that evolves: rates may be added */
};

/* Which of the kernels that a scene may give weighs a law. */
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

/* A law between pairs of particles. */
struct part_law {
    enum part_kernel kernel;  /* that pairs() is weighed with                 */
    unsigned rows;            /* NEED_ bits of pairs()                        */
    unsigned columns;         /* COLUMN_ bits of pairs()                      */
    unsigned acts[KINDS];     /* partner kinds by owner kind; not read with kinds() */
    bool conservative;        /* its power only moves energy between kinetic
                                 and internal: booked as pressure_defect      */

    /* Adds to the owners' own sum; written symmetric in its two sides. */
    part_pairs *pairs;

    /* Picks another law than pairs, and other partner kinds than acts, [KINDS], by what
     * the parameters say, once. */
    part_pairs *(*choose)(const void *self);
    const unsigned *(*kinds)(const void *self);
};

typedef void part_couple(const void *self, const struct side *a, const struct block *b,
                         struct coupling *to);

/* Of a law that is linear in velocities, F_ab = -c (v_a - v_b), and so can be solved
 * for; it has a struct part_law, too. */
struct part_operator {
    part_couple *couple;               /* the c >= 0 of rows; law's rows without v  */
    bool (*stiff)(const void *self);   /* its parameters ask for the implicit side  */
    bool (*faces)(const void *self);   /* the fluid is to stick at faces of solids  */
    double (*mu)(const void *self);    /* its viscosity [Pa s]                      */
};

enum { PART_SUMS = 2 + DIM }; /* numbers that gather() may add up               */

/* What gather() added up for the owners of one kind. */
struct part_sums {
    const struct view *v;
    enum kind kind;
    int n;                           /* owners                                  */
    const int *owner;                /* [n] creation index                      */
    const double (*sum)[PART_SUMS];  /* [n]                                     */
};

typedef void part_gather(const void *self, const struct side *a, const struct block *b,
                         struct field_sum *to);

/* A quantity that is summed over pairs before the forces are known: a density that does
 * not evolve, or a drift.  One of densities() and carry() is there. */
struct part_summed {
    unsigned meets[KINDS];    /* gather(): partner kinds by owner kind        */
    unsigned rows;            /* NEED_ bits of gather()                       */

    /* Adds to the owners' own sum, weighed with the kernel of densities. */
    part_gather *gather;

    /* The densities [kg/m^D] of owners, into rho [count of kind], by row. */
    void (*densities)(const void *self, const struct part_sums *s, double *rho);

    /* Velocities that fluid moves with beside those in y, added to drift [count of
     * kind][DIM] [m/s], by row.  Its power has a column of the book. */
    void (*carry)(const void *self, const struct part_sums *s, double (*drift)[DIM]);
};

/* A force on the fluid that no pair gives. */
struct part_force {
    /* Adds to the acceleration of the fluid in its rows from .. to-1, rate [to][DIM] [m/s^2]: each
     * thread has some of them, and on many ranks all are those of one. */
    void (*accelerate)(const void *self, const struct view *v, int from, int to,
                       double (*rate)[DIM]);
    bool placed;              /* depends on the place, and so does not repeat */
    bool weight;              /* the scene's `gravity` calls for it, not its name;
                                 the books know what it gives                 */
};

/* A rate of density of the fluid that no pair gives.  It acts where the pressure is 0, so
 * that it has no power: the book has no column for it. */
struct part_source {
    /* Adds to the rate of density of the fluid in its rows from .. to-1, rate [to] [kg/m^D/s]. */
    void (*densify)(const void *self, const struct view *v, int from, int to, double *rate);
};

/* Densities that are replaced between two segments, at times of its own. */
struct part_filter {
    double (*event)(const void *self, double t); /* next time after t that it acts at [s] */
    unsigned meets[KINDS];    /* gather(): partner kinds of the fluid         */
    unsigned rows;            /* NEED_ bits of gather()                       */

    /* Adds to the owners' own sum, weighed with the kernel of densities. */
    part_gather *gather;

    /* From the densities of the fluid [kg/m^D] to those after it, rho [fluid], by row.  The
     * energy that this takes has a column of the book. */
    void (*densities)(const void *self, const struct part_sums *s, double *rho);
};

typedef void part_moduli(const void *self, int n, const double *rho, const double *p,
                         double *modulus);

/* What gives a pressure (parts that provide FIELD_PRESSURE). */
struct part_pressure {
    /* p [Pa] of n densities [kg/m^D]. */
    void (*pressures)(const void *self, int n, const double *rho, double *p);

    /* rho dp/drho [Pa] of n densities and their pressures; 0 where p is cut off. */
    part_moduli *moduli;

    /* The time that a pressure looks ahead [s], and the residual of its solve as a share of the
     * right-hand side; 0: it is that of the density alone.  NULL: likewise.  Its part begins
     * with a struct eos that is linear, and what it gives has a column of the book. */
    double (*ahead)(const void *self, double *residual);
    double speeds; /* default sound speed by sqrt(2 g H) */
};

/* Where a solid stands at t = 0. */
struct part_solid {
    const struct shape *shape; /* that its particles fill; NULL: a skin, known by its points */
    int group;                 /* solids of one number never move against each other, those
                                  of 0 do not move at all; -1: no solid       */
};

/* All that a wall model may know of the places of solids. */
struct part_places {
    const struct particles *p;        /* at t = 0, rows are ids               */
    const struct kernel_use *kernel;  /* of densities                         */
    const struct part_solid *solid;   /* [objects]                            */
    bool sharp;       /* their pressure is solved for: its law may have corners */
    bool together;    /* all ranks ask this at once, and may share the work */
};

/* Solids that fluid meets, that are this rank's (the last choose()), or all. */
enum part_solids { PART_SOLIDS_MET, PART_SOLIDS_OWN, PART_SOLIDS_ALL };

/* Densities of rows of y, and what becomes of them, [solids] by row, from the first solid. */
struct part_pressed {
    const double *rho; /* that the solids' own rows hold         [kg/m^D]     */
    double *shown;     /* that they show, and store energy by; may be rho [kg/m^D] */
    double *p2;        /* p/rho^2 that they press with; NULL     [m^5/(kg s^2)] */
    double *mean;      /* that the law is of, before its corner; NULL [kg/m^D] */
    enum part_solids which; /* of which it is wanted                          */
};

struct part_press_work; /* what members work in: memory of a wall model          */
typedef void part_see(void *self, const void *array, size_t bytes); /* one of several */

/* Solids that press by more than a density of their own.  Self keeps what is known of their places. */
struct part_press {
    int (*create)(void *self, const struct part_places *at);
    void (*free)(void *self);

    /* Densities of kind k at t = 0, by id, from those of the pressure there. */
    void (*start)(const void *self, const struct particles *p, enum kind k, double *rho);

    /* All the memory that members will ever need; a pointer to NULL is welcome. */
    int (*work)(const void *self, struct part_press_work **out);
    void (*work_free)(struct part_press_work **work);

    /* From now on fluid meets these, or these are this rank's: solid [solids] by id, from the first. */
    void (*choose)(const void *self, struct part_press_work *w, enum part_solids which, const bool *solid);

    /* Marks solids [solids] by id whose densities press() reads for those that are met, and no others.
     * False: it may be any, as solids come near to others. */
    bool (*reads)(const void *self, const struct part_press_work *w, bool *read);

    /* p says where solids are now, and which particle stands in which row. */
    void (*press)(const void *self, struct part_press_work *w, const struct particles *p,
                  const struct part_pressed *io);

    /* Where the law is one of means of densities: means of numbers of solids, and the
     * transpose of that; both [solids] by row, of those of the last press(), 0 elsewhere. */
    void (*mean)(const void *self, struct part_press_work *w, const double *from, double *to);
    void (*spread)(const void *self, struct part_press_work *w, const double *from, double *to);

    /* Forces between solids, at the places of the last press(), into f [solids][DIM] by row
     * [N]: of the rows whose number it returns, to row [solids], each once.  The rest of f is
     * left as it was. */
    int (*meet)(const void *self, struct part_press_work *w, const struct particles *p,
                const double *p2, double (*f)[DIM], int *row);

    /* Bytes that it took, with one work; its large arrays, which create() alone writes to. */
    double (*memory)(const void *self);
    void (*show)(const void *self, part_see *see, void *whose);
};

/* A wall model: where the density of solids comes from, if not from its own sums. */
struct part_wall {
    bool as_fluid;            /* from the part that gives the fluid its own,
                                 and solids store energy by it                */
    const char *const *with;  /* effects that may give the fluid its density, NULL-ended */
    const char *only;         /* the effect that alone acts between fluid and solids; NULL: all do */
    const struct part_press *press; /* NULL: solids press by their density     */
};

struct part_roles {
    const struct part_law *law;
    const struct part_operator *operator;
    const struct part_summed *summed;
    const struct part_force *force;
    const struct part_source *source;
    const struct part_filter *filter;
    const struct part_pressure *pressure;
    const struct part_wall *wall;
};

struct part {
    const char *name, *about;
    const char *equation; /* in plain characters, with its label              */
    const char *source;
    size_t size;
    const struct param *params;

    unsigned needs, provides; /* FIELD_ bits                                  */
    const char *instead;      /* name of the effect it stands for: not both   */

    /* Completes what its rows have read: called once, before anything else. */
    int (*complete)(void *self);

    /* Derives constants from parameters; refuses what makes no sense. */
    int (*prepare)(void *self, const struct scales *s);

    /* Adds blocks to y; density_row[k] becomes the one that holds the density of
     * kind k, for kinds whose density it evolves. */
    int (*blocks)(const void *self, const struct scales *s, const struct particles *p,
                  struct layout *l, int density_row[KINDS]);

    /* Of the fluid: solids of v have no pressure. */
    void (*limit)(const void *self, const struct view *v, struct limit *out);

    /* Adds what it stores. */
    void (*energy)(const void *self, const struct view *v, struct energy_sums *to);

    struct part_roles as;
};

/* Does its power only move energy between kinetic and internal? */
static inline bool part_conserves(const struct part *part)
{
    return part->as.law && part->as.law->conservative;
}

/* Is its power booked? */
static inline bool part_is_booked(const struct part *part)
{
    return part->as.law || (part->as.summed && part->as.summed->carry)
           || (part->as.pressure && part->as.pressure->ahead) || part->as.filter;
}

/* Does it move particles beside their velocity? */
static inline bool part_drifts(const struct part *part)
{
    return part->as.summed && part->as.summed->carry;
}

#endif
