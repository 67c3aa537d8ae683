/* watch.c -- what a run looks at after each step: extremes of the fluid, bodies that bend too far
 * or meet, particles that run away. */
#include "run/inside.h"

#include "base/status.h"

#include <math.h>

static double square(const double *u)
{
    double squares = 0;

    for (int d = 0; d < DIM; d++)
        squares += u[d] * u[d];
    return squares;
}

void run_keep_extremes(struct run *r, double t, const double *y)
{
    struct run_tally *tally = &r->past.tally;
    double low = tally->density[0], high = tally->density[1], most = 0;
    struct view v;
    int n;

    observe_own(r->moment, t, y, &v);
    n = v.rho[KIND_FLUID] ? particles_count(v.p, KIND_FLUID) - v.others : 0;
    for (int i = 0; i < n; i++) {
        const double rho = v.rho[KIND_FLUID][i], u2 = square(v.u[KIND_FLUID] + DIM * i);
        low = rho < low ? rho : low;
        high = rho > high ? rho : high;
        most = u2 > most ? u2 : most;
    }
    double all[] = { -low, high, most };

    moment_most(r->moment, 3, all);
    tally->density[0] = -all[0];
    tally->density[1] = all[1];
    r->fastest = sqrt(all[2]); /* of the largest: a root grows with its square */
    tally->speed = fmax(tally->speed, r->fastest);
}

int run_watch(struct run *r, double t, const double *y)
{
    char doubt[300];

    for (int i = 0; i < plan_bodies(r->plan); i++) {
        TRY(observe_judge(r->moment, i, t, y, doubt, sizeof doubt));
        if (!doubt[0] || r->past.tally.doubted[i])
            continue;
        status_warn("%s", doubt);
        r->past.tally.doubted[i] = 1;
    }
    TRY(observe_meeting(r->moment, t, y));
    return observe_may_run_away(r->moment, r->fastest) ? observe_runaway(r->moment, t, y) : STATUS_DONE;
}
