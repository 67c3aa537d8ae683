/* ranks.c -- what differs when several processes share a run. */
#include "run/ranks.h"

#include "base/status.h"
#include "ranks/ranks.h"
#include "run/stop.h"

#include <string.h>

/* The method whose decisions all follow from norms and from bounds of stability. */
static const char tried[] = "cks43";

static const char *lacks(const struct run *r)
{
    const struct settings_output *o = plan_output(r->plan);
    const char *of_plan = moment_share_lacks(r->plan);

    if (of_plan)
        return of_plan;
    if (strcmp(plan_precision(r->plan), "single") == 0)
        return "precision = \"single\"";
    if (strcmp(r->method->name, tried) != 0)
        return "another method than cks43";
    if (r->def.norm != VECTOR_NORM_MAX)
        return "another norm than \"max\"";
    return o->checkpoint > 0 || o->checkpoint_minutes > 0 ? "checkpoints" : NULL;
}

int run_ranks_agree(const struct run *r)
{
    const char *what = ranks_count() > 1 ? lacks(r) : NULL;

    if (!what)
        return STATUS_DONE;
    return status_fail_with(STATUS_BAD_SCENE, (struct status_advice){
        .remedy = "run it on one rank, with as many threads as the machine has" },
        "%s: %d ranks cannot share %s yet", r->path, ranks_count(), what);
}

bool run_ranks_writes(void)
{
    return ranks_me() == 0;
}

int run_ranks_stopped(void)
{
    double most = stop_asked();

    ranks_most(1, &most);
    return (int)most;
}
