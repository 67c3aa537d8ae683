/* checkpoint.h -- the end of a segment at which a run is kept, so that `resume` goes on from
 * there with the same bits.
 *
 * The run that writes a checkpoint and the one that goes on from it both begin a new segment:
 * list, guesses and the method's past are made of (t, y) alone. */
#ifndef RUN_CHECKPOINT_H
#define RUN_CHECKPOINT_H

#include "run/inside.h"

/* Refuses so many checkpoints that no run would come to its end. */
int checkpoint_agree(const struct run *r);

/* The time at which a step has to end [s]; HUGE_VAL: none. */
double checkpoint_next(const struct run *r);

/* Is there to be one where the run stands? */
bool checkpoint_due(const struct run *r);

/* Keeps the run as it stands and begins a new segment.  What cannot be written is warned of:
 * the checkpoint before stays. */
int checkpoint_write(struct run *r);

/* What a checkpoint holds, into a run: y, t and counts before its method is created, which
 * refuses another scene, layout or method; the rest when its outputs are open. */
int checkpoint_load_state(struct run *r, struct archive *a);
int checkpoint_load_past(struct run *r, struct archive *a);

/* Before there is a plan: refuses what another version wrote or another scene.used; until
 * when that run was to go [s]. */
int checkpoint_check(const char *dir, struct archive *a, double *until);

#endif
