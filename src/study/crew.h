/* crew.h -- carries out the runs of a study that are not there yet, side by side. */
#ifndef STUDY_CREW_H
#define STUDY_CREW_H

#include "study/member.h"

struct crew {
    const struct member_home *home;
    const char *what; /* for the progress line: "runs"                                   */
    int n, jobs;      /* runs; of them at a time, 0: 1                                   */
    double budget;    /* [s] of the clock for each; 0: any                               */
    bool quiet;       /* no progress line                                                */

    struct member *(*member)(void *self, int i); /* number i                             */
    char *(*settings)(void *self, int i); /* its own, as member_words() has them, which the
                                             caller gives away; NULL: no memory          */
    bool (*wanted)(void *self, int i); /* just before it would begin; NULL: all are      */
    void (*came)(void *self, int i);   /* it has ended, now or long ago; may be NULL     */
    int (*changed)(void *self);        /* after one or several of these; may be NULL     */
    void *self;
};

/* Runs the members that have a name.  A run that fails is no failure of the crew;
 * STATUS_STOPPED when a signal came. */
int crew_run(const struct crew *crew);

#endif
