/* mri-rigid.c -- rigid bodies with all that they touch as the fast side of "mri-rigid": explicit
 * steps within the stages of the water, as short as contacts ask for.
 *
 * All of f is evaluated at the stages of the water, and the fast side, at the same y, is taken from
 * it: what is left is the push of the water (RT7).  Zonneveld's pair of order 4(3) notices an
 * impact where others pass over it: Hairer, Norsett, Wanner, Solving Ordinary Differential
 * Equations I, section II.4, table 4.2. */
#include "time/mri.h"

#include "base/status.h"
#include "eval/moment.h"

#include <math.h>

static const double safety = 0.95; /* of the stability bound */

static const struct control_row control = { { 0.60, -0.20, 0 }, 0.5, 1, 2.5 };

static int stage(struct mri *m, const struct mri_forcing *f, double t, double h, int i)
{
    struct mri_bodies *b = &m->bodies;
    struct fixed *x = m->frame;
    const double at = t + h * tableau_node(&b->table, i);

    mri_bodies_load(m, f, at);
    mri_bodies_add_up(b, b->table.a[i], i, h, b->sum);
    mri_bodies_put(x, b->sum, x->try);
    TRY(moment_rigid(x->moment, at, x->try, x->rates));
    mri_bodies_pick(x, x->rates, b->rate[i]);
    for (long j = 0; j < b->entries; j++)
        b->rate[i][j] += b->load[j];
    return STATUS_DONE;
}

static double longest(struct mri *m, double t)
{
    const struct mri_bodies *b = &m->bodies;
    struct limit limit[2];
    double h = HUGE_VAL;

    mri_bodies_put(m->frame, b->y, m->frame->try);
    moment_rigid_limit(m->frame->moment, t, m->frame->try, limit);
    for (int k = 0; k < 2; k++)
        if (limit[k].rate > 0)
            h = fmin(h, safety * b->stable[k] / limit[k].rate);
    return h;
}

static int less(struct mri *m, double t, const double *y, double *ydot)
{
    const struct fixed *x = m->frame;

    TRY(moment_rigid(x->moment, t, y, x->rates));
    for (int k = 0; k < x->ranges; k++)
        for (long i = x->range[k][0]; i < x->range[k][1]; i++)
            ydot[i] -= x->rates[i];
    return STATUS_DONE;
}

/* Straight lines: rates at both ends say nothing of what bodies do in between. */
static void between(const struct fixed *x, double t, double *y)
{
    (void)x, (void)t, (void)y; /* as the frame has drawn them */
}

const struct mri_side mri_rigid_side = {
    .table = "ARKODE_ZONNEVELD_5_3_4", .control = &control, .ranges = moment_rigid_ranges,
    .stage = stage, .longest = longest, .less = less, .limit = moment_fluid_limit,
    .between = between,
};
