/* rigid.c -- a rigid body.
 *
 *   M V' = F + M g,  I Omega' = R^T T - Omega x I Omega                            (RB3)
 *
 * about the centre X, with R of (RB1): Goldstein, Classical Mechanics, 1980, 5-5.  A point of
 * the skin stands at X + R xi and moves with V + R (Omega x xi); forces on the skin come back
 * by the transpose of that, so that the work on the skin is the body's. */
#include "bodies/rigid-make.h"

#include "base/status.h"
#include "bodies/rigid-stops.h"

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

static int add_row(struct body *b, struct layout *l, int which, enum layout_class what,
                   const char *name, const char *unit, int n, int components, double scale)
{
    char path[80];

    snprintf(path, sizeof path, "%s.%s", b->path, name);
    b->row[which] = layout_add(l, what, path, unit, n, components, scale);
    return b->row[which] < 0 ? STATUS_FAILED : STATUS_DONE;
}

/* A quaternion turns by half the angle. */
static int rigid_rows(struct body *b, struct layout *l)
{
    const double reach = rigid_def_reach(&b->def), half = DIM == 2 ? 1 : 0.5;

    TRY(add_row(b, l, 0, LAYOUT_POSITION, "x", "m", 1, DIM, b->length));
    TRY(add_row(b, l, 1, LAYOUT_POSITION, "turn", DIM == 2 ? "rad" : "", 1, TURNING_NUMBERS,
                half * b->length / reach));
    TRY(add_row(b, l, 2, LAYOUT_VELOCITY, "v", "m/s", 1, DIM, b->speed));
    TRY(add_row(b, l, 3, LAYOUT_VELOCITY, "spin", "rad/s", 1, TURNING_SPINS, b->speed / reach));
    if (b->stops.places == 0)
        return STATUS_DONE;
    TRY(add_row(b, l, 4, LAYOUT_OTHER, "slip", "m", b->stops.places, DIM, 0.4 * b->stops.depth));
    return add_row(b, l, 5, LAYOUT_OTHER, "stopped", "J", 2, 1, 0);
}

static void rigid_start(const struct body *b, const struct layout *l, double *y)
{
    memcpy(y + layout_at(l, b->row[0]), b->def.at, DIM * sizeof *y);
    rigid_def_turned(&b->def, y + layout_at(l, b->row[1]));
    memcpy(y + layout_at(l, b->row[2]), b->def.velocity, DIM * sizeof *y);
    memcpy(y + layout_at(l, b->row[3]), b->def.spin, TURNING_SPINS * sizeof *y);
    if (b->stops.places == 0)
        return;
    memset(y + layout_at(l, b->row[4]), 0, (size_t)b->stops.places * DIM * sizeof *y);
    memset(y + layout_at(l, b->row[5]), 0, 2 * sizeof *y);
}

static void read_state(const struct body *b, struct body_work *w, const struct layout *l,
                       const double *y)
{
    w->x = y + layout_at(l, b->row[0]);
    w->turn = y + layout_at(l, b->row[1]);
    w->v = y + layout_at(l, b->row[2]);
    w->spin = y + layout_at(l, b->row[3]);
    turning_matrix(w->turn, w->R);
}

