/* rigid-clump-fill.h -- where the balls of a clump are that is made from a shape. */
#ifndef BODIES_RIGID_CLUMP_FILL_H
#define BODIES_RIGID_CLUMP_FILL_H

#include "bodies/rigid-form.h"

enum { RIGID_CLUMP_FILL_MOST = 2000 };

/* Adds centres of balls of d->radius that touch the surface of `outer`, what the shape d->of measures,
 * from inside, nearly d->pitch apart; in its own frame [m].  BAD_SCENE: they do not fit, or are more
 * than the most. */
int rigid_clump_fill(const struct rigid_def *d, const char *path, const struct rigid_figure *outer,
                     struct points *to);

/* Says that n are too many. */
int rigid_clump_fill_refuse(const char *path, double n);

#endif
