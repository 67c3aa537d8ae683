/* gslode.h -- steps by GSL's odeiv2: its formulas, our control, norm and checks.
 *
 * GSL's own evolution accepts a step whose error is not a number; here every
 * attempt is made and judged by us, as gslode.c says. */
#ifndef TIME_GSLODE_H
#define TIME_GSLODE_H

#include "algebra/vector.h"
#include "state/limit.h"
#include "time/control.h"
#include "time/method.h"
#include "time/rates.h"
#include <gsl/gsl_odeiv2.h>

/* One method: `method` comes first, so that its create() finds the row. */
struct gslode_row {
    struct method method;
    const gsl_odeiv2_step_type **type;
    int order, embedded;     /* 0: the order changes from step to step         */
    double first;            /* first step, in units of 1/(fastest rate)       */
    double stable;           /* longest stable one in these units              */
    const struct control_row *control;
    const char *table;
    int vectors;             /* that GSL's stepper holds                       */
};

/* Each is listed in method.c. */
extern const struct gslode_row gslode_rkf45, gslode_rk8pd, gslode_msadams;

enum { GSLODE_NODES = 3 };   /* ends of steps kept for dense output            */

struct gslode {
    const struct gslode_row *row;
    struct method_def def;
    struct rates rates;
    long n;                  /* entries of y                                   */

    gsl_odeiv2_step *stepper;
    gsl_odeiv2_system system;
    gsl_odeiv2_control levels; /* msadams asks it for errors that may be made, */
    gsl_odeiv2_driver driver;  /* by way of this                               */

    SUNContext context;      /* of the norm's vectors                          */
    N_Vector weight, error;
    struct control control;
    double h, h_min;         /* next step, shortest [s]; h 0: not begun        */
    double carried;          /* first step by the pace of a segment before; 0: none [s] */
    long rejected, entry;    /* entry of the largest error                     */

    struct gslode_node {
        double t, *y, *f;    /* y, f = y' [n]                                  */
    } node[GSLODE_NODES];    /* [0] is the newest                              */
    int known;               /* nodes filled                                   */
};

/* gslode-create.c */
int gslode_create(const struct method *m, const struct method_def *def, struct moment *moment,
                  double t, const double *y, void **out);
void gslode_free(void **self);

/* gslode.c */
int gslode_step(void *self, double t_stop, struct method_step *out);
int gslode_at(void *self, double t, double *y);
int gslode_restart(void *self, double t, const double *y, const struct method_pace *pace);

#endif
