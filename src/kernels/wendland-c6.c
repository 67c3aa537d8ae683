/* wendland-c6.c -- the smoothest of its family here, for many neighbours.
 *
 *   w(q) = (1 - q)^8 (1 + 8 q + 25 q^2 + 32 q^3),  sigma_2 = 78/(7 pi),
 *   sigma_3 = 1365/(64 pi)                                                    (K4)
 *
 * in q = r/H, so that in D dimensions, without division by r,
 *
 *   w'/q  = -22 (1 - q)^7 (1 + 7 q + 16 q^2),
 *   lap w = -22 (1 - q)^6 (D (1 + 6 q) + (9 D - 24) q^2 - 16 (D + 9) q^3).
 *
 * Wendland, Adv. Comput. Math. 4 (1995) 389-396; Dehnen, Aly, Mon. Not. R.
 * Astron. Soc. 425 (2012) 1068-1082.  Checked in tests/unit/space-kernels.c. */
#include "kernels/rows.h"

#include <math.h>

static double sixth(double t)
{
    return t * t * t * t * t * t;
}

static double shape(double q)
{
    const double t = 1 - q;

    return sixth(t) * t * t * (1 + q * (8 + q * (25 + 32 * q)));
}

static double slope(double q)
{
    const double t = 1 - q;

    return -22 * q * sixth(t) * t * (1 + q * (7 + 16 * q));
}

static double curvature(double q)
{
    return -22 * sixth(1 - q) * (1 + q * (6 - q * (15 + 160 * q)));
}

static void gradient(double support, double scale, int n, const lanes *r, const lanes *m,
                     lanes *g)
{
    const real inverse = 1 / support;
    const real factor = -22 * scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k];
        const lanes t = lanes_positive(1 - q), t2 = t * t;
        g[k] = factor * m[k] * (t2 * t2) * (t2 * t) * (1 + q * (7 + 16 * q));
    }
}

static void value(double support, double scale, int n, const lanes *r, const lanes *m, lanes *w)
{
    const real inverse = 1 / support;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k];
        const lanes t = lanes_positive(1 - q), t2 = t * t, t4 = t2 * t2;
        w[k] = (real)scale * m[k] * (t4 * t4) * (1 + q * (8 + q * (25 + 32 * q)));
    }
}

static void laplacian(double support, double scale, int n, const lanes *r, const lanes *m,
                      lanes *l)
{
    const real inverse = 1 / support;
    const real factor = -22 * scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k];
        const lanes t = lanes_positive(1 - q), t2 = t * t;
        l[k] = factor * m[k] * (t2 * t2 * t2)
             * (DIM + q * (6 * DIM + q * (9 * DIM - 24 - 16 * (DIM + 9) * q)));
    }
}

static const struct kernel_rows rows = {
    .gradient = gradient, .value = value, .laplacian = laplacian
};

const struct kernel kernel_wendland_c6 = {
    .name = "wendland-c6", .about = "the smoothest, for many neighbours",
    .source = "Wendland 1995; Dehnen, Aly 2012",
    .sigma = { [2] = 78 / (7 * M_PI), [3] = 1365 / (64 * M_PI) },
    .w = shape, .dw = slope, .ddw = curvature,
    .rows = &rows,
};
