/* rigid-solid.c -- a rigid body as contacts see it. */
#include "bodies/rigid-solid.h"

#include "base/status.h"
#include "bodies/rigid-state.h"
#include "bodies/solid.h"
#include "bodies/touch.h"
#include "state/scales.h"

#include <math.h>
#include <string.h>

static int take_cores(struct body *b)
{
    const struct rigid_form *form = b->figure.form;

    if (form->kernels)
        TRY(form->kernels(&b->figure, b->margin));
    b->cores = form->cores(&b->figure, b->margin, NULL);
    b->core = status_alloc((size_t)b->cores, sizeof *b->core);
    if (!b->core)
        return STATUS_FAILED;
    form->cores(&b->figure, b->margin, b->core);
    return STATUS_DONE;
}

int rigid_solid_make(struct body *b, const struct scales *s)
{
    const struct rigid_def *d = &b->def;
    const double least = b->figure.least, own = s->fluid ? fmin(0.5 * s->dx, 0.5 * least) : least / 20;
    const double soft = s->fluid ? touch_softness(b->speed, s->c0) : touch_softest;

    b->margin = d->margin > 0 ? d->margin : own;
    b->film = s->fluid ? d->film * s->dx : 0;
    b->depth = (d->softness > 0 ? d->softness : soft) * 2 * b->margin;
    if (!(b->margin <= 0.5 * least) && !b->figure.form->rounds)
        return status_fail(STATUS_BAD_SCENE, "%s: a margin of %g m rounds off more than half of its "
                           "shortest side, %g m; set a smaller margin", b->path, b->margin, least);
    return take_cores(b);
}

static int solids(const struct body *b)
{
    return b->cores;
}

static void facts(const struct body *b, int i, struct solid *out)
{
    double q[TURNING_NUMBERS];

    *out = (struct solid){ .path = b->path, .core = b->core[i], .mass = b->mass,
                           .margin = b->margin,
                           .film = b->film, .uplift = b->def.uplift, .stops = b->def.stops,
                           .speed = b->speed, .depth = b->depth, .together = b->figure.together,
                           .restitution = b->def.restitution, .friction = b->def.friction };
    memcpy(out->inertia, b->inertia, sizeof out->inertia);
    rigid_def_turned(&b->def, q);
    turning_matrix(q, out->start.R);
    memcpy(out->start.x, b->def.at, sizeof out->start.x);
}

static double depth(const struct body *b, const double *own)
{
    return b->figure.form->depth(&b->figure, own);
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

const struct body_solid rigid_solid = { .solids = solids, .facts = facts, .depth = depth,
                                       .stand = stand, .push = push };
