/* passes.h -- one evaluation while it lasts, and what its passes do. */
#ifndef EVAL_PASSES_H
#define EVAL_PASSES_H

#include "eval/inside.h"

/* What passes read and write besides the moment: made for one evaluation, gone after it. */
struct evaluation {
    struct moment *m;
    const struct ask *ask;
    double t;                /* [s]                                              */
    const double *y;         /* [size]                                           */
    double *ydot;            /* [size], NULL: no rates                           */
    struct view view;        /* where everything is, as soon as it is there      */
    struct rates_job job;    /* sums over pairs                                  */
    double *power;           /* of the implicit law, with job.apart [W]; NULL    */
};

typedef int passes_run(struct evaluation *e, const struct plan_field *of);

/* view.c, press.c, fields.c, pack.c */
passes_run passes_motion, passes_press, passes_press_ahead, passes_meet, passes_list, passes_records,
    passes_sum;

/* laws.c */
passes_run passes_ahead, passes_others, passes_slip, passes_laws, passes_faces, passes_apart;

/* fluid.c */
passes_run passes_fluid, passes_pulls;

/* ahead.c */
passes_run passes_look_ahead, passes_ahead_power;

/* push.c */
passes_run passes_drift, passes_solid_pairs, passes_solids, passes_skins, passes_load, passes_book,
    passes_half_book;

/* rigid-side.c */
passes_run passes_contacts;

/* fluid.c: body forces at this view, the weight first, added to rates of velocities of ydot. */
void passes_add_body_forces(struct evaluation *e);

#endif
