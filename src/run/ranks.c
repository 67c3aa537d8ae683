/* ranks.c -- what differs when several processes share a run. */
#include "run/ranks.h"

#include "base/status.h"
#include "eval/balance.h"
#include "plan/solver.h"
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

/* A pressure that is solved for is found by each rank for itself, from all of y. */
void run_ranks_begin(struct run *r)
{
    const bool whole = plan_solved(r->method->name) != NULL;

    if (ranks_count() == 1)
        return;
    if (whole || r->method->rearrange(r->self, 0, NULL) != STATUS_DONE)
        balance_never(r->moment);
    status_clear();
}

int run_ranks_balance(struct run *r)
{
    struct vector_rows row[MOMENT_ROWS];
    int blocks;

    TRY(balance_cut(r->moment, row, &blocks));
    if (blocks == 0)
        return STATUS_DONE;
    TRY(ranks_agree(r->method->rearrange(r->self, blocks, row)));
    return balance_carry_out(r->moment);
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
