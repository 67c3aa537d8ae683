/* sum.h -- sums over pairs: calls the laws of the plan on rows of neighbours, for each
 * pair from both sides, adds their sums in table order and keeps the book of power by
 * slot.  No bit depends on the number of threads nor on the lane width. */
#ifndef PLAN_SUM_H
#define PLAN_SUM_H

#include "space/list.h"
#include "space/record-pack.h"
#include "state/part.h"

struct pairs_table;
struct kernel_use;
struct exact_sum; /* algebra/exact-sum.h */
struct exact_cut;

enum {
    SUM_SLOTS = 16 /* rows of the book at most                                */
};

/* Where rates of the fluid go, by creation index: instead of to their places, so that
 * they need not be carried there.  NULL: to their places. */
struct sum_rates {
    double (*u)[DIM]; /* [fluid][DIM] f/m instead of f              [m/s^2]   */
    double *rho;      /* [fluid] instead of drho              [kg/m^D/s]      */
    int rows;         /* of owners; what others get, 0, goes to the row behind */
};

struct sum_job {
    const struct list *list;
    const double *record;              /* [listed+1][RECORD], 64-byte aligned */
    double mass;                       /* of all particles [kg, 2D: kg/m], or 0 */
    const struct pairs_table *table;   /* [KINDS][KINDS] owner, partner       */
    int slots;                         /* columns of the book                 */
    double later;                      /* powers are those of velocities and
                                          pressures that rates lead to so long
                                          after the records; 0: of the records */
    const double (*push)[DIM];         /* accelerations of the fluid by other
                                          things than pairs, by row;
                                          for later != 0, NULL: velocities stay */
    part_moduli *moduli;               /* of the equation of state `eos`: what rates
                                          of density make of pressures; for
                                          later != 0, NULL: pressures stay    */
    const void *eos;
    bool fluid_only;                   /* those of solids are not the pairs' to say */
    double *f;                         /* [particles][DIM] force by place [N] */
    double *drho;                      /* [particles] rate of density by place
                                          [kg/m^D/s]: divided by the mass     */
    struct sum_rates rates;            /* those of fluid that is not listed stay
                                          as they are                         */
    double *power;                     /* [columns] v.f + p2 m drho over all
                                          owners [W]                          */
    double *apart;                     /* [particles][DIM] where forces of column
                                          `apart_slot` go instead of f; NULL  */
    int apart_slot;
    bool shared;                       /* with other ranks: powers are those of all */
    struct exact_sum *parts;           /* [slots] or NULL: then powers are not written, but
                                          what this rank has of them, for the caller to add */
};

/* Sums for a summed density, before there are forces. */
struct sum_field_job {
    const struct list *list;
    const double *record;            /* as in struct sum_job                  */
    const unsigned *meets;           /* [KINDS] partner kinds by owner kind   */
    unsigned needs;                  /* NEED_ bits                            */
    part_gather *gather;
    const void *self;
    const struct kernel_use *kernel;
    double (*sum)[PART_SUMS];        /* [particles] of owners; others untouched */
};

/* Starts as { 0 }; memory is taken at the first call.  The caller frees all arrays at the end. */
struct sum_scratch {
    int threads, slots;
    int places;              /* records that there is room for                */
    float *record;           /* in single precision: space/single.h; NULL     */
    struct exact_sum *power; /* [threads][slots] of each thread               */
    struct exact_cut *cut;   /* [threads][slots] that served the last rows    */
};

struct sum_engine {
    int lanes;
    const struct list_engine *list;
    record_packer *pack;
    record_densities *densities; /* comes before pack: what it is given */

    /* How the laws of a table are run, before pairs() meets it and after each change
     * of it; `fuse`: in one loop where there is one (effects/fused.h), the same bits. */
    void (*arrange)(struct pairs_table *table, bool fuse);

    /* 0 or STATUS_FAILED (no memory). */
    int (*pairs)(const struct sum_job *job, struct sum_scratch *scratch);
    void (*field)(const struct sum_field_job *job);
};

/* Those of summed densities, in sum-field.c. */
void sum_field_lanes2(const struct sum_field_job *job);
void sum_field_lanes4(const struct sum_field_job *job);
void sum_field_lanes8(const struct sum_field_job *job);

extern const struct sum_engine sum_engine_lanes2, sum_engine_lanes4, sum_engine_lanes8;

/* The same with pairs in single precision: what laws give is summed in it for each owner;
 * all else, from those sums on, is in double precision. */
extern const struct sum_engine sum_engine_single_lanes2, sum_engine_single_lanes4,
    sum_engine_single_lanes8;

#endif
