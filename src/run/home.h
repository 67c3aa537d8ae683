/* home.h -- a run takes its directory (output/mark.h).
 *
 * Files of an earlier run are taken away first, so that no series mixes two runs.  Files with
 * other names stay. */
#ifndef RUN_HOME_H
#define RUN_HOME_H

#include <stdbool.h>

struct home {
    const char *dir, *scene; /* its scene's path                                  */
    bool force;              /* files that are no run's do not matter             */
    bool again;              /* the run goes on: nothing is taken away            */
};

/* STATUS_IO, and nothing has changed: there are files and no run's mark, or links with names of
 * a run's files.  force: such files stay, unless they have names of a run's files. */
int home_take(const struct home *h);

#endif