static void rigid_move(const struct body *b, struct body_work *w, const struct layout *l, double t,
                       const double *y, double (*x)[DIM], double (*u)[DIM])
{
    (void)t;
    read_state(b, w, l, y);
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

/* Forces of the sides, which are supports, and the work that they give. */
static void stop(const struct body *b, const struct body_work *w, const struct layout *l,
                 const double *y, double *sum, double *moment, double *ydot,
                 struct body_load *out)
{
    double before[DIM], *power;

    if (b->stops.places == 0)
        return;
    memcpy(before, sum, sizeof before);
    power = ydot + layout_at(l, b->row[5]);
    rigid_stops(b, w, y + layout_at(l, b->row[4]), sum, moment, ydot + layout_at(l, b->row[4]),
                power);
    out->driven += power[0] + power[1];
    for (int d = 0; d < DIM; d++)
        out->support[d] += sum[d] - before[d];
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
    read_state(b, w, l, y);
    gather(b, w, force, sum, moment);
    *out = (struct body_load){ 0 };
    memcpy(ydot + layout_at(l, b->row[0]), w->v, DIM * sizeof *ydot);
    turning_rate(w->turn, w->spin, ydot + layout_at(l, b->row[1]));
    stop(b, w, l, y, sum, moment, ydot, out);
    move_on(b, w, sum, moment, ydot + layout_at(l, b->row[2]), ydot + layout_at(l, b->row[3]), out);
}

static void rigid_limit(const struct body *b, struct limit *out)
{
    *out = (struct limit){ .rate = b->rate };
    snprintf(out->part, sizeof out->part, "%s", b->path);
}

static void rigid_energy(const struct body *b, struct body_work *w, const struct layout *l,
                         const double *y, struct energies *to)
{
    read_state(b, w, l, y);
    for (int d = 0; d < DIM; d++) {
        to->kinetic += 0.5 * b->mass * w->v[d] * w->v[d];
        to->potential -= b->mass * b->g[d] * (w->x[d] - b->low[d]);
    }
    for (int i = 0; i < TURNING_SPINS; i++)
        to->kinetic += 0.5 * b->inertia[i] * w->spin[i] * w->spin[i];
}

static void rigid_momentum(const struct body *b, struct body_work *w, const struct layout *l,
                           const double *y, double *p)
{
    read_state(b, w, l, y);
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
    read_state(b, w, l, y);
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

static void rigid_pose(const struct body *b, struct body_work *w, const struct layout *l,
                       const double *y, const double (*force)[DIM], struct body_pose *out)
{
    double moment[TURNING_SPINS], aside[RIGID_PLACES * DIM], power[2], length = 0;

    *out = (struct body_pose){ 0 };
    read_state(b, w, l, y);
    memcpy(out->x, w->x, sizeof out->x);
    memcpy(out->v, w->v, sizeof out->v);
    memcpy(out->spin, w->spin, TURNING_SPINS * sizeof *out->spin);
    for (int i = 0; i < TURNING_NUMBERS; i++)
        length += w->turn[i] * w->turn[i];
    for (int i = 0; i < TURNING_NUMBERS; i++)
        out->turn[i] = w->turn[i] / (DIM == 2 ? 1 : sqrt(length));
    gather(b, w, force, out->force, moment);
    turn_moment(w, moment, out->moment);
    if (b->stops.places > 0)
        rigid_stops(b, w, y + layout_at(l, b->row[4]), out->contact, moment, aside, power);
}

static bool rigid_holds(const struct body *b, const double *x)
{
    double q[TURNING_NUMBERS], R[DIM][DIM], square = 0;
    bool in = true;

    rigid_def_turned(&b->def, q);
    turning_matrix(q, R);
    for (int k = 0; k < DIM; k++) {
        double own = 0;
        for (int d = 0; d < DIM; d++)
            own += R[d][k] * (x[d] - b->def.at[d]);
        in &= fabs(own) <= 0.5 * b->def.size[k];
        square += own * own;
    }
    return rigid_def_round(&b->def) ? square <= b->def.radius * b->def.radius : in;
}

static const struct body_watch watch = { .holds = rigid_holds, .pose = rigid_pose };

const struct body_kind bodies_rigid = {
    .identity = {
        .name = "rigid", .about = "rigid body: a box, a disc (2D) or a sphere (3D)",
        .equation = "M V' = F + M g, I Omega' = R^T T - Omega x I Omega  (RB3)",
        .source = "Goldstein 1980; k_q: Baumgarte 1972",
        .group = "body", .size = sizeof(struct rigid_def), .params = rigid_def_params,
    },
    .make = { .create = rigid_make, .free = rigid_make_free, .work = rigid_make_work,
              .work_free = rigid_make_work_free },
    .skin = rigid_points, .rows = rigid_rows, .start = rigid_start, .move = rigid_move,
    .load = rigid_load, .limit = rigid_limit, .energy = rigid_energy,
    .momentum = rigid_momentum, .weight = rigid_weight, .show = rigid_show, .watch = &watch,
};
