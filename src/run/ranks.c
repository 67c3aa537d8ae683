/* ranks.c -- what differs when several processes share a run. */
#include "run/ranks.h"

#include "base/status.h"
#include "ranks/ranks.h"
#include "run/stop.h"

#include <string.h>

/* Methods that sum over all of y for themselves, or by a library that knows no ranks. */
static const char *const untried[] = { "bdf", "dv", "gsl-msadams", "pcisph" };

static const char *method_lacks(const char *method)
{
    for (size_t i = 0; i < sizeof untried / sizeof *untried; i++)
        if (strcmp(method, untried[i]) == 0)
            return untried[i];
    return NULL;
}

static const char *lacks(const struct run *r, const char **method)
{
    const char *of_plan = moment_share_lacks(r->plan);

    *method = of_plan ? NULL : method_lacks(r->method->name);
    if (of_plan || *method)
        return of_plan ? of_plan : "the method ";
    return r->def.norm != VECTOR_NORM_MAX ? "another norm than \"max\"" : NULL;
}

int run_ranks_agree(const struct run *r)
{
    const char *method = NULL, *what = ranks_count() > 1 ? lacks(r, &method) : NULL;

    if (!what)
        return STATUS_DONE;
    return status_fail_with(STATUS_BAD_SCENE, (struct status_advice){
        .remedy = "run it on one rank, with as many threads as the machine has" },
        "%s: %d ranks cannot share %s%s yet", r->path, ranks_count(), what, method ? method : "");
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
