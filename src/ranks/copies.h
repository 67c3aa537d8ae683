/* copies.h -- whole copies of one program, which a launcher of ranks has started. */
#ifndef RANKS_COPIES_H
#define RANKS_COPIES_H

#include "base/status.h"

/* Number of this copy by what the launcher says, from 0; 0 where there is no launcher. */
int ranks_copy(void);

/* STATUS_BAD_SCENE, with this advice, where a launcher says that there are several. */
int ranks_refuse_copies(struct status_advice advice);

#endif
