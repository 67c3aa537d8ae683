/* rigid.c -- a rigid body.
 *
 *   M V' = F + M g,  I Omega' = R^T T - Omega x I Omega                            (RB3)
 *
 * about the centre X, with R of (RB1): Goldstein, Classical Mechanics, 1980, 5-5.  A point of
 * the skin stands at X + R xi and moves with V + R (Omega x xi); forces on the skin come back
 * by the transpose of that, so that the work on the skin is the body's. */
#include "bodies/rigid-make.h"

#include "base/status.h"
#include "bodies/rigid-hold.h"
#include "bodies/rigid-solid.h"
#include "bodies/rigid-state.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double degree = 3.14159265358979323846 / 180;

static void place(const struct body *b, double (*const R)[DIM], const double *centre,
                  double (*x)[DIM])
{
    for (int i = 0; i < b->points; i++)
        for (int d = 0; d < DIM; d++) {
            x[i][d] = centre[d];
            for (int k = 0; k < DIM; k++)
                x[i][d] += R[d][k] * b->arm[i][k];
        }
}

static int rigid_points(const struct body *b, double (*x)[DIM], enum kind *kind)
{
    double q[TURNING_NUMBERS], R[DIM][DIM];

    if (x) {
        rigid_def_turned(&b->def, q);
        turning_matrix(q, R);
        place(b, R, b->def.at, x);
    }
    if (kind)
        *kind = b->def.slip ? KIND_SKIN_SLIP : KIND_SKIN;
    return b->points;
}

static void rigid_move(const struct body *b, struct body_work *w, const struct layout *l, double t,
                       const double *y, double (*x)[DIM], double (*u)[DIM])
{
    (void)t;
    rigid_state_read(b, w, l, y);
    place(b, w->R, w->x, x);
    for (int i = 0; i < b->points; i++) {
        double own[DIM];
        turning_velocity(w->spin, b->arm[i], own);
        for (int d = 0; d < DIM; d++) {
            u[i][d] = w->v[d];
            for (int k = 0; k < DIM; k++)
                u[i][d] += w->R[d][k] * own[k];
        }
    }
}

/* Sum of forces on the skin, and their moment about the centre in the frame of the body. */
static void gather(const struct body *b, const struct body_work *w, const double (*force)[DIM],
                   double *sum, double *moment)
{
    memset(sum, 0, DIM * sizeof *sum);
    memset(moment, 0, TURNING_SPINS * sizeof *moment);
    for (int i = 0; force && i < b->points; i++) {
        double own[DIM] = { 0 };
        for (int d = 0; d < DIM; d++) {
            sum[d] += force[i][d];
            for (int k = 0; k < DIM; k++)
                own[k] += w->R[d][k] * force[i][d];
        }
        turning_moment(b->arm[i], own, moment);
    }
}

/* What holds a direction gives all that would change its velocity. */
static void move_on(const struct body *b, const struct body_work *w, const double *sum,
                    const double *moment, double *v, double *spin, struct body_load *out)
{
    const bool turns = !(b->def.held & 1u << DIM);
    double gyration[TURNING_SPINS];

    turning_gyration(b->inertia, w->spin, gyration);
    for (int d = 0; d < DIM; d++) {
        const bool held = b->def.held & 1u << d;
        const double all = sum[d] + b->mass * b->g[d];
        v[d] = held ? 0 : all / b->mass;
        out->support[d] -= held ? all : 0;
        out->driven -= held ? all * w->v[d] : 0;
    }
    for (int i = 0; i < TURNING_SPINS; i++) {
        spin[i] = turns ? (moment[i] + gyration[i]) / b->inertia[i] : 0;
        out->driven -= turns ? 0 : moment[i] * w->spin[i];
    }
}

static void rigid_load(const struct body *b, struct body_work *w, const struct layout *l, double t,
                       const double *y, const double (*force)[DIM], double *ydot,
                       struct body_load *out)
{
    double sum[DIM], moment[TURNING_SPINS];

    (void)t;
    rigid_state_read(b, w, l, y);
    gather(b, w, force, sum, moment);
    *out = (struct body_load){ 0 };
    rigid_solid_add(w, sum, moment, out->support);
    rigid_hold_pull(b, w, sum, moment, out);
    if (b->joint.kind != RIGID_FREE) {
        rigid_state_rates(b, w, l, rigid_hold_answer(b, w, sum, moment, out), ydot);
        return;
    }
    memcpy(ydot + layout_at(l, b->row[0]), w->v, DIM * sizeof *ydot);
    turning_rate(w->turn, w->spin, ydot + layout_at(l, b->row[1]));
    move_on(b, w, sum, moment, ydot + layout_at(l, b->row[2]), ydot + layout_at(l, b->row[3]), out);
}

static void rigid_limit(const struct body *b, struct limit *out)
{
    *out = (struct limit){ .rate = b->rate };
    if (b->decay > out->rate) {
        out->rate = b->decay;
        out->decay = true;
    }
    snprintf(out->part, sizeof out->part, "%s", b->path);
}

