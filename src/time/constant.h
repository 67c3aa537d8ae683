/* constant.h -- steps of one length, NAME@1e-4s: what the families of methods share.
 *
 * Such a step is what was asked for: only t_stop shortens it, no error and no bound
 * of stability does.  A run that ends in it hears how long it was beside the bound. */
#ifndef TIME_CONSTANT_H
#define TIME_CONSTANT_H

#include "state/limit.h"
#include "time/method.h"

#define CONSTANT_PART "constant step" /* what limited it, in tables of steps */

/* What rounding leaves between the end of many steps and t_stop, in steps: the last one
 * takes it along. */
#define CONSTANT_SLACK 1e-6

/* STATUS_FAILED with a message: no answer after a step from t.  `why` may be "";
 * `bound` [s] is the longest stable step there, set by `limit`; HUGE_VAL: none. */
int constant_fail(const char *name, double seconds, double t, const char *why, double bound,
                  const struct limit *limit);

#endif
