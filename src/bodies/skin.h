/* skin.h -- where the points that the water meets stand beside a beam.
 *
 * Rows along the axis at (j + 1/2) spacings, the spacing fitted to the length; layers
 * centred on the axis.  Points go row by row. */
#ifndef BODIES_SKIN_H
#define BODIES_SKIN_H

#include "space/kinds.h"
#include <stdbool.h>

struct skin_def {
    double at[DIM], along[DIM], normal[DIM]; /* root [m]; axis, the same turned by +90 degrees */
    double length;                           /* [m]                          */
    double spacing;                          /* dx; 0: no points      [m]    */
    int elements, layers;
};

/* Refuses (BAD_SCENE) more points than a skin may have, of a body called `path', before they
 * are made. */
int skin_check(double points, const char *path);
double skin_size(const struct skin_def *d); /* about as many as skin_points() says */

int skin_points(const struct skin_def *d);

/* Point i: s along the axis from the root, eta beside it [m]. */
void skin_site(const struct skin_def *d, int i, double *s, double *eta);

/* Is point i so near to an end that is held that it may turn into what holds the beam: no
 * further along the axis than half the width of the skin and a spacing? */
bool skin_held(const struct skin_def *d, bool root, bool tip, int i);

#endif
