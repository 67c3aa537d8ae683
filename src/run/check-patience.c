/* check-patience.c -- a check takes no more than some seconds and 1 GB, whatever the scene. */
#include "run/run.h"

#include "base/status.h"
#include "ranks/ranks.h"
#include "run/check-look.h"
#include "run/patience.h"
#include "run/ranks.h"
#include "state/memory.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* [s] for a look at all particles, on ranks by one of them before they all take it; for counting;
 * see sample.c for the rest of 5. */
static const double patience = 3, patience_of_ranks = 2.5, patience_to_count = 1;

static int refuse_to_count(const struct run_order *order)
{
    return status_fail_with(STATUS_BAD_SCENE, (struct status_advice){
        .cause = "The scene is very long, or a list of points or a file of triangles in it is",
        .remedy = "check it with fewer of them" },
        "%s: this scene cannot even be counted within %g s and 1 GB", order->scene, patience_to_count);
}

/* Children that print and end as this process would. */
static int look_in_child(const struct run_order *order, double program)
{
    int ended = patience_try(patience);

    if (ended == PATIENCE_BEGIN)
        return check_look(order, program);
    if (ended != PATIENCE_OVER)
        exit(ended); /* the child has said why */
    ended = patience_try(patience_to_count);
    if (ended == PATIENCE_BEGIN)
        return check_count(order, program);
    if (ended != PATIENCE_OVER)
        exit(ended);
    return refuse_to_count(order);
}

/* Can it be done?  The first rank tries, alone and in silence: a child of MPI's can neither print
 * nor end as its parent would. */
static bool try(const struct run_order *order, double program, double seconds,
                int (*work)(const struct run_order *, double))
{
    double over = 0;

    if (run_ranks_writes()) {
        const int ended = patience_try(seconds);
        if (ended == PATIENCE_BEGIN) {
            patience_is_all();
            if (freopen("/dev/null", "w", stdout))
                work(order, program);
            _exit(EXIT_SUCCESS);
        }
        over = ended == PATIENCE_OVER;
    }
    ranks_most(1, &over);
    return over == 0;
}

static int look_by_ranks(const struct run_order *order, double program)
{
    if (try(order, program, patience_of_ranks, check_look))
        return check_look(order, program);
    if (!try(order, program, patience_to_count, check_count))
        return refuse_to_count(order);
    return run_ranks_writes() ? check_count(order, program) : STATUS_DONE;
}

int run_check(const struct run_order *order)
{
    const double program = memory_peak();

    if (!run_ranks_writes() && !freopen("/dev/null", "w", stdout))
        return status_fail(STATUS_IO, "/dev/null cannot be written");
    return ranks_by_mpi() ? look_by_ranks(order, program) : look_in_child(order, program);
}
