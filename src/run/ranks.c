/* ranks.c -- what differs when several processes share a run. */
#include "run/ranks.h"

#include "ranks/ranks.h"
#include "run/stop.h"

#include <string.h>

/* Methods that add up over y for themselves, or by a library that knows no ranks. */
static const char *const adding[] = { "bdf", "dv", "gsl-msadams", "pcisph" };

bool run_ranks_full(const struct run *r)
{
    for (size_t i = 0; i < sizeof adding / sizeof *adding; i++)
        if (strcmp(r->method->name, adding[i]) == 0)
            return true;
    return r->def.norm != VECTOR_NORM_MAX;
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
