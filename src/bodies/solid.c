/* solid.c -- walls as contacts see them. */
#include "bodies/solid.h"

#include "shapes/shape-box.h"

#include <math.h>
#include <string.h>

static void take_box(const struct shape *s, struct solid *out)
{
    double own[DIM], at[DIM], least = HUGE_VAL;

    for (int d = 0; d < DIM; d++) {
        out->core.half[d] = 0.5 * (s->to[d] - s->from[d]);
        least = fmin(least, out->core.half[d]);
        own[d] = 0.5 * (s->from[d] + s->to[d]);
    }
    out->core.ball = fmin(out->core.ball, least);
    shape_box_place(s, own, out->start.x);
    for (int k = 0; k < DIM; k++) {
        out->core.half[k] -= out->core.ball;
        own[k] += least;
        shape_box_place(s, own, at);
        own[k] -= least;
        for (int d = 0; d < DIM; d++)
            out->start.R[d][k] = (at[d] - out->start.x[d]) / least;
    }
}

static void take_ball(const struct shape *s, struct solid *out)
{
    out->core.ball = s->radius;
    for (int d = 0; d < DIM; d++) {
        out->start.x[d] = s->centre[d];
        out->start.R[d][d] = 1;
    }
}

void solid_carry(const struct solid_place *by, const struct solid_place *start,
                 struct solid_place *out)
{
    double own[DIM], column[DIM], turned[DIM], spin[TURNING_SPINS];

    solid_space(by, start->x, out->x);
    turning_velocity(by->spin, start->x, own);
    solid_space(by, own, out->v);
    for (int d = 0; d < DIM; d++) {
        out->x[d] += by->x[d];
        out->v[d] += by->v[d];
    }
    for (int k = 0; k < DIM; k++) {
        for (int d = 0; d < DIM; d++)
            column[d] = start->R[d][k];
        solid_space(by, column, turned);
        for (int d = 0; d < DIM; d++)
            out->R[d][k] = turned[d];
    }
    memcpy(spin, by->spin, sizeof spin);
    if (TURNING_SPINS == DIM)
        solid_own(start, by->spin, spin);
    memcpy(out->spin, spin, sizeof spin);
}

static void begin(const char *path, double margin, struct solid *out)
{
    *out = (struct solid){ .path = path, .mass = HUGE_VAL, .restitution = NAN, .friction = NAN,
                           .core.ball = margin };
    for (int i = 0; i < TURNING_SPINS; i++)
        out->inertia[i] = HUGE_VAL;
}

/* A box as thick as the domain is large: what got through is still pushed back. */
void solid_of_side(int axis, bool high_side, const double *low, const double *high, double margin,
                   struct solid *out)
{
    static const char *const name[DIM][2] = {
        { "the left of the domain", "the right of the domain" },
#if DIM == 3
        { "the front of the domain", "the back of the domain" },
#endif
        { "the bottom of the domain", "the top of the domain" },
    };

    begin(name[axis][high_side], margin, out);
    out->flat = true;
    for (int d = 0; d < DIM; d++) {
        out->core.half[d] = d == axis ? high[d] - low[d] : HUGE_VAL;
        out->start.R[d][d] = 1;
    }
    out->start.x[axis] = high_side ? high[axis] + margin + out->core.half[axis]
                                   : low[axis] - margin - out->core.half[axis];
}

bool solid_of_shape(const struct shape *s, const char *path, double margin, struct solid *out)
{
    begin(path, margin, out);
    if (s->kind == SHAPE_BOX)
        take_box(s, out);
    else if (s->kind == SHAPE_DISC || s->kind == SHAPE_SPHERE)
        take_ball(s, out);
    else
        return false;
    return true;
}
