/* turning.c -- how a rigid body is turned, and how that changes.
 *
 *   R(q) = [(w^2 - u.u) 1 + 2 u u^T + 2 w [u]x]/|q|^2, q = (w, u)                 (RB1)
 *   q' = 1/2 q (0, Omega) + k_q (1 - |q|^2) q                                      (RB2)
 *
 * Goldstein, Classical Mechanics, 1980, 4-5; the second term keeps the length of q near 1,
 * as its error would grow otherwise: Baumgarte, Comp. Meth. Appl. Mech. Eng. 1 (1972) 1-16. */
#include "bodies/turning.h"

#include <math.h>

#if DIM == 2

void turning_about(const double *angle, double *q)
{
    *q = *angle;
}

void turning_matrix(const double *q, double to[DIM][DIM])
{
    to[0][0] = to[1][1] = cos(*q);
    to[1][0] = sin(*q);
    to[0][1] = -to[1][0];
}

void turning_rate(const double *q, const double *spin, double *to)
{
    (void)q;
    *to = *spin;
}

void turning_velocity(const double *spin, const double *arm, double *to)
{
    to[0] = -*spin * arm[1];
    to[1] = *spin * arm[0];
}

void turning_moment(const double *arm, const double *force, double *to)
{
    *to += arm[0] * force[1] - arm[1] * force[0];
}

void turning_gyration(const double *inertia, const double *spin, double *to)
{
    (void)inertia;
    (void)spin;
    *to = 0;
}

#else

/* k_q [1/s]: slow beside any motion, so that it asks for no shorter steps. */
static const double pull = 1;

static double square(const double *q)
{
    return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
}

void turning_about(const double *angle, double *q)
{
    const double all = sqrt(angle[0] * angle[0] + angle[1] * angle[1] + angle[2] * angle[2]);

    q[0] = cos(0.5 * all);
    for (int d = 0; d < 3; d++)
        q[1 + d] = all > 0 ? sin(0.5 * all) * angle[d] / all : 0;
}

void turning_matrix(const double *q, double to[DIM][DIM])
{
    const double w = q[0], *u = q + 1, s = 1 / square(q);
    const double diagonal = w * w - u[0] * u[0] - u[1] * u[1] - u[2] * u[2];

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        to[i][i] = s * (diagonal + 2 * u[i] * u[i]);
        to[i][j] = s * 2 * (u[i] * u[j] - w * u[k]);
        to[j][i] = s * 2 * (u[i] * u[j] + w * u[k]);
    }
}

void turning_rate(const double *q, const double *spin, double *to)
{
    const double back = pull * (1 - square(q)), *u = q + 1;

    to[0] = back * q[0];
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        to[0] -= 0.5 * u[i] * spin[i];
        to[1 + i] = back * u[i] + 0.5 * (q[0] * spin[i] + u[j] * spin[k] - u[k] * spin[j]);
    }
}

void turning_velocity(const double *spin, const double *arm, double *to)
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        to[i] = spin[j] * arm[k] - spin[k] * arm[j];
    }
}

void turning_moment(const double *arm, const double *force, double *to)
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        to[i] += arm[j] * force[k] - arm[k] * force[j];
    }
}

void turning_gyration(const double *inertia, const double *spin, double *to)
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        to[i] = (inertia[j] - inertia[k]) * spin[j] * spin[k];
    }
}

void turning_product(const double *q, const double *first, double *to)
{
    const double *a = q + 1, *b = first + 1;

    to[0] = q[0] * first[0] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2];
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        to[1 + i] = q[0] * b[i] + first[0] * a[i] + (a[j] * b[k] - a[k] * b[j]);
    }
}

bool turning_known(const double *q)
{
    return square(q) > 0;
}

#endif
