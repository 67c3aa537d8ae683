/* rates.h -- the whole right-hand side for a library that takes the steps: an
 * answer of finite numbers, or a reason. */
#ifndef TIME_RATES_H
#define TIME_RATES_H

#include "eval/moment.h"

struct rates {
    struct moment *moment;
    char refusal[320]; /* why the latest call had no answer, "" if it had one   */
};

/* f [size] = f(t, y).  STATUS_FAILED when the plan refuses or a rate is not
 * finite; the failure stays in `refusal` alone, as a shorter step may do. */
int rates_ask(struct rates *r, double t, const double *y, double *f);

#endif
