/* settings-mps.h -- the group `mps` of a scene: how the method of that name computes.
 *
 * Words that begin with "bundle" leave a choice to the key `bundle`; what stands for it then
 * says settings_mps_complete(). */
#ifndef PLAN_SETTINGS_MPS_H
#define PLAN_SETTINGS_MPS_H

#include "base/param.h"

struct settings_mps {
    const char *bundle;      /* "standard", "enhanced" or "no-cheating"        */
    double re, re_gradient, re_laplacian; /* radii in spacings                 */
    double beta;             /* n < beta n0: a surface                         */
    const char *source;      /* "number-density", "hs", "ecs"                  */
    const char *hs_constant; /* "lattice", "published"                         */
    double gamma;            /* share of the deviation of n in a step          */
    double drift;            /* the same beside "hs"                           */
    const char *laplacian;   /* "standard", "hl"                               */
    const char *hl_constant; /* "lattice", "published"                         */
    const char *gradient;    /* "minimum", "cmps", "gc"                        */
    const char *clamp, *collisions, *ds; /* "on", "off"                        */
    double restitution, collision_distance; /* the latter in spacings          */
    double ds_distance;      /* in spacings                                    */
    double compressibility;  /* [1/Pa]                                         */
    double nu;               /* [m^2/s]                                        */
    double residual;         /* of the Poisson equation, in its source         */
    int iterations;          /* at most, of a solve                            */
    const char *preconditioner; /* "ic0", "multigrid"                          */
};
extern const struct param settings_mps_params[];

/* Puts what the bundle says in the place of every "bundle" and every NaN. */
void settings_mps_complete(struct settings_mps *s);

#endif
