/* trial.h -- one run of a comparison. */
#ifndef STUDY_TRIAL_H
#define STUDY_TRIAL_H

#include "study/inside.h"

#define TRIAL_DISTURBANCE 1e-6 /* [rad] that gravity is tilted by */

/* What it sets, as struct crew wants it: free() it.  NULL: no memory. */
char *trial_settings(const struct study *s, const struct trial *t);

/* Reads what a run that has ended left. */
void trial_read(const struct study *s, struct trial *t);

/* "DIR/runs/NAME/FILE" into to [MEMBER_PATH] */
void trial_path(const struct study *s, const struct trial *t, const char *file, char *to);

#endif
