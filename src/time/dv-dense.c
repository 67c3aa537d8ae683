/* dv-dense.c -- y inside the last step of "dv"; no right-hand side is asked for.
 *
 * Positions: the cubic Hermite interpolant with the velocities at both ends.
 * Densities and quadratures: the same with D at both ends, and A for both.
 * Velocities, with s from 0 to 1: the line from end to end, bent by the last change
 * of A:  v(s) = (1 - s) v_n + s v_(n+1) - s (1 - s) h^2/2 (A - A_old)/(t - t_old).
 * All of them are off by no more than order h^3. */
#include "time/dv.h"

#include "time/dense.h"

static void velocities_at(const struct dv *x, double t, double *y)
{
    const long v = x->from[LAYOUT_VELOCITY], n = x->from[LAYOUT_OTHER] - v;
    const double h = x->frame.t - x->frame.t_old, s = (t - x->frame.t_old) / h;
    const double bend = s * (1 - s) * h * h / 2 / (x->a.t[1] - x->a.t[2]);
    const double c[4] = { s, 1 - s, -bend, bend };

    vector_combine(4, c, (const double *[]){ x->frame.y + v, x->frame.y_old + v, x->a.f[1] + v,
                                             x->a.f[2] + v }, n, y + v);
}

void dv_inside(const struct paced *frame, double t, double *y)
{
    const struct dv *x = (const struct dv *)frame;
    const double *now = frame->y, *old = frame->y_old;
    const long v = x->from[LAYOUT_VELOCITY], o = x->from[LAYOUT_OTHER];
    const double time[2] = { frame->t, frame->t_old };
    double c[5];

    dense_hermite(2, time, t, c, c + 2);
    c[4] = c[2] + c[3];
    vector_combine(4, c, (const double *[]){ now, old, now + v, old + v }, v, y);
    velocities_at(x, t, y);
    vector_combine(5, c, (const double *[]){ now + o, old + o, x->d.f[1] + o, x->d.begun + o,
                                             x->a.f[1] + o }, frame->n - o, y + o);
}
