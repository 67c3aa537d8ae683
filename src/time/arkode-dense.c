/* arkode-dense.c -- y inside the last step.
 *
 * Entries that are not stiff: the Hermite interpolant of the last step's ends
 * (error h^4), or of the last two steps' for methods of order 5 and more (h^6).
 * f at the newest end is the next step's first stage, taken early and handed to
 * it, so dense output costs nothing and does not change a later bit.
 *
 * Stiff entries: there f holds small errors times large frequencies, so the
 * Lagrange interpolant of up to four ends of steps is taken (error h^4). */
#include "time/arkode.h"

#include "base/status.h"
#include "time/dense.h"
#include <math.h>
#include <string.h>

void arkode_remember(struct arkode *a)
{
    const double *y = vector_inside(a->node[0].y);
    double *to = a->stiff.past[ARKODE_PAST - 1];

    if (a->stiff.entries == 0)
        return;
    for (int k = ARKODE_PAST - 1; k > 0; k--) {
        a->stiff.past[k] = a->stiff.past[k - 1];
        a->stiff.past_t[k] = a->stiff.past_t[k - 1];
    }
    a->stiff.past[0] = to;
    a->stiff.past_t[0] = a->node[0].t;
    a->stiff.pasts += a->stiff.pasts < ARKODE_PAST;
    for (int k = 0; k < a->stiff.ranges; k++) {
        const long size = a->stiff.range[k][1] - a->stiff.range[k][0];
        memcpy(to, y + a->stiff.range[k][0], (size_t)size * sizeof *to);
        to += size;
    }
}

static void stiff_at(const struct arkode *a, double t, double *y)
{
    const int nodes = dense_nodes(a->stiff.pasts, a->stiff.past_t);
    double weight[ARKODE_PAST];
    long j = 0;

    dense_lagrange(nodes, a->stiff.past_t, t, weight);
    for (int k = 0; k < a->stiff.ranges; k++)
        for (long i = a->stiff.range[k][0]; i < a->stiff.range[k][1]; i++, j++) {
            y[i] = 0;
            for (int m = 0; m < nodes; m++)
                y[i] += weight[m] * a->stiff.past[m][j];
        }
}

/* A straight line: only when f refuses at the newest end, and the run is to fail. */
static void line_at(const struct arkode *a, double s, double *y)
{
    const double c[2] = { s, 1 - s };
    const double *const x[2] = { vector_read(a->node[0].y), vector_read(a->node[1].y) };

    moment_combine(a->moment, 2, c, x, y);
}

/* False when rates are missing. */
static bool hermite_at(const struct arkode *a, double t, double *y)
{
    double time[ARKODE_NODES], c[2 * ARKODE_NODES];
    const double *x[2 * ARKODE_NODES];
    int known = 0, nodes;

    for (; known < a->known && a->node[known].has_f; known++)
        time[known] = a->node[known].t;
    if (known < 2)
        return false;
    nodes = dense_nodes(known, time);
    dense_hermite(nodes, time, t, c, c + nodes);
    for (int k = 0; k < nodes; k++) {
        x[k] = vector_read(a->node[k].y);
        x[nodes + k] = vector_read(a->node[k].f);
    }
    moment_combine(a->moment, 2 * nodes, c, x, y);
    return true;
}

int arkode_at(void *self, double t, double *y)
{
    struct arkode *a = self;
    const struct arkode_node *now = &a->node[0], *old = &a->node[1];

    if (t == now->t || (a->known > 1 && t == old->t)) {
        moment_take(a->moment, vector_read(t == now->t ? now->y : old->y), y);
        return STATUS_DONE;
    }
    if (a->known < 2 || !(t > old->t && t < now->t))
        return status_fail(STATUS_FAILED, "the state at t = %.9g s was asked for, which does not "
                                          "lie in the last step (to %.9g s)", t, now->t);
    if (arkode_rates(a) != STATUS_DONE || !hermite_at(a, t, y))
        line_at(a, (t - old->t) / (now->t - old->t), y);
    if (a->stiff.entries > 0)
        stiff_at(a, t, y);
    return STATUS_DONE;
}
