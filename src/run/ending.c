/* ending.c -- what a run says that ended early: what happened, why, and what to try. */
#include "run/inside.h"

#include "base/status.h"
#include "ranks/ranks.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A constant step is the choice of the user alone. */
static void doubt_step(const struct run *r)
{
    struct limit limit[2];
    char cause[160];
    double rate;

    if (!(r->def.seconds > 0) || status_has_cause())
        return;
    moment_limit(r->moment, r->past.tally.t, r->method->state(r->self), plan_stiff(r->plan), limit);
    rate = fmax(limit[0].rate, limit[1].rate);
    snprintf(cause, sizeof cause, "The constant step of %g s is %.3g times 1/(fastest rate) there; "
             "bounds of stability lie between 1 and 5", r->def.seconds, r->def.seconds * rate);
    status_advise((struct status_advice){ cause, "try a shorter step" });
}

/* What to try, unless the failure says it. */
static void advise(const struct run *r)
{
    if (status_has_remedy())
        return;
    status_advise((struct status_advice){
        .remedy = r->past.tally.steps == 0
            ? "That is the start itself: try a higher eos.c0 or wider eos.lowest and eos.highest, "
              "or look at what the scene starts with"
            : "Things to try: shorter steps (a smaller tol or CFL number), a higher eos.c0, more "
              "viscosity or density diffusion, a smaller spacing" });
}

void run_explain(const struct run *r, int status, char *message)
{
    char why[RUN_MESSAGE / 3] = "";
    const bool calculated = status == STATUS_FAILED && !status_is_starved()
                            && ranks_count() == 1;

    if (calculated) {
        doubt_step(r);
        advise(r);
    }
    snprintf(message, RUN_MESSAGE, "%.*s", RUN_MESSAGE / 2, status_message());
    if (calculated)
        observe_blame(r->moment, r->past.tally.t, r->method->state(r->self), why, sizeof why);
    if (why[0])
        snprintf(message + strlen(message), RUN_MESSAGE - strlen(message), ". Cause: %s", why);
}
