/* sweep-outputs.h -- a few numbers that tell what a run has shown. */
#ifndef STUDY_SWEEP_OUTPUTS_H
#define STUDY_SWEEP_OUTPUTS_H

#include "study/inside.h"

enum { SWEEP_OUTPUTS = 600, SWEEP_NAME = 120 };

/* One number of each run. */
struct sweep_output {
    char name[SWEEP_NAME]; /* "front.x.end", "tank.force.peak", "plate.tip_x.peak_t"       */
    char unit[24];
    bool main;             /* for the screen and the figures                               */
    double *value;         /* [points]; NAN: that run does not have it                     */
};

struct sweep_outputs {
    int n, points;
    struct sweep_output *output; /* [n] */
};

int sweep_outputs_create(struct sweep_outputs *o, int points);
void sweep_outputs_free(struct sweep_outputs *o);

/* Fills the values of point i from the tables of its run: of front, forces, beam and probes
 * what study/quantity.h tells, and of each object that water presses the peak of its force,
 * output/force.h.  More than SWEEP_OUTPUTS are left out. */
void sweep_outputs_read(struct sweep_outputs *o, int i, const struct member_home *h,
                        const struct member *m);

#endif
