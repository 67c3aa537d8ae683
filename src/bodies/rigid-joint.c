/* rigid-joint.c -- a rigid body with a hinge or slider, or driven.
 *
 * With n the axis of a hinge through P or the direction of a slider, e the axis that a motion
 * turns about with rates w and w', u and a its velocity and acceleration at the pivot, r the
 * centre from there and q' the rate of what is left:
 *
 *   V = u + w e x r + q' a_q,  a_q = n x (X - P) of a hinge, n of a slider          (RJ1)
 *   V' = a + w' e x r + w^2 e x (e x r) + 2 w q' e x a_q + q'^2 n x a_q + q'' a_q    (RJ2)
 *
 * (n x a_q of a hinge only) and w e + q' n the spin of a hinge.  Power of what the joint gives
 * is 0 for every q', Goldstein 1980, 1-4:
 *
 *   (M a_q^2 + b I b) q'' = a_q . (F - M a_0) + b . (T - I b_0 - Omega x I Omega) - k q - c q' (RJ3)
 *
 * with b = n of a hinge about the body's own axes, a_0 and b_0 the accelerations at q'' = 0. */
#include "bodies/rigid-joint.h"

#include "bodies/rigid-def.h"

#include <math.h>
#include <string.h>

/* What motions turn about: from x to the last coordinate. */
static const double across[3] = { 0, DIM == 2 ? 0 : -1, DIM == 2 ? 1 : 0 };

static void cross(const double *a, const double *b, double *to)
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        to[i] = a[j] * b[k] - a[k] * b[j];
    }
}

/* Turned about an axis of length 1: Goldstein 1980, (4-92). */
static void turned(const double *axis, double angle, const double *v, double *to)
{
    const double c = cos(angle), s = sin(angle);
    double side[3], along = 0;

    cross(axis, v, side);
    for (int d = 0; d < 3; d++)
        along += axis[d] * v[d];
    for (int d = 0; d < 3; d++)
        to[d] = c * v[d] + (1 - c) * along * axis[d] + s * side[d];
}

/* q of a body that stands at `turn`, turned by that in space. */
static void turn_further(const double *axis, double angle, double *turn)
{
#if DIM == 2
    *turn += axis[2] * angle;
#else
    const double w = cos(0.5 * angle), s = sin(0.5 * angle), old[4] = { turn[0], turn[1], turn[2],
                                                                        turn[3] };

    turning_product((double[4]){ w, s * axis[0], s * axis[1], s * axis[2] }, old, turn);
#endif
}

/* About the body's own axes; in the plane the one number that is left. */
static void own(double (*const R)[DIM], const double *v, double *to)
{
    for (int i = 0; i < TURNING_SPINS; i++) {
        to[i] = DIM == 2 ? v[2] : 0;
        for (int d = 0; d < DIM && DIM == 3; d++)
            to[i] += R[d][i] * v[d];
    }
}

void rigid_joint_make(const struct rigid_def *d, double mass, const double *inertia,
                      struct rigid_joint *to)
{
    const struct rigid_ties *t = &d->ties;
    const double *line = t->hinges ? t->hinge.axis : t->slider.along;
    double R[DIM][DIM], n[TURNING_SPINS], length = 0;

    *to = (struct rigid_joint){ .kind = t->hinges ? RIGID_HINGE : t->sliders ? RIGID_SLIDER
                                        : t->motions ? RIGID_FIXED : RIGID_FREE,
                                .motion = t->motions ? &t->motion : NULL, .mass = mass,
                                .stiffness = t->hinge.stiffness, .damping = t->hinge.damping };
    memcpy(to->inertia, inertia, sizeof to->inertia);
    memcpy(to->at, d->at, DIM * sizeof *d->at);
    rigid_def_turned(d, to->turn);
    turning_matrix(to->turn, R);
    for (int k = 0; k < 3; k++) {
        to->axis[k] = DIM == 2 && t->hinges ? across[k] : line[k];
        to->pivot[k] = t->hinges && k < DIM ? t->hinge.at[k] : to->at[k];
        to->arm[k] = to->at[k] - to->pivot[k];
        length += to->axis[k] * to->axis[k];
    }
    for (int k = 0; k < 3 && length > 0; k++)
        to->axis[k] /= sqrt(length);
    own(R, to->axis, n);
    for (int i = 0; i < TURNING_SPINS && t->hinges; i++)
        to->rate += n[i] * d->spin[i];
    for (int k = 0; k < DIM && t->sliders; k++)
        to->rate += to->axis[k] * d->velocity[k];
}

/* Where what it is fixed to is, with everything in three components. */
struct base {
    double pivot[3], shift[3], u[3], a[3];
    double angle, omega, alpha;
};

