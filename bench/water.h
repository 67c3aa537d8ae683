/* water.h -- a box full of moving water, as a plan from a scene. */
#ifndef BENCH_WATER_H
#define BENCH_WATER_H

#include "eval/observe.h"

#include <stdbool.h>

struct water {
    struct scene *scene;
    const struct plan *plan;
    struct moment *moment;
    long size;       /* of y                                                  */
    int fluid, all;  /* particles of fluid; and of walls                      */
    double *y[2];    /* two moments between which the list must be rebuilt    */
    double *ydot;
    double share;    /* of right-hand sides that rebuild it                   */
    double due;      /* rebuilds due by now                                   */
    int now;         /* which y is at hand                                    */
};

struct water_def {
    int n;                /* particles of fluid, about                        */
    double support, margin; /* [spacings]; Verlet margin [support]              */
    double width;         /* part of the box that is filled; 0: all           */
    bool alone;           /* no walls, no gravity                             */
    bool endless;         /* alone, and all directions repeat                 */
    bool single;          /* pairs in single precision                        */
    const char *more;     /* put into the scene (NULL: nothing)               */
};

/* The plan all benchmarks time.  Continuity, pressure, artificial viscosity
 * (alpha 0.02) and density diffusion (0.1), Wendland C2, Tait; fluid fills a unit
 * square (cube), jittered by up to 0.15 dx, in a swirl of 1 m/s, under gravity, with
 * a frame of walls around that is as thick as the support. */
void water_make(struct water *w, const struct water_def *def);
void water_free(struct water *w);

/* One right-hand side; every 1/share-th rebuilds the list. */
void water_rates(void *water);

#endif