static void rigid_energy(const struct body *b, struct body_work *w, const struct layout *l,
                         const double *y, struct energies *to)
{
    rigid_state_read(b, w, l, y);
    for (int d = 0; d < DIM; d++) {
        to->kinetic += 0.5 * b->mass * w->v[d] * w->v[d];
        to->potential -= b->mass * b->g[d] * (w->x[d] - b->low[d]);
    }
    for (int i = 0; i < TURNING_SPINS; i++)
        to->kinetic += 0.5 * b->inertia[i] * w->spin[i] * w->spin[i];
    to->elastic += rigid_hold_elastic(b, w);
}

static void rigid_momentum(const struct body *b, struct body_work *w, const struct layout *l,
                           const double *y, double *p)
{
    rigid_state_read(b, w, l, y);
    for (int d = 0; d < DIM; d++)
        p[d] += b->mass * w->v[d];
}

static double rigid_weight(const struct body *b)
{
    return b->mass;
}

/* Its centre stands for tip and middle. */
static void rigid_show(const struct body *b, struct body_work *w, const struct layout *l, double t,
                       const double *y, const double (*force)[DIM], struct body_view *out)
{
    (void)t;
    (void)force;
    rigid_state_read(b, w, l, y);
    *out = (struct body_view){ 0 };
    for (int d = 0; d < DIM; d++)
        out->tip[d] = out->mid[d] = w->x[d] - b->def.at[d];
    out->tip_angle = DIM == 2 ? *w->turn - b->def.angle[0] * degree : 0;
}

/* From the frame of the body into space; in the plane a moment is one number. */
static void turn_moment(const struct body_work *w, const double *own, double *to)
{
    to[0] = to[1] = to[2] = 0;
    if (DIM == 2)
        to[2] = own[0];
    for (int d = 0; d < TURNING_SPINS && DIM == 3; d++)
        for (int k = 0; k < TURNING_SPINS; k++)
            to[d] += w->R[d][k] * own[k];
}

/* Forces of all that holds or drives it, and of its springs. */
static void supported(const struct body *b, struct body_work *w, const double *force,
                      const double *contact, double *moment, double *support)
{
    double sum[DIM], v[DIM], spin[TURNING_SPINS];
    struct body_load given = { 0 };

    for (int d = 0; d < DIM; d++)
        sum[d] = force[d] + contact[d];
    rigid_hold_pull(b, w, sum, moment, &given);
    if (b->joint.kind != RIGID_FREE)
        rigid_hold_answer(b, w, sum, moment, &given);
    else
        move_on(b, w, sum, moment, v, spin, &given);
    memcpy(support, given.support, sizeof given.support);
}

static void rigid_pose(const struct body *b, struct body_work *w, const struct layout *l,
                       const double *y, const double (*force)[DIM], struct body_pose *out)
{
    double moment[TURNING_SPINS], support[DIM] = { 0 }, length = 0;

    *out = (struct body_pose){ 0 };
    rigid_state_read(b, w, l, y);
    memcpy(out->x, w->x, sizeof out->x);
    memcpy(out->v, w->v, sizeof out->v);
    rigid_def_tell(&b->def, w->turn, w->spin, out->turn, out->spin);
    for (int i = 0; i < TURNING_NUMBERS; i++)
        length += out->turn[i] * out->turn[i];
    for (int i = 0; i < TURNING_NUMBERS; i++)
        out->turn[i] /= DIM == 2 ? 1 : sqrt(length);
    gather(b, w, force, out->force, moment);
    turn_moment(w, moment, out->moment);
    rigid_solid_add(w, out->contact, moment, support);
    supported(b, w, out->force, out->contact, moment, out->support);
}

static bool rigid_holds(const struct body *b, const double *x)
{
    return rigid_figure_holds(&b->figure, &b->def, x);
}

static int rigid_look(const struct body *b, struct surface *to)
{
    return rigid_figure_surface(&b->figure, to);
}

static bool rigid_tied(const struct body *b)
{
    return b->joint.kind != RIGID_FREE || b->def.ties.springs > 0;
}

static double rigid_event(const struct body *b, double t)
{
    return b->joint.motion ? motion_bend(b->joint.motion, t) : HUGE_VAL;
}

static const struct body_watch watch = { .event = rigid_event, .holds = rigid_holds, .pose = rigid_pose,
                                         .tied = rigid_tied, .look = rigid_look };

const struct body_kind bodies_rigid = {
    .identity = {
        .name = "rigid", .about = "rigid body: a box; a disc or polygon (2D); a sphere, cylinder or hull (3D)",
        .equation = "M V' = F + M g, I Omega' = R^T T - Omega x I Omega  (RB3)",
        .source = "Goldstein 1980; k_q: Baumgarte 1972",
        .group = "body", .size = sizeof(struct rigid_def), .params = rigid_def_params,
        .groups = rigid_ties_groups,
    },
    .make = { .create = rigid_make, .free = rigid_make_free, .work = rigid_make_work,
              .work_free = rigid_make_work_free },
    .skin = rigid_points, .rows = rigid_state_rows, .start = rigid_state_start, .move = rigid_move,
    .load = rigid_load, .limit = rigid_limit, .energy = rigid_energy,
    .momentum = rigid_momentum, .weight = rigid_weight, .show = rigid_show, .watch = &watch,
    .role.solid = &rigid_solid,
};
