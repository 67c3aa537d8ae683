/* viscous-gradients.c -- (BV1) by the conjugate gradients of implicit/operator.h, which
 * search in what is kept from the directions of viscous-directions.c. */
#include "implicit/viscous.h"

#include "base/status.h"

#include <math.h>
#include <stdio.h>

static const double exact = 0.01; /* of tol: the largest correction left */

static bool enough(void *self, const struct operator_progress *at)
{
    const struct viscous_block *b = self;
    const struct viscous *u = viscous_of(b->moment);

    return at->correction / b->moment->plan->scales.speed <= exact * u->tol
           || at->work <= u->rounding;
}

static void clear(void *self, double *residual)
{
    const struct viscous_block *b = self;

    viscous_directions_clear(b->moment, b->gamma, residual);
}

static void leave(void *self, double *v)
{
    const struct viscous_block *b = self;

    viscous_directions_leave(b->moment, b->gamma, v);
}

static int refuse(struct moment *m, double t, const struct operator_report *report)
{
    const struct viscous *u = viscous_of(m);
    char why[160];

    operator_refusal(report, why, sizeof why);
    snprintf(m->refusal, sizeof m->refusal, "%s, taken implicitly, found no velocities at "
             "t = %g s: %s, and the largest correction still %.3g of its scale (tol %g)",
             u->part->path, t, why, report->correction / m->plan->scales.speed, u->tol);
    return STATUS_FAILED;
}

/* What is left along the directions goes into x. */
static void project(struct moment *m, double gamma)
{
    struct viscous *u = viscous_of(m);
    const struct viscous_along along = viscous_directions_clear(m, gamma, u->residual);

    viscous_directions_add(u, &along, u->x);
}

int viscous_iterate(struct moment *m, double t, double gamma)
{
    struct viscous *u = viscous_of(m);
    struct operator_report report;

    u->rounding = 1e-30 * fabs(vector_dot(u->unknowns, u->right, u->x, u->partial));
    u->operator.all.enough = enough;
    u->operator.all.clear = clear;
    u->operator.all.leave = leave;
    viscous_directions_set(m, gamma);
    project(m, gamma);
    if (operator_solve(u->solver, &u->operator.all, u->x, u->residual, &report) != STATUS_DONE)
        return refuse(m, t, &report);
    project(m, gamma);
    return STATUS_DONE;
}
