/* solid-wall.h -- a wall as contacts see it: a rigid body of its shape that never gives way. */
#ifndef BODIES_SOLID_WALL_H
#define BODIES_SOLID_WALL_H

#include "bodies/rigid-form.h"
#include "bodies/solid.h"

struct shape;

struct solid_wall { /* zeroed: none */
    struct rigid_figure figure;
    struct core *core;        /* [cores] convex ones that make it */
    int cores;
    struct solid_place start; /* of all of them at t = 0          */
};

/* How many cores it has at most; 0: a frame, whose sides are solids of their own. */
int solid_wall_most(const struct shape *s);

/* Rounds its edges by `margin` [m], or by half of it where it is thinner.  The caller frees
 * *out, also after a failure. */
int solid_wall_make(const struct shape *s, const char *path, double margin, struct solid_wall *out);
void solid_wall_free(struct solid_wall *w);

/* The solid of core i; path is lent. */
void solid_wall_facts(const struct solid_wall *w, int i, const char *path, struct solid *out);

#endif
