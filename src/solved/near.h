/* near.h -- particles by place, and for each the places near it: what methods that solve for
 * pressures walk over, without lanes.
 *
 * Places are those of a pair list: fluid first, then solids, [n] particles; then images beside
 * periodic sides, [places] with these.  Neighbours come in the list's order, which knows
 * places alone: no bit depends on lanes, threads or rows. */
#ifndef SOLVED_NEAR_H
#define SOLVED_NEAR_H

#include "space/list.h"
#include "state/particles.h"

struct near {
    int n, fluid, places;
    int *origin;       /* [places] the particle's place; an image's original     */
    double (*x)[DIM];  /* [places] where it stands                       [m]     */
    double (*u)[DIM];  /* [n] velocity                                   [m/s]   */
    size_t *from;      /* [n+1] into place                                       */
    int *place;        /* neighbours of all kinds                                */
    size_t room;       /* of place                                               */
    int room_places;
};

/* Reads places and velocities of a list that was updated with this view, and neighbours
 * nearer than `reach` [m].  STATUS_FAILED: no memory. */
int near_make(struct near *s, const struct list *l, const struct view *v, double reach);
void near_free(struct near *s);

/* After x of particles changed: places of images. */
void near_images(struct near *s, const struct list *l);

/* Square of the distance from i to j, and the way there, to [DIM]. */
static inline double near_step(const struct near *s, int i, int j, double *to)
{
    double square = 0;

    for (int d = 0; d < DIM; d++) {
        to[d] = s->x[j][d] - s->x[i][d];
        square += to[d] * to[d];
    }
    return square;
}

#endif
