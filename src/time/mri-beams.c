/* mri-beams.c -- beams as the fast side of "mri": implicit steps,
 *
 *   z_i - h a_ii (f_I(z_i) + g(t_i)) = y + h sum_(j<i) a_ij k_j,   k_i = f_I(z_i) + g(t_i),
 *
 * SDIRK of order 4(3) and 5 stages, L-stable.  Hairer, Wanner, Solving Ordinary Differential
 * Equations II, section IV.6, table 6.5.  A vibration is resolved as far as tol asks for,
 * however long the steps of the water are. */
#include "time/mri.h"

#include "base/status.h"
#include "eval/moment.h"

static const struct control_row control = { { 0.60, -0.20, 0 }, 0.5, 1, 2.5 };

static int stage(struct mri *m, const struct mri_forcing *f, double t, double h, int i)
{
    struct mri_bodies *b = &m->bodies;
    struct fixed *x = m->frame;
    const double gamma = h * b->table.a[i][i];

    mri_bodies_load(m, f, t + h * tableau_node(&b->table, i));
    mri_bodies_add_up(b, b->table.a[i], i, h, b->sum);
    for (long j = 0; j < b->entries; j++)
        b->rate[i][j] = b->sum[j] + gamma * b->load[j];
    mri_bodies_put(x, b->rate[i], x->try);
    mri_bodies_put(x, b->sum, x->rates);
    TRY(moment_solve(x->moment, t, gamma, x->try, x->rates));
    mri_bodies_pick(x, x->rates, b->rate[i]);
    for (long j = 0; j < b->entries; j++)
        b->rate[i][j] = (b->rate[i][j] - b->sum[j]) / gamma;
    return STATUS_DONE;
}

/* With the forces of the water, which bodies at rest book as well, taken off. */
static int less(struct mri *m, double t, const double *y, double *ydot)
{
    moment_body_book(m->frame->moment, t, y, -1, ydot);
    moment_body_book(m->frame->moment, t, m->bodies.rest, 1, ydot);
    return STATUS_DONE;
}

static void limit(struct moment *moment, double t, const double *y, struct limit to[2])
{
    moment_limit(moment, t, y, false, to);
}

/* Of bodies, positions are the cubic through both ends with the velocities there, and
 * velocities its slope: rates of stiff velocities say nothing of a whole step. */
static void between(const struct fixed *x, double t, double *y)
{
    const double h = x->t - x->t_old, s = (t - x->t_old) / h, r = 1 - s;
    const long v = x->from[LAYOUT_VELOCITY];

    for (int k = 0; k < x->ranges; k++)
        for (long i = x->range[k][0]; i < x->range[k][1] && i < v; i++) {
            const double q0 = x->y_old[i], q1 = x->y[i], v0 = x->y_old[v + i], v1 = x->y[v + i];
            y[i] = r * r * ((1 + 2 * s) * q0 + s * h * v0)
                 + s * s * ((1 + 2 * r) * q1 - r * h * v1);
            y[v + i] = 6 * s * r * (q1 - q0) / h + r * (1 - 3 * s) * v0 + s * (3 * s - 2) * v1;
        }
}

const struct mri_side mri_beams_side = {
    .table = "ARKODE_SDIRK_5_3_4", .implicit = true, .control = &control,
    .ranges = moment_stiff_ranges, .stage = stage, .less = less, .limit = limit,
    .between = between,
};
