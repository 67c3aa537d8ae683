/* couple.h -- a law that is linear in velocities, as a matrix:
 *
 *     F_a = sum over b of c_ab (v_b - v_a),  c_ab = c_ba >= 0
 *
 * assemble() asks the law for every c_ab once, in the order of the list's rows, and
 * gives the forces of the first velocities by the way; multiply() then gives those of
 * any others for a fraction of a pass over pairs.  No bit depends on the number of
 * threads nor on the lane width. */
#ifndef PLAN_COUPLE_H
#define PLAN_COUPLE_H

#include "space/list.h"
#include "state/part.h"

struct kernel_use;

/* Numbers of one velocity: pairs of them are loaded at once. */
enum { COUPLE_STRIDE = DIM == 2 ? 2 : 4 };

struct couple_job {
    const struct list *list;
    const unsigned *acts;            /* [KINDS] partner kinds by owner kind     */
    part_couple *couple;
    const void *self;
    unsigned needs;                  /* NEED_ bits                              */
    const struct kernel_use *kernel;
    double *c;                       /* [rows of the list][lanes]               */
    double *diagonal;                /* [particles] sum of an owner's c, 0 where
                                        nothing acts                            */
    double *firm;                    /* [particles] of the fluid: its part with solids,
                                        else as diagonal                        */
};

struct couple_engine {
    /* velocity [listed + 1][COUPLE_STRIDE] by place, 16-byte aligned, those of images and
     * of the dummy, too; f [particles][DIM] of all owners, or of those of some kinds
     * (bits): others are not touched. */
    void (*assemble)(const struct couple_job *job, const double *record,
                     const double *velocity, double *f);
    void (*multiply)(const struct couple_job *job, unsigned kinds, const double *velocity,
                     double *f);
};
extern const struct couple_engine couple_engine_lanes2, couple_engine_lanes4,
    couple_engine_lanes8;

#endif
