/* trial.h -- one run of a comparison: its command line, whether it is there already. */
#ifndef STUDY_TRIAL_H
#define STUDY_TRIAL_H

#include "study/inside.h"

#define TRIAL_DISTURBANCE 1e-6 /* [rad] that gravity is tilted by */

/* What the run's child is called with, NULL-ended; the texts live in one piece of memory
 * behind the array: free() it.  NULL: no memory. */
char **trial_words(const struct study *s, const struct trial *t);

/* Takes over the run if DIR/runs/NAME holds one that ended with the same order. */
bool trial_reuse(const struct study *s, struct trial *t);

/* Writes down how it ended, for trial_reuse(), and reads what it left. */
int trial_end(const struct study *s, struct trial *t);

/* "done", "failed", "stopped" or "refused" */
const char *trial_status(const struct trial *t);

/* "DIR/runs/NAME/FILE" into to [INSIDE_PATH] */
void trial_path(const struct study *s, const struct trial *t, const char *file, char *to);

#endif
