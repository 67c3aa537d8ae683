/* team.h -- how many threads a run has: as many as make it faster.
 *
 * Whether threads repay depends on how many particles there are, on how far apart the cores are and
 * on what else they do, and none of it is known before.  No bit of a run depends on its threads.
 * So now and then a run takes half or twice as many for some steps, and keeps more only if they are
 * faster by a tenth:
 *
 *     team_start(&team, most, false);
 *     loop: a step; threads = team_step(&team, seconds, passes);
 *
 * Nothing here reads a clock, so that it can be tested. */
#ifndef RUN_TEAM_H
#define RUN_TEAM_H

#include <stdbool.h>

enum { TEAM_TURNS = 3 }; /* windows of each number in a trial */

struct team {
    bool fixed;           /* there is no choice                                */
    int most, now;        /* threads that may be had, that have worked best    */
    int other;            /* those of a trial, 0: there is none                */
    int turn;             /* windows of the trial that are over                */
    int skip;             /* steps after a change that do not count            */
    double seconds;       /* of the window, or since the last trial            */
    long passes;          /* of the window                                     */
    double wait;          /* until the next trial                          [s] */
    bool up;              /* the next one is of more threads, if there are any */
    double took[2][TEAM_TURNS]; /* a pass over pairs, with `now` and `other` [s] */
    double worked, passed; /* threads times seconds, seconds of all steps      */
};

/* most: threads that may be had; fixed: all of them work. */
void team_start(struct team *t, int most, bool fixed);

/* A step took so many seconds and passes over pairs.  Returns the threads that the next one is to
 * have. */
int team_step(struct team *t, double seconds, long passes);

/* Threads that worked, in the mean over time. */
double team_mean(const struct team *t);

#endif
