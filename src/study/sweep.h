/* sweep.h -- runs of one scene over values of its keys: what comes out, against what was put in. */
#ifndef STUDY_SWEEP_H
#define STUDY_SWEEP_H

#include <stdbool.h>

struct sweep_order {
    const char *scene;       /* path                                                      */
    int words;
    const char *const *word; /* [words] "KEY=V1,V2,...", swept, or "KEY=VALUE", set       */
    const char *directory;   /* NULL: the scene's name without ".scene" and "-sweep"      */
    int jobs, threads;       /* 0: 1                                                      */
    double budget;           /* [s] of the clock for a run; 0: any                        */
    bool quiet;
    bool force;              /* a directory with files of others does not matter */
    const char *scripts;     /* directory with plots/sweep.gp                             */
    const char *(*unit)(const char *key); /* of a key of scenes; NULL: none is known      */
};

/* Runs what is not there yet, by the scene's own method, each into DIR/runs/NAME, and leaves
 * DIR/sweep.csv, sweep.md and figures.  Runs that fail are rows.  STATUS_BAD_SCENE when the
 * command line or the scene is wrong at any point, STATUS_STOPPED when a signal came. */
int sweep_scene(const struct sweep_order *order);

#endif
