/* flow.h -- how a fluid moves at the start: velocities and pressures by formula.
 *
 * Flows lie in the plane of the first and the last coordinate, here x and z (2D: y). */
#ifndef FILL_FLOW_H
#define FILL_FLOW_H

#include "base/param.h"
#include "space/kinds.h"

/* Keys of fluid.NAME; what a scene did not give is NaN. */
struct flow {
    const char *type;   /* name of a kind, "still": none                       */
    double rate;        /* [1/s]                                               */
    double speed;       /* [m/s]                                               */
    double size;        /* length after which it repeats; radius of a drop [m] */
    double amplitude;   /* of a wave [m]                                       */
    double pressure;    /* in the middle of a drop [Pa]                        */
    double centre[3];   /* [m]                                                 */

    /* set by the caller before flow_check() */
    double low[DIM], high[DIM]; /* box around the fluid [m]                    */
    double gravity;     /* downwards [m/s^2]                                   */
    double rho0;        /* [kg/m^D]                                            */
};

struct flow_kind {
    const char *name, *about, *source;
    const char *keys;   /* it needs, in words: "flow_rate flow_size"           */
    const char *may;    /* it takes besides; NULL: none                        */

    /* Adds to u [DIM] [m/s] at x [DIM]. */
    void (*velocity)(const struct flow *f, const double *x, double *u);

    /* Pressure [Pa] at x beside that of the weight; NULL: 0. */
    double (*pressure)(const struct flow *f, const double *x);
};

extern const struct flow_kind *const flow_table[]; /* NULL-ended               */
extern const struct param flow_params[];

/* Completes what was not given (centre: that of the box, for a wave the left end of
 * the surface).  BAD_SCENE: a key is missing, or a wave without weight.  `path` is
 * "fluid.NAME", `where` "FILE:LINE". */
int flow_check(struct flow *f, const char *path, const char *where);

/* NULL for "still". */
const struct flow_kind *flow_find(const struct flow *f);

#endif
