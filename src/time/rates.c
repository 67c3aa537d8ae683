/* rates.c -- asks the plan for the whole right-hand side. */
#include "time/rates.h"

#include "algebra/vector.h"
#include "base/status.h"
#include <stdio.h>

static int refuse(struct rates *r, const char *before, const char *why, const char *after)
{
    snprintf(r->refusal, sizeof r->refusal, "%s%.250s%s", before, why, after);
    status_clear();
    return STATUS_FAILED;
}

int rates_ask(struct rates *r, double t, const double *y, double *f)
{
    const struct vector_own own = moment_own(r->moment);
    const long n = moment_size(r->moment);
    long bad;

    if (moment_eval(r->moment, ASK_ALL, t, y, f) != STATUS_DONE) {
        const char *said = status_message(); /* of memory */
        return refuse(r, "", said[0] ? said : moment_refusal(r->moment), "");
    }
    bad = vector_bad_anywhere(n, f, &own);
    if (bad >= 0)
        return refuse(r, "the rate of ", moment_entry(r->moment, bad), " is not finite");
    r->refusal[0] = '\0';
    return STATUS_DONE;
}
