/* rigid-solid.c -- a rigid body as contacts see it. */
#include "bodies/rigid-solid.h"

#include "base/status.h"
#include "bodies/rigid-state.h"
#include "bodies/solid.h"
#include "state/scales.h"

#include <math.h>
#include <string.h>

static const double wave = 2.7, most = 0.25; /* (RT5) */

static double least_size(const struct rigid_def *d)
{
    double least = 2 * d->radius;

    for (int i = 0; i < DIM && !rigid_def_round(d); i++)
        least = i ? fmin(least, d->size[i]) : d->size[i];
    return least;
}

int rigid_solid_make(struct body *b, const struct scales *s)
{
    const struct rigid_def *d = &b->def;
    const double least = least_size(d), own = s->fluid ? fmin(0.5 * s->dx, 0.5 * least) : least / 20;
    const double soft = s->fluid ? fmin(most, wave * b->speed / (s->c0 + b->speed)) : most;

    b->margin = d->margin > 0 ? d->margin : own;
    b->film = s->fluid ? d->film * s->dx : 0;
    b->ball = rigid_def_round(d) ? d->radius : b->margin;
    b->depth = (d->softness > 0 ? d->softness : soft) * 2 * b->margin;
    if (rigid_def_round(d) || b->margin <= 0.5 * least)
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "%s: a margin of %g m rounds off more than half of its "
                       "shortest side, %g m; set a smaller margin", b->path, b->margin, least);
}

static void facts(const struct body *b, struct solid *out)
{
    double q[TURNING_NUMBERS];

    *out = (struct solid){ .path = b->path, .core.ball = b->ball, .mass = b->mass,
                           .margin = b->margin,
                           .film = b->film, .uplift = b->def.uplift, .stops = b->def.stops,
                           .speed = b->speed, .depth = b->depth,
                           .restitution = b->def.restitution, .friction = b->def.friction };
    memcpy(out->inertia, b->inertia, sizeof out->inertia);
    for (int d = 0; d < DIM && !rigid_def_round(&b->def); d++)
        out->core.half[d] = 0.5 * b->def.size[d] - b->ball;
    rigid_def_turned(&b->def, q);
    turning_matrix(q, out->start.R);
    memcpy(out->start.x, b->def.at, sizeof out->start.x);
}

static void stand(const struct body *b, const struct layout *l, const double *y,
                  struct solid_place *out)
{
    struct body_work w;

    rigid_state_read(b, &w, l, y);
    memcpy(out->x, w.x, sizeof out->x);
    memcpy(out->R, w.R, sizeof out->R);
    memcpy(out->v, w.v, sizeof out->v);
    memcpy(out->spin, w.spin, TURNING_SPINS * sizeof *w.spin);
}

static void push(struct body_work *w, const struct body_push *by)
{
    w->push = *by;
}

void rigid_solid_add(const struct body_work *w, double *force, double *moment, double *by_walls)
{
    for (int d = 0; d < DIM; d++) {
        force[d] += w->push.force[d];
        by_walls[d] += w->push.by_walls[d];
    }
    for (int i = 0; i < TURNING_SPINS; i++)
        moment[i] += w->push.moment[i];
}

const struct body_solid rigid_solid = { .facts = facts, .stand = stand, .push = push };
