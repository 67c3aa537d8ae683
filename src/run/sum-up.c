/* sum-up.c -- the last words of a run: where its results are and what came out. */
#include "run/inside.h"

#include "base/status.h"
#include "output/numbers.h"

#include <stdio.h>

static void print_warnings(void)
{
    for (int i = 0; status_warning(i); i++)
        printf("%s  %s\n", i == 0 ? "warnings:\n" : "", status_warning(i));
}

/* Where the run has come to fewer than it could have; trials of fewer are not worth a word. */
static void print_threads(const struct team *team)
{
    if (team->now < team->most)
        printf("threads: %.2g of %d in the mean, as more were hardly faster; --threads N takes N\n",
               team_mean(team), team->most);
}

void run_sum_up(const struct run *r, const struct run_order *order, int status)
{
    struct numbers n;

    if (order->quiet || status == STATUS_IO)
        return;
    numbers_read(&n, r->directory);
    printf("%s at t = %.6g s of %.6g s, %.3g s by the clock; results are in %s/\n",
           status == STATUS_DONE ? "done" : status == STATUS_STOPPED ? "stopped" : "failed",
           r->past.tally.t, r->until, run_clock() - r->clock_start, r->directory);
    numbers_print(&n, stdout);
    print_threads(&r->team);
    print_warnings();
    printf("next: stiffwater plot %s, or report for one page with all of it\n", r->directory);
    fflush(stdout);
}
