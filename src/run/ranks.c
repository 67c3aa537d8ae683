/* ranks.c -- what differs when several processes share a run. */
#include "run/ranks.h"

#include "base/status.h"
#include "ranks/ranks.h"
#include "run/stop.h"

#include <string.h>

/* Methods whose decisions all follow from norms and from bounds of stability, or from a state that
 * each rank has in full. */
static const char *const tried[] = { "cks43", "mps" };

static bool is_tried(const char *method)
{
    bool found = false;

    for (size_t i = 0; i < sizeof tried / sizeof *tried; i++)
        found |= strcmp(method, tried[i]) == 0;
    return found;
}

static const char *lacks(const struct run *r)
{
    const struct settings_output *o = plan_output(r->plan);
    const char *of_plan = moment_share_lacks(r->plan);

    if (of_plan)
        return of_plan;
    if (strcmp(plan_precision(r->plan), "single") == 0)
        return "precision = \"single\"";
    if (!is_tried(r->method->name))
        return "another method than cks43 and mps";
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
