/* constant.c -- the message of a run whose constant step has no answer. */
#include "time/constant.h"

#include "base/status.h"
#include <stdio.h>

/* Too long or not, beside the bound. */
static void weigh(double seconds, double bound, const struct limit *limit, char *text, size_t room)
{
    char particle[32] = "";

    if (limit->where >= 0)
        snprintf(particle, sizeof particle, ", particle %d", limit->where);
    if (seconds > bound)
        snprintf(text, room, "The step is longer than the plan's stability bound there, %.3g s "
                 "(%s%s)", bound, limit->part, particle);
    else
        snprintf(text, room, "The step is within the plan's stability bound there, but something "
                 "is faster than it");
}

int constant_fail(const char *name, double seconds, double t, const char *why, double bound,
                  const struct limit *limit)
{
    char cause[256], remedy[256];

    weigh(seconds, bound, limit, cause, sizeof cause);
    snprintf(remedy, sizeof remedy,
             "Try %s@%.2gs, or %s without a step, which then chooses its own", name,
             seconds > bound ? bound / 2 : seconds / 2, name);
    return status_fail_with(STATUS_FAILED, (struct status_advice){ cause, remedy },
                            "%s@%gs has no answer after its constant step from t = %.9g s: %s",
                            name, seconds, t, why[0] ? why : "the state is not finite");
}
