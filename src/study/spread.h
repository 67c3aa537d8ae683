/* spread.h -- an error bar: runs of one scene that differ by next to nothing. */
#ifndef STUDY_SPREAD_H
#define STUDY_SPREAD_H

#include <stdbool.h>

struct spread_order {
    const char *scene;           /* path                                                 */
    int overrides;
    const char *const *override; /* [overrides] "KEY=VALUE"                              */
    const char *directory;       /* NULL: the scene's name without ".scene" + "-spread"  */
    int runs, seed;              /* run i starts with seed + i                           */
    double size;                 /* of the disturbance [spacings]                        */
    double share;                /* of the mean that a band may have                     */
    double window[2];            /* of peaks and means over time [s]; NAN: start, end    */
    int jobs, threads;           /* 0: 1                                                 */
    double budget;               /* [s] of the clock for a run; 0: any                   */
    bool quiet;
    bool force;                  /* a directory with files of others does not matter */
    const char *scripts;         /* directory with plots/spread-front.gp                 */
};

/* Runs what is not there yet as child processes `PROGRAM run', each into DIR/runs/NAME, and
 * leaves DIR/spread.csv, spread.json, spread.md, spread-TABLE.csv and figures.  Runs that fail
 * are left out, with a warning each; STATUS_FAILED when fewer than two are left.
 * STATUS_BAD_SCENE when the command line or the scene is wrong, STATUS_STOPPED when a signal
 * came: what is there stays, and the next one goes on. */
int spread_scene(const struct spread_order *order);

#endif
