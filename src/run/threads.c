/* threads.c -- a run's threads: as many as the user says, or as make it faster (team.h). */
#include "run/inside.h"

#include "base/threads.h"
#include "ranks/ranks.h"

#include <stdlib.h>

static void take(int threads)
{
#ifdef _OPENMP
    omp_set_num_threads(threads);
#else
    (void)threads;
#endif
}

/* The user has said a number, or ranks wait for each other, so that no rank's clock tells. */
static bool settled(const struct run_order *order)
{
    return order->threads > 0 || getenv("OMP_NUM_THREADS") || ranks_count() > 1;
}

void run_threads_start(struct run *r, const struct run_order *order)
{
    team_start(&r->team, threads_most(), settled(order));
    r->passes = moment_counts(r->moment)->passes;
}

void run_threads_step(struct run *r, double seconds)
{
    const long passes = moment_counts(r->moment)->passes - r->passes;

    r->passes += passes;
    if (r->team.fixed)
        return;
    take(team_step(&r->team, seconds, passes));
}
