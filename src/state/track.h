/* track.h -- a smooth curve through pairs of a time and a value, at rest before the
 * first and after the last. */
#ifndef STATE_TRACK_H
#define STATE_TRACK_H

#include "base/param.h"

struct track;

/* NULL for no pairs.  BAD_SCENE when times do not grow or there is one pair only;
 * `key` is "wall.NAME.path". */
int track_create(const struct param_points *pairs, const char *key, const char *where,
                 struct track **out);
void track_free(struct track **track); /* NULL is welcome */

/* Value at time t and its first two derivatives; 0 for NULL.  Between pairs: cubics
 * that have no extremes of their own, Steffen, Astron. Astrophys. 239 (1990) 443. */
void track_at(const struct track *track, double t, double *value, double *rate, double *second);

/* The first of start + its times that is after t, where the second derivative may jump;
 * HUGE_VAL: none, or NULL. */
double track_next(const struct track *track, double start, double t);

/* Its ends [s], where the rate jumps. */
double track_first(const struct track *track);
double track_last(const struct track *track);

#endif
