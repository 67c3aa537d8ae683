/* alone.h -- scenes that hold bodies and nothing else that moves. */
#ifndef TIME_ALONE_H
#define TIME_ALONE_H

#include "plan/plan.h"
#include <stdbool.h>

/* Do all entries of y but quadratures belong to the stiff side? */
bool alone_bodies(const struct plan *plan);

#endif
