/* checks.h -- the scene at all points, whatever the method. */
#ifndef STUDY_CHECKS_H
#define STUDY_CHECKS_H

#include "study/inside.h"

/* `PROGRAM check' of the scene at each point, before anything runs: a mistake is not to be found
 * behind an hour of other runs.  STATUS_BAD_SCENE with what is wrong at the first such point. */
int checks_run(struct study *s);

#endif
