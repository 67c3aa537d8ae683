/* dv-dense.c -- y inside the last step of "dv"; no right-hand side is asked for.
 *
 * Positions: the cubic Hermite interpolant with the velocities at both ends.
 * Densities and quadratures: the same with D at both ends, and A for both.
 * Velocities, with s from 0 to 1: the line from end to end, bent by the last change
 * of A:  v(s) = (1 - s) v_n + s v_(n+1) - s (1 - s) h^2/2 (A - A_old)/(t - t_old).
 * All of them are off by no more than order h^3. */
#include "time/dv.h"

#include "base/status.h"
#include "time/dense.h"

static void velocities_at(const struct dv *x, double t, double *y)
{
    const long v = x->from[LAYOUT_VELOCITY], n = x->from[LAYOUT_OTHER] - v;
    const double h = x->t - x->t_old, s = (t - x->t_old) / h;
    const double bend = s * (1 - s) * h * h / 2 / (x->a.t[1] - x->a.t[2]);
    const double c[4] = { s, 1 - s, -bend, bend };

    vector_combine(4, c, (const double *[]){ x->y + v, x->y_old + v, x->a.f[1] + v,
                                             x->a.f[2] + v }, n, y + v);
}

static void inside(const struct dv *x, double t, double *y)
{
    const long v = x->from[LAYOUT_VELOCITY], o = x->from[LAYOUT_OTHER];
    const double time[2] = { x->t, x->t_old };
    double c[5];

    dense_hermite(2, time, t, c, c + 2);
    c[4] = c[2] + c[3];
    vector_combine(4, c, (const double *[]){ x->y, x->y_old, x->y + v, x->y_old + v }, v, y);
    velocities_at(x, t, y);
    vector_combine(5, c, (const double *[]){ x->y + o, x->y_old + o, x->d.f[1] + o,
                                             x->d.begun + o, x->a.f[1] + o }, x->n - o, y + o);
}

int dv_at(void *self, double t, double *y)
{
    struct dv *x = self;

    if (t == x->t || (x->stepped && t == x->t_old)) {
        vector_copy(x->n, t == x->t ? x->y : x->y_old, y);
        return STATUS_DONE;
    }
    if (!x->stepped || !(t > x->t_old && t < x->t))
        return status_fail(STATUS_FAILED, "the state at t = %.9g s was asked for, which does not "
                                          "lie in the last step (to %.9g s)", t, x->t);
    inside(x, t, y);
    return STATUS_DONE;
}
