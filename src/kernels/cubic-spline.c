/* cubic-spline.c -- the classic kernel of the published dam breaks.
 *
 *   w(q) = 1 - 6 q^2 + 6 q^3  (q < 1/2),   2 (1 - q)^3  (q >= 1/2),
 *   sigma_2 = 40/(7 pi),  sigma_3 = 8/pi                                      (K2)
 *
 * in q = r/H; the papers write it with h = H/2.
 * Monaghan, Lattanzio, Astron. Astrophys. 149 (1985) 135-143.  Checked in
 * tests/unit/space-kernels.c. */
#include "kernels/rows.h"

#include <math.h>

static double shape(double q)
{
    const double t = 1 - q;

    return q < 0.5 ? 1 - 6 * q * q * t : 2 * t * t * t;
}

static double slope(double q)
{
    const double t = 1 - q;

    return q < 0.5 ? q * (18 * q - 12) : -6 * t * t;
}

static double curvature(double q)
{
    return q < 0.5 ? 36 * q - 12 : 12 * (1 - q);
}

/* Both branches are computed; the outer one divides by q >= 1/2 only. */
static void gradient(double support, double scale, int n, const lanes *r, const lanes *m,
                     lanes *g)
{
    const real inverse = 1 / support;
    const real factor = scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k];
        const lanes_mask inner = (lanes_mask)(q < 0.5);
        const lanes t = lanes_positive(1 - q);
        const lanes far = -6 * t * t / (0.5 + lanes_positive(q - 0.5));
        g[k] = factor * m[k] * (lanes_where(inner, 18 * q - 12) + lanes_where(~inner, far));
    }
}

static void value(double support, double scale, int n, const lanes *r, const lanes *m, lanes *w)
{
    const real inverse = 1 / support;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k];
        const lanes_mask inner = (lanes_mask)(q < 0.5);
        const lanes t = lanes_positive(1 - q);
        w[k] = (real)scale * m[k] * (lanes_where(inner, 1 - 6 * q * q * t)
                               + lanes_where(~inner, 2 * t * t * t));
    }
}

/* w'' + (D - 1) w'/q; again the outer branch divides by q >= 1/2 only. */
static void laplacian(double support, double scale, int n, const lanes *r, const lanes *m,
                      lanes *l)
{
    const real inverse = 1 / support;
    const real factor = scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k];
        const lanes_mask inner = (lanes_mask)(q < 0.5);
        const lanes t = lanes_positive(1 - q);
        const lanes far = 12 * t - 6 * (DIM - 1) * t * t / (0.5 + lanes_positive(q - 0.5));
        l[k] = factor * m[k] * (lanes_where(inner, 18 * (DIM + 1) * q - 12 * DIM)
                                + lanes_where(~inner, far));
    }
}

static const struct kernel_rows rows = {
    .gradient = gradient, .value = value, .laplacian = laplacian
};

const struct kernel kernel_cubic_spline = {
    .name = "cubic-spline", .about = "the kernel of the published dam breaks",
    .source = "Monaghan, Lattanzio 1985",
    .sigma = { [2] = 40 / (7 * M_PI), [3] = 8 / M_PI },
    .w = shape, .dw = slope, .ddw = curvature,
    .rows = &rows,
};
