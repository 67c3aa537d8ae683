/* quintic-spline.c -- the spline nearest to a bell, of three pieces.
 *
 *   w(q) = (3 - s)^5 - 6 (2 - s)^5 + 15 (1 - s)^5,  each power only where its
 *   base is positive,  sigma_2 = 63/(478 pi),  sigma_3 = 9/(40 pi)            (K5)
 *
 * with s = 3 q = 3 r/H; the papers write it with h = H/3, where the constants are
 * 7/(478 pi h^2) and 1/(120 pi h^3) (3/(359 pi h^3), also seen, is 0.3 % more).
 * Of the innermost piece s is taken out of w', so that nothing divides by r there.
 * Morris, Fox, Zhu, J. Comput. Phys. 136 (1997) 214-226.  Checked in
 * tests/unit/space-kernels.c. */
#include "kernels/rows.h"

#include <math.h>

/* (3 - s)^n - 6 (2 - s)^n + 15 (1 - s)^n of the positive bases. */
static double pieces(double s, int n)
{
    const double b = s < 2 ? pow(2 - s, n) : 0, c = s < 1 ? pow(1 - s, n) : 0;

    return pow(3 - s, n) - 6 * b + 15 * c;
}

static double shape(double q)
{
    return pieces(3 * q, 5);
}

static double slope(double q)
{
    return -15 * pieces(3 * q, 4);
}

static double curvature(double q)
{
    return 180 * pieces(3 * q, 3);
}

static lanes fourth(lanes t)
{
    return (t * t) * (t * t);
}

/* (1/s) d/ds of the outer pieces; used, and divided, where s >= 1. */
static lanes outer_slope(lanes s)
{
    const lanes sum = fourth(lanes_positive(3 - s)) - 6 * fourth(lanes_positive(2 - s));

    return -5 * sum / lanes_max(s, lanes_all(1));
}

static void gradient(double support, double scale, int n, const lanes *r, const lanes *m,
                     lanes *g)
{
    const real inverse = 3 / support;
    const real factor = scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes s = inverse * r[k];
        const lanes_mask inner = (lanes_mask)(s < 1);
        const lanes near = s * s * (120 - 50 * s) - 120;
        g[k] = factor * m[k] * (lanes_where(inner, near) + lanes_where(~inner, outer_slope(s)));
    }
}

static void value(double support, double scale, int n, const lanes *r, const lanes *m, lanes *w)
{
    const real inverse = 3 / support;

    for (int k = 0; k < n; k++) {
        const lanes s = inverse * r[k];
        const lanes a = lanes_positive(3 - s), b = lanes_positive(2 - s);
        const lanes c = lanes_positive(1 - s);
        w[k] = (real)scale * m[k] * (fourth(a) * a - 6 * (fourth(b) * b) + 15 * (fourth(c) * c));
    }
}

static void laplacian(double support, double scale, int n, const lanes *r, const lanes *m,
                      lanes *l)
{
    const real inverse = 3 / support;
    const real factor = scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes s = inverse * r[k];
        const lanes_mask inner = (lanes_mask)(s < 1);
        const lanes a = lanes_positive(3 - s), b = lanes_positive(2 - s);
        const lanes near = s * s * (120 * (DIM + 2) - 50 * (DIM + 3) * s) - 120 * DIM;
        const lanes far = 20 * (a * a * a - 6 * (b * b * b)) + (DIM - 1) * outer_slope(s);
        l[k] = factor * m[k] * (lanes_where(inner, near) + lanes_where(~inner, far));
    }
}

static const struct kernel_rows rows = {
    .gradient = gradient, .value = value, .laplacian = laplacian
};

const struct kernel kernel_quintic_spline = {
    .name = "quintic-spline", .about = "the spline nearest to a bell, for many neighbours",
    .source = "Morris, Fox, Zhu 1997",
    .sigma = { [2] = 63 / (478 * M_PI), [3] = 9 / (40 * M_PI) },
    .w = shape, .dw = slope, .ddw = curvature,
    .rows = &rows,
};
