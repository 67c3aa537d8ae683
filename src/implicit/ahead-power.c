/* ahead-power.c -- what a pressure that looks ahead dissipates, (E3).
 *
 * Its power beside that of (E1) is, with x = rho'/rho and where P is that of the system,
 *
 *   -d/dt sum of m c0^2 tau^2 x^2/2  -  sum of m c0^2 tau x^2 (1 + tau x)
 *
 * The first comes back when the flow stops, the second does not. */
#include "implicit/ahead.h"

#include "space/record.h"

/* Solids in no list, and what has no pressure because it may pull nothing, decay by no law of
 * its own.  m c0^2 x^2 is (D v)^2/E. */
double ahead_power(const void *self)
{
    const struct ahead *a = self;
    const struct moment *m = a->m;
    double power = 0;

    for (int s = 0; s < a->listed; s++) {
        const double mass = m->particles->m[m->list->order[s]];
        const double rho = m->work->record[(size_t)s * RECORD + RECORD_RHO];
        const double *least = a->walls.least;
        const bool bound = a->bounded && (!least || least[s] == 0);
        if (bound && a->P[s] == 0)
            continue;
        power -= a->tau * a->rate[s] * a->rate[s] / a->left.still[s]
                 * (1 + a->tau * a->rate[s] / (mass * rho));
    }
    return power;
}
