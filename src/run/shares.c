/* shares.c -- what each effect costs of a right-hand side, measured: with it and without it. */
#include "run/inside.h"

#include "base/status.h"
#include "ranks/ranks.h"
#include "run/patience.h"
#include "state/part.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 30000, LEAST_TIMES = 5, MOST_TIMES = 1000 };

static const double patience = 1.5; /* [s] of the clock for all effects */

/* Ranks ask equally often, and not where all that counts is whether there is an answer. */
static bool once_more(int n, double since)
{
    return !patience_asks() && (n < LEAST_TIMES || (ranks_count() == 1 && run_cpu() - since < 0.1));
}

int run_time_rhs(struct run *r, double *seconds)
{
    double *ydot = status_alloc(plan_size(r->plan), sizeof *ydot), start;
    int status = ydot ? STATUS_DONE : STATUS_FAILED, n = 0;

    *seconds = HUGE_VAL;
    if (ydot && moment_eval(r->moment, ASK_ALL, 0, r->y, ydot) != STATUS_DONE)
        status = status_fail(STATUS_FAILED, "the first right-hand side cannot answer: %s",
                             moment_refusal(r->moment));
    for (start = run_cpu(); status == STATUS_DONE && n < MOST_TIMES && once_more(n, start); n++) {
        const double before = run_cpu();
        moment_eval(r->moment, ASK_ALL, 0, r->y, ydot);
        *seconds = fmin(*seconds, run_cpu() - before);
    }
    free(ydot);
    return status;
}

/* Of the scene without an effect, at its start; false: it cannot be had so. */
static bool time_without(const struct run_order *order, const char *path, double *seconds)
{
    const char *override[order->overrides + 1];
    char off[200];
    struct run_order of = *order;
    struct run r = { 0 };
    bool fine;

    snprintf(off, sizeof off, "%s=off", path);
    memcpy(override, order->override, (size_t)order->overrides * sizeof *override);
    override[of.overrides++] = off;
    of.override = override;
    status_hush(true);
    fine = run_prepare(&r, &of) == STATUS_DONE;
    if (fine) {
        plan_start(r.plan, r.y);
        fine = run_time_rhs(&r, seconds) == STATUS_DONE;
    }
    run_release(&r);
    status_hush(false);
    status_clear();
    return fine;
}

static void print_share(const char *path, double whole, double without)
{
    const double share = 1 - without / whole;

    if (share < 0.02)
        printf("  %-32s   below 2 %%\n", path);
    else
        printf("  %-32s %3.0f %%\n", path, 100 * share);
}

void run_shares_print(struct run *r, const struct run_order *order, double whole)
{
    const double start = run_clock();
    const char *path;

    puts("shares of a right-hand side, measured: what it takes less without the effect");
    for (int i = 0; i < plan_parts(r->plan); i++) {
        double without;
        plan_part(r->plan, i, &path);
        if (strncmp(path, "effects.", 8) != 0)
            continue;
        if (plan_particles(r->plan)->n > MOST || run_clock() - start > patience)
            printf("  %-32s   not measured, that would take too long\n", path);
        else if (time_without(order, path, &without))
            print_share(path, whole, without);
        else
            printf("  %-32s   cannot be left out of this scene alone\n", path);
    }
}