static void base_at(const struct motion *m, double t, struct base *to)
{
    struct motion_place p;

    *to = (struct base){ .angle = 0 };
    if (!m)
        return;
    motion_at(m, t, &p);
    to->angle = p.angle;
    to->omega = p.omega;
    to->alpha = p.alpha;
    for (int d = 0; d < DIM; d++) {
        to->pivot[d] = m->pivot[d];
        to->shift[d] = p.shift[d];
        to->u[d] = p.u[d];
        to->a[d] = p.a[d];
    }
}

/* The joint at q in space: its axis n, the centre from the base's pivot r, and a_q. */
static void stand(const struct rigid_joint *j, const struct base *f, double q, double *n,
                  double *r, double *a_q)
{
    double arm[3], swung[3], from[3];
    const bool hinged = j->kind == RIGID_HINGE;

    turned(across, f->angle, j->axis, n);
    turned(j->axis, hinged ? q : 0, j->arm, swung);
    for (int d = 0; d < 3; d++)
        from[d] = j->pivot[d] - f->pivot[d] + swung[d] + (hinged ? 0 : q * j->axis[d]);
    turned(across, f->angle, from, r);
    turned(across, f->angle, swung, arm);
    if (hinged)
        cross(n, arm, a_q);
    else
        memcpy(a_q, n, 3 * sizeof *n);
}

void rigid_joint_at(const struct rigid_joint *j, double t, double q, double rate,
                    struct rigid_place *to, struct rigid_link *link)
{
    const double turns = j->kind == RIGID_HINGE;
    double R[DIM][DIM], n[3], r[3], a_q[3], er[3], eer[3], ea[3], na[3], en[3], spin[3], b_0[3];
    struct base f;

    base_at(j->motion, t, &f);
    stand(j, &f, q, n, r, a_q);
    cross(across, r, er);
    cross(across, er, eer);
    cross(across, a_q, ea);
    cross(across, n, en);
    cross(n, a_q, na);
    for (int d = 0; d < DIM; d++) {
        to->x[d] = f.pivot[d] + f.shift[d] + r[d];
        to->v[d] = f.u[d] + f.omega * er[d] + rate * a_q[d];
        link->a[d] = a_q[d];
        link->a_0[d] = f.a[d] + f.alpha * er[d] + f.omega * f.omega * eer[d]
                       + 2 * f.omega * rate * ea[d] + turns * rate * rate * na[d];
    }
    for (int d = 0; d < 3; d++) {
        spin[d] = f.omega * across[d] + turns * rate * n[d];
        b_0[d] = f.alpha * across[d] + turns * f.omega * rate * en[d];
        n[d] *= turns;
    }
    memcpy(to->turn, j->turn, sizeof to->turn);
    turn_further(j->axis, turns * q, to->turn);
    turn_further(across, f.angle, to->turn);
    turning_matrix(to->turn, R);
    own(R, spin, to->spin);
    own(R, b_0, link->b_0);
    own(R, n, link->b);
    link->q = q;
    link->rate = rate;
}

void rigid_joint_answer(const struct rigid_joint *j, const struct rigid_place *at,
                        const struct rigid_link *link, const double *force, const double *moment,
                        struct rigid_answer *to)
{
    const double k = j->stiffness * link->q, c = j->damping * link->rate;
    double inertia = 0, push = -k - c, gyration[TURNING_SPINS];

    *to = (struct rigid_answer){ .damping = -c * link->rate };
    turning_gyration(j->inertia, at->spin, gyration);
    for (int d = 0; d < DIM; d++) {
        inertia += j->mass * link->a[d] * link->a[d];
        push += link->a[d] * (force[d] - j->mass * link->a_0[d]);
    }
    for (int i = 0; i < TURNING_SPINS; i++) {
        inertia += j->inertia[i] * link->b[i] * link->b[i];
        push += link->b[i] * (moment[i] + gyration[i] - j->inertia[i] * link->b_0[i]);
    }
    to->second = j->kind == RIGID_FIXED ? 0 : push / inertia;
    for (int d = 0; d < DIM; d++) {
        to->force[d] = j->mass * (link->a_0[d] + to->second * link->a[d]) - force[d];
        to->driven += to->force[d] * at->v[d];
    }
    for (int i = 0; i < TURNING_SPINS; i++) {
        const double spinning = j->inertia[i] * (link->b_0[i] + to->second * link->b[i]);
        to->driven += (spinning - moment[i]) * at->spin[i]; /* Omega x I Omega has no power */
    }
    to->driven = j->motion ? to->driven + (k + c) * link->rate : 0;
}

double rigid_joint_elastic(const struct rigid_joint *j, double q)
{
    return 0.5 * j->stiffness * q * q;
}
