/* rigid-stops.c -- sides of the domain that stop a rigid body. */
#include "bodies/rigid-stops.h"

#include "base/status.h"
#include "shapes/shape.h"
#include "state/scales.h"

#include <math.h>
#include <string.h>

static const double wave = 2.7, most = 0.25; /* (RT5) */

static int corners(const struct rigid_def *d)
{
    return rigid_def_round(d) ? 1 : 1 << DIM;
}

/* Centre of ball i, from that of the body, in its frame. */
static void corner(const struct body *b, int i, double *to)
{
    for (int d = 0; d < DIM; d++) {
        const double half = 0.5 * b->def.size[d] - b->stops.ball;
        to[d] = rigid_def_round(&b->def) ? 0 : i >> d & 1 ? half : -half;
    }
}

static double least_size(const struct rigid_def *d)
{
    double least = 2 * d->radius;

    for (int i = 0; i < DIM && !rigid_def_round(d); i++)
        least = i ? fmin(least, d->size[i]) : d->size[i];
    return least;
}

/* Where a corner's ball meets that side, and how: arm [DIM] from the centre in space. */
static void meet(const struct body *b, const struct body_work *w, int i, int side,
                 struct touch_place *at, double *arm)
{
    const int axis = b->stops.axis[side];
    const double sign = b->stops.sign[side];
    double own[DIM], turned[DIM] = { 0 }, lever[TURNING_SPINS] = { 0 };

    memset(at, 0, sizeof *at);
    at->normal[axis] = sign;
    corner(b, i, own);
    for (int d = 0; d < DIM; d++) {
        arm[d] = d == axis ? -sign * b->stops.ball : 0;
        for (int k = 0; k < DIM; k++)
            arm[d] += w->R[d][k] * own[k];
    }
    at->depth = -sign * (w->x[axis] + arm[axis] - b->stops.at[side]);
    for (int k = 0; k < DIM; k++) { /* into the frame of the body, where the spin is */
        own[k] = 0;
        for (int d = 0; d < DIM; d++)
            own[k] += w->R[d][k] * arm[d];
        turned[k] = w->R[axis][k] * sign;
    }
    turning_moment(own, turned, lever);
    at->mass = 1 / b->mass;
    for (int k = 0; k < TURNING_SPINS; k++)
        at->mass += lever[k] * lever[k] / b->inertia[k];
    at->mass = 1 / at->mass;
    turning_velocity(w->spin, own, turned);
    for (int d = 0; d < DIM; d++) {
        at->velocity[d] = w->v[d];
        for (int k = 0; k < DIM; k++)
            at->velocity[d] += w->R[d][k] * turned[k];
    }
    at->rate = -sign * at->velocity[axis];
}

static void push(const struct body_work *w, const double *arm, const double *force, double *sum,
                 double *moment)
{
    double own_arm[DIM] = { 0 }, own_force[DIM] = { 0 };

    for (int d = 0; d < DIM; d++) {
        sum[d] += force[d];
        for (int k = 0; k < DIM; k++) {
            own_arm[k] += w->R[d][k] * arm[d];
            own_force[k] += w->R[d][k] * force[d];
        }
    }
    turning_moment(own_arm, own_force, moment);
}

void rigid_stops(const struct body *b, const struct body_work *w, const double *xi, double *sum,
                 double *moment, double *xi_rate, double power[2])
{
    const int n = corners(&b->def);

    power[0] = power[1] = 0;
    for (int j = 0; j < b->stops.places; j++) {
        struct touch_place at;
        double arm[DIM], press[DIM], rub[DIM];
        meet(b, w, j % n, j / n, &at, arm);
        touch(&b->stops.law, &at, xi + j * DIM, press, rub, xi_rate + j * DIM);
        for (int d = 0; d < DIM; d++) {
            power[0] += press[d] * at.velocity[d];
            power[1] += rub[d] * at.velocity[d];
            press[d] += rub[d];
        }
        push(w, arm, press, sum, moment);
    }
}

static void list_sides(struct body *b, const struct scales *s)
{
    for (int axis = 0; axis < DIM; axis++)
        for (int high = 0; high < 2; high++) {
            if (!(b->def.stops & shape_side(axis, high)))
                continue;
            const int n = b->stops.sides++;
            b->stops.axis[n] = axis;
            b->stops.sign[n] = high ? -1 : 1;
            b->stops.at[n] = high ? s->high[axis] : s->low[axis];
        }
    b->stops.places = b->stops.sides * corners(&b->def);
}

/* Overlap is energy from nowhere: 0.05 of the depth that a body at full speed gets to. */
static int check_start(const struct body *b)
{
    struct body_work w = { .x = b->def.at, .v = b->def.velocity, .spin = b->def.spin };
    double q[TURNING_NUMBERS], arm[DIM];

    rigid_def_turned(&b->def, q);
    turning_matrix(q, w.R);
    for (int j = 0; j < b->stops.places; j++) {
        struct touch_place at;
        const int n = corners(&b->def), side = j / n;
        meet(b, &w, j % n, side, &at, arm);
        if (at.depth > 0.05 * b->stops.depth)
            return status_fail(STATUS_BAD_SCENE, "%s: at t = 0 it reaches %g m beyond the side of "
                               "the domain at %c = %g m, which stops it; at most %g m may "
                               "overlap: move it inside, or leave that side out of stops", b->path,
                               at.depth, "xyz"[b->stops.axis[side]], b->stops.at[side],
                               0.05 * b->stops.depth);
    }
    return STATUS_DONE;
}

int rigid_stops_create(struct body *b, const struct scales *s)
{
    const struct rigid_def *d = &b->def;
    const double margin = d->margin > 0 ? d->margin
                                        : s->dx > 0 ? 0.5 * s->dx : least_size(d) / 20;
    const double own = s->fluid ? fmin(most, wave * b->speed / (s->c0 + b->speed)) : most;

    b->stops.ball = rigid_def_round(d) ? d->radius : margin;
    b->stops.depth = (d->softness > 0 ? d->softness : own) * 2 * margin;
    if (d->stops == 0)
        return STATUS_DONE;
    if (!rigid_def_round(d) && margin > 0.5 * least_size(d))
        return status_fail(STATUS_BAD_SCENE, "%s: a margin of %g m rounds off more than half of its "
                           "shortest side, %g m; set a smaller margin", b->path, margin,
                           least_size(d));
    b->stops.law = touch_law(b->mass, b->speed, b->stops.depth, d->restitution, d->friction);
    b->rate = fmax(b->rate, touch_rate(b->speed, b->stops.depth));
    list_sides(b, s);
    return check_start(b);
}
