/* water.h -- a box full of moving water between walls, as a plan from a scene. */
#ifndef BENCH_WATER_H
#define BENCH_WATER_H

#include "plan/observe.h"

struct water {
    struct scene *scene;
    struct plan *plan;
    long size;       /* of y                                                  */
    int fluid, all;  /* particles of fluid; and of walls                      */
    double *y[2];    /* two moments between which the list must be rebuilt    */
    double *ydot;
    double share;    /* of right-hand sides that rebuild it                   */
    double due;      /* rebuilds due by now                                   */
    int now;         /* which y is at hand                                    */
};

/* The plan all benchmarks time.  Continuity, pressure, artificial viscosity
 * (alpha 0.02) and density diffusion (0.1), Wendland C2, gravity, Tait; about n
 * particles of fluid fill a closed unit square (cube), jittered by up to 0.15
 * dx, in a swirl of 1 m/s; frame of walls around, as thick as the support
 * [spacings]; skin [support].  `more` is put into the scene (NULL: nothing), and
 * `width` is the part of the box that is filled. */
void water_make(struct water *w, int n, double support, double skin, double width,
                const char *more);
void water_free(struct water *w);

/* One right-hand side; every 1/share-th rebuilds the list. */
void water_rates(void *water);

#endif
