/* sample.c -- what a run would cost.
 *
 * Of one that is too large for a look at all its particles it is measured with a larger spacing,
 * of which a right-hand side has as much to do for each particle, and the fastest wave the same
 * speed. */
#include "run/inside.h"

#include "base/status.h"
#include "run/patience.h"
#include "run/ranks.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST = 20000, COARSEST = 64 };

static const double patience = 1; /* [s] */

/* With the default methods a second takes 1.5 right-hand sides in units of the fastest wave's rate
 * while the flow is smooth (floating-box, sloshing-tank: 1.48, 1.51), 2.1 to 2.4 in toth-beam and
 * dam-break-3d, and 3.4 in dam-break.  Vector operations, outputs and new lists add 0.2 of their
 * time (floating-box, toth-beam) to 0.9 (dam-break), in 3D 0.8. */
void run_cost_print(double until, double rate, double seconds)
{
    const double few = 1.5 * until * rate, many = 3.4 * until * rate;
    const double least = DIM == 2 ? 1.2 : 1.8, most = DIM == 2 ? 1.8 : 2;

    printf("expected for %g s: %.0f right-hand sides (smooth flow) to %.0f (violent) of %.3g ms, "
           "%.3g to %.3g CPU s", until, few, many, 1e3 * seconds, least * few * seconds, most * many * seconds);
}

/* The scene at so many spacings; false: its sizes do not fit them, or it cannot answer. */
static bool look(const struct run_order *order, const struct plan_survey *s, int coarser)
{
    const char *override[order->overrides + 1];
    char spacing[64];
    struct run_order of = *order;
    struct run r = { 0 };
    struct limit limit[2];
    double seconds;
    bool fine;

    snprintf(spacing, sizeof spacing, "spacing=%.15g", coarser * s->dx);
    memcpy(override, order->override, (size_t)order->overrides * sizeof *override);
    override[of.overrides++] = spacing;
    of.override = override;
    fine = run_prepare(&r, &of) == STATUS_DONE;
    if (fine) {
        plan_start(r.plan, r.y);
        fine = run_time_rhs(&r, &seconds) == STATUS_DONE;
    }
    if (fine) {
        patience_done();
        const double n = plan_particles(r.plan)->n, all = s->fluid + s->solid;
        moment_limit(r.moment, 0, r.y, false, limit);
        run_cost_print(r.until, coarser * limit[0].rate, seconds * all / n);
        printf(",\n  from %.0f particles at a spacing of %g m, whose right-hand sides take %.3g ms\n", n,
               coarser * s->dx, 1e3 * seconds);
        fine = run_disk_print(&r, all, s->dx) == STATUS_DONE;
    }
    run_release(&r);
    return fine;
}

/* The finest of them that has few particles. */
static void find(const struct run_order *order, const struct plan_survey *s)
{
    const double most = pow((s->fluid + s->solid) / MOST, 1.0 / DIM);

    for (int coarser = (int)fmax(2, ceil(most)); coarser <= COARSEST; coarser++) {
        status_clear();
        if (look(order, s, coarser))
            return;
    }
}

void run_sample_print(const struct run_order *order, const struct plan_survey *s)
{
    const pid_t me = getpid();

    if (!run_ranks_writes() || patience_try(patience) != PATIENCE_BEGIN)
        return;
    status_hush(true);
    find(order, s);
    fflush(stdout);
    if (getpid() != me)
        _exit(EXIT_SUCCESS);
    patience_done();
    status_hush(false);
    status_clear();
}
