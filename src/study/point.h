/* point.h -- combinations of swept values, and what the scene is there. */
#ifndef STUDY_POINT_H
#define STUDY_POINT_H

#include "study/inside.h"

/* Fills s->sweeps, key, unit, values from the words of --sweep. */
int point_sweeps(struct study *s);

/* Makes s->point: reads the scene at each combination. */
int point_all(struct study *s);

/* What the point sets, a line "KEY=VALUE\n" each: free() it.  NULL: no memory. */
char *point_settings(const struct study *s, const struct point *p);

/* Sets finest and place of all points; refuses where no spacing is swept. */
int point_finest(struct study *s);

/* When positions are compared: `early' [s] as asked for, 0: after free fall by ten spacings,
 * sqrt(20 dx / g) -- early enough for particles to be told apart by their errors rather than
 * by chance.  Returns until / that, rounded up to a whole number from 1 to 999 (chosen: 50). */
int point_pieces(double until, double dx, double g, double early);

#endif
