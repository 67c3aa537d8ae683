/* trials.h -- the runs of a comparison. */
#ifndef STUDY_TRIALS_H
#define STUDY_TRIALS_H

#include "study/inside.h"

/* Makes s->reference and s->trial from methods, tolerances, points and repeats. */
int trials_make(struct study *s);

#endif
