/* compare.h -- many runs of one scene: methods x tolerances x swept keys. */
#ifndef STUDY_COMPARE_H
#define STUDY_COMPARE_H

#include <stdbool.h>

enum { COMPARE_SWEEPS = 4 };

struct compare_order {
    const char *scene;           /* path                                                  */
    int overrides;
    const char *const *override; /* [overrides] "KEY=VALUE"                               */
    const char *directory;       /* NULL: the scene's name without ".scene" + "-compare"  */
    const char *methods, *tols;  /* "a,b@CFL,..." and "x,y,..."                           */
    int sweeps;
    const char *const *sweep;    /* [sweeps] "KEY=v1,v2,..."                              */
    const char *reference;       /* "METHOD:TOL"; NULL: chosen                            */
    double early;                /* [s] when positions are compared; 0: chosen            */
    bool growth;                 /* follow a tiny disturbance too                         */
    int repeat, jobs, threads;   /* 0: 1                                                  */
    double budget;               /* [s] of the clock for a run; 0: any                    */
    bool quiet;
    bool force;                  /* a directory with files of others does not matter */
    const char *scripts;         /* directory with plots/work-precision.gp                */
    const char *(*unit)(const char *key); /* of a key of scenes; NULL: none is known      */
};

/* Runs what is not there yet as child processes `PROGRAM run', each into DIR/runs/NAME, and
 * leaves DIR/compare.csv, compare.json, compare.md and figures.  Runs that fail are rows, not
 * failures of the comparison.  STATUS_BAD_SCENE when the command line or the scene is wrong,
 * STATUS_STOPPED when a signal came: what is there stays, and the next one goes on. */
int compare_scene(const struct compare_order *order);

#endif
