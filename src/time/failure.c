/* failure.c -- failures that the families of methods have in common, with their remedies. */
#include "time/failure.h"

#include "base/status.h"

int failure_start(const char *name, double t, const char *refusal)
{
    return status_fail_with(STATUS_FAILED,
                            (struct status_advice){
                                .remedy = "look for particles that overlap or start outside the "
                                          "domain, or try a higher eos.c0 or wider eos.lowest "
                                          "and eos.highest" },
                            "%s cannot start at t = %.9g s: the right-hand side has no answer "
                            "there (%s)", name, t, refusal);
}

int failure_not_finite(const char *name, double t, const char *entry)
{
    return status_fail_with(STATUS_FAILED,
                            (struct status_advice){
                                .cause = "this is a bug",
                                .remedy = "please report it with the scene" },
                            "%s accepted a step to t = %.9g s after which %s is not finite", name,
                            t, entry);
}

int failure_memory(const char *name, long n)
{
    return status_starved("%s needs many vectors of %ld numbers", name, n);
}
