/* dv-bodies.c -- bodies within a step of "dv".
 *
 * y' = f_I(y) + F with the load F = M^-1 (forces of the water) held fixed, by the
 * two-stage L-stable SDIRK of order 2 with g = 1 - 1/sqrt(2):
 *
 *   z = y_n + g h (f_I(z) + F)
 *   y_(n+1) = y_n + (1 - g)/g (z - y_n) + g h (f_I(y_(n+1)) + F)
 *
 * So F enters through (M + g h D + (g h)^2 K)^-1.  A kick h M^-1 F between two flows
 * of the free body would be cheaper, but it blows up at contact: it acts on light
 * nodes as if nothing held them.  Alexander, SIAM J. Numer. Anal. 14 (1977)
 * 1006-1021.
 *
 * The book takes what supports, dampers and prescribed loads do from these stages,
 * (1 - g) of z and g of y_(n+1), instead of where A saw the bodies: then momentum and
 * the energy that loads give are exactly those that the step makes. */
#include "time/dv.h"

#include "base/status.h"
#include "eval/moment.h"
#include <math.h>

/* to = y + c (z - y) + h f. */
static void mix(const struct dv *x, const double *y, double c, const double *z, double h,
                const double *f, double *to)
{
    for (int k = 0; k < x->ranges; k++)
        for (long i = x->range[k][0]; i < x->range[k][1]; i++)
            to[i] = y[i] + c * (z[i] - y[i]) + h * f[i];
}

/* The load goes to x->load; in A the mean rates of the step take its place, whose
 * differences are the error: of this SDIRK 0.0404 h^3 y''', as of the rest h^3/24.
 * In a first step nothing is known of them. */
static void keep_rates(struct dv *x, double h)
{
    for (int k = 0; k < x->ranges; k++)
        for (long i = x->range[k][0]; i < x->range[k][1]; i++) {
            x->load[i] = x->a.f[0][i];
            if (i < x->from[LAYOUT_VELOCITY])
                continue;
            x->a.f[0][i] = (x->frame.y[i] - x->frame.y_old[i]) / h;
            if (x->a.known == 1)
                x->a.f[1][i] = x->a.f[0][i];
        }
}

int dv_bodies_half(struct dv *x, double h)
{
    const double *old = x->frame.y_old;

    if (x->ranges == 0)
        return STATUS_DONE;
    mix(x, old, 0, old, h, x->load_old, x->right);
    mix(x, old, 0, old, 0, x->load_old, x->half); /* a guess */
    return moment_solve(x->frame.moment, x->frame.t_old + h, h, x->right, x->half);
}

int dv_bodies_step(struct dv *x, double h)
{
    struct moment *moment = x->frame.moment;
    const double g = 1 - sqrt(0.5), t = x->a.t[0], t_old = x->frame.t_old;
    const double *old = x->frame.y_old, *load = x->a.f[0];
    double *y = x->frame.y;

    if (x->ranges == 0)
        return STATUS_DONE;
    moment_body_book(moment, t, x->half, -1, x->a.f[0]);
    mix(x, old, 0, old, g * h, load, x->right);
    mix(x, old, 0, old, 0, load, y);
    TRY(moment_solve(moment, t_old + g * h, g * h, x->right, y));
    moment_body_book(moment, t, y, 1 - g, x->a.f[0]);
    mix(x, old, (1 - g) / g, y, g * h, load, x->right);
    TRY(moment_solve(moment, t_old + h, g * h, x->right, y));
    moment_body_book(moment, t, y, g, x->a.f[0]);
    keep_rates(x, h);
    return STATUS_DONE;
}
