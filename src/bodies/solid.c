/* solid.c -- solids that do not give way: sides of the domain, and how walls are carried along. */
#include "bodies/solid.h"

#include <math.h>
#include <string.h>

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

void solid_unmoved(const char *path, struct solid *out)
{
    *out = (struct solid){ .path = path, .mass = HUGE_VAL, .restitution = NAN, .friction = NAN };
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

    solid_unmoved(name[axis][high_side], out);
    out->core.ball = margin;
    out->flat = true;
    for (int d = 0; d < DIM; d++) {
        out->core.half[d] = d == axis ? high[d] - low[d] : HUGE_VAL;
        out->start.R[d][d] = 1;
    }
    out->start.x[axis] = high_side ? high[axis] + margin + out->core.half[axis]
                                   : low[axis] - margin - out->core.half[axis];
}

struct solid solid_ball(double radius, double mass)
{
    struct solid s = { .core.ball = radius, .mass = mass };

    for (int i = 0; i < TURNING_SPINS; i++)
        s.inertia[i] = HUGE_VAL;
    return s;
}
