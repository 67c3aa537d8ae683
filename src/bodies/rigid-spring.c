/* rigid-spring.c -- springs, dampers and lines from rigid bodies to fixed points.
 *
 *   F = -(k (l - l_0) + c l') e,   l e = X + R xi - P                              (RP1)
 *
 * A line with `slack` pulls only: it gives nothing where l < l_0, and never pushes. */
#include "bodies/rigid-spring.h"

#include "bodies/rigid-def.h"

#include <math.h>

/* Where it is tied less where its other end stands; velocity of the former. */
static double reach(const struct rigid_rope *s, double (*const R)[DIM], const double *x,
                    const double *v, const double *spin, double *e, double *rate)
{
    double turned[DIM], length = 0;

    turning_velocity(spin, s->arm, turned);
    for (int d = 0; d < DIM; d++) {
        e[d] = x[d] - s->def->to[d];
        for (int k = 0; k < DIM; k++)
            e[d] += R[d][k] * s->arm[k];
        length += e[d] * e[d];
    }
    length = sqrt(length);
    *rate = 0;
    for (int d = 0; d < DIM; d++) {
        double u = v[d];
        for (int k = 0; k < DIM; k++)
            u += R[d][k] * turned[k];
        e[d] = length > 0 ? e[d] / length : 0;
        *rate += e[d] * u;
    }
    return length;
}

void rigid_spring_make(const struct rigid_def *d, const struct rigid_spring *s,
                       struct rigid_rope *to)
{
    double q[TURNING_NUMBERS], R[DIM][DIM], length = 0;

    *to = (struct rigid_rope){ .def = s };
    rigid_def_turned(d, q);
    turning_matrix(q, R);
    for (int k = 0; k < DIM; k++) {
        length += (s->on[k] - s->to[k]) * (s->on[k] - s->to[k]);
        for (int i = 0; i < DIM; i++)
            to->arm[k] += R[i][k] * (s->on[i] - d->at[i]);
    }
    to->rest = isnan(s->rest) ? sqrt(length) : s->rest;
}

void rigid_spring_pull(const struct rigid_rope *s, double (*const R)[DIM], const double *x,
                       const double *v, const double *spin, struct rigid_pull *to)
{
    double e[DIM], own[DIM] = { 0 }, rate;
    const double length = reach(s, R, x, v, spin, e, &rate), beyond = length - s->rest;
    const bool slack = s->def->slack && beyond < 0;
    const double spring = slack ? 0 : s->def->stiffness * beyond;
    double damper = slack ? 0 : s->def->damping * rate;

    if (s->def->slack)
        damper = fmax(damper, -spring);
    *to = (struct rigid_pull){ .damping = -damper * rate, .elastic = 0.5 * spring * beyond };
    for (int d = 0; d < DIM; d++) {
        to->force[d] = -(spring + damper) * e[d];
        for (int k = 0; k < DIM; k++)
            own[k] += R[d][k] * to->force[d];
    }
    turning_moment(s->arm, own, to->moment);
}

/* Eigenvalues of M^-1 K are at most the sum of those of each spring, which are 1/M and what a
 * turn adds, at most arm^2/I; a joint makes them smaller (Rayleigh). */
void rigid_spring_rates(const struct rigid_rope *s, int springs, double mass,
                        const double *inertia, double *swing, double *decay)
{
    double least = inertia[0], square = 0;

    for (int i = 1; i < TURNING_SPINS; i++)
        least = fmin(least, inertia[i]);
    *decay = 0;
    for (int i = 0; i < springs; i++) {
        double arm2 = 0;
        for (int d = 0; d < DIM; d++)
            arm2 += s[i].arm[d] * s[i].arm[d];
        square += s[i].def->stiffness * (1 / mass + arm2 / least);
        *decay += s[i].def->damping * (1 / mass + arm2 / least);
    }
    *swing = sqrt(square);
}

double rigid_spring_stretch(const struct rigid_rope *s, int springs)
{
    double most = 0;

    for (int i = 0; i < springs; i++) {
        double square = 0;
        for (int d = 0; d < DIM; d++)
            square += (s[i].def->on[d] - s[i].def->to[d]) * (s[i].def->on[d] - s[i].def->to[d]);
        most = fmax(most, fabs(sqrt(square) - s[i].rest));
    }
    return most;
}
