/* ahead-guess.c -- what a pressure that looks ahead will be, from what it was: the straight line
 * through the last two solves, of the run's own moment.
 *
 * So P is a function of (t, y) up to the residual of its solve, and the guess is the caller's:
 * moment_restart() forgets it, outputs, which look at other times, neither use nor change it.
 * By id, so that a change of rows changes nothing. */
#include "implicit/ahead.h"

#include "space/record.h"

#include <math.h>
#include <string.h>

void ahead_forget(void *self)
{
    struct ahead *a = self;

    a->past.n = 0;
}

/* Where the line is, in units of its nodes' distance behind the last; not far from it. */
static double reach(const struct ahead *a, double t)
{
    const double apart = a->past.t[0] - a->past.t[1];

    return a->past.n == 2 ? fmax(-1, fmin(1, (t - a->past.t[0]) / apart)) : 0;
}

void ahead_guess(struct ahead *a, double t)
{
    const struct list *l = a->m->list;
    const double w = reach(a, t);

    memset(a->P, 0, (size_t)a->n * sizeof *a->P);
    for (int s = 0; s < a->listed; s++) {
        const int id = particles_id_of(a->m->particles, l->order[s]);
        if (a->past.n == 0 || a->m->beside)
            a->P[s] = a->m->work->record[(size_t)s * RECORD + RECORD_P2];
        else
            a->P[s] = a->past.P[0][id] + w * (a->past.P[0][id] - a->past.P[1][id]);
        if (a->bounded)
            a->P[s] = fmax(a->walls.least ? a->walls.least[s] : 0, a->P[s]);
    }
}

/* A new node, unless the last one has the same time: then that. */
void ahead_keep(struct ahead *a, double t)
{
    if (a->m->beside)
        return;
    if (a->past.n > 0 && t != a->past.t[0]) {
        double *const newest = a->past.P[1];
        a->past.P[1] = a->past.P[0];
        a->past.P[0] = newest;
        a->past.t[1] = a->past.t[0];
        a->past.n = 2;
    }
    a->past.n = a->past.n > 0 ? a->past.n : 1;
    a->past.t[0] = t;
    for (int s = 0; s < a->listed; s++)
        a->past.P[0][particles_id_of(a->m->particles, a->m->list->order[s])] = a->P[s];
}
