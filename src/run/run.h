/* run.h -- one run of one scene, from reading it to its last file. */
#ifndef RUN_RUN_H
#define RUN_RUN_H

#include <stdbool.h>

struct run_order {
    const char *scene;           /* path                                      */
    int overrides;
    const char *const *override; /* [overrides] "KEY=VALUE"                   */
    const char *directory;       /* NULL: the scene's name without ".scene"   */
    int threads;                 /* 0: as the environment says                */
    bool quiet;
    bool force;                  /* takes a directory with files of others */
};

/* Simulates.  Returns the exit status; the message is in status_message(). */
int run_scene(const struct run_order *order);

/* Goes on from the checkpoint in order->directory; the scene is that which was used there.  Its
 * only setting is until=T. */
int run_resume(const struct run_order *order);

/* Prints the plan, sizes and expected cost; simulates and writes nothing. */
int run_check(const struct run_order *order);

#endif
