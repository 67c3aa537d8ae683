/* wendland-c4.c -- smoother than Wendland C2, for more neighbours.
 *
 *   w(q) = (1 - q)^6 (1 + 6 q + 35/3 q^2),  sigma_2 = 9/pi,
 *   sigma_3 = 495/(32 pi)                                                     (K3)
 *
 * in q = r/H, so that in D dimensions, without division by r,
 *
 *   w'/q  = -56/3 (1 - q)^5 (1 + 5 q),
 *   lap w = -56/3 (1 - q)^4 (D (1 + 4 q) - 5 (D + 6) q^2).
 *
 * Wendland, Adv. Comput. Math. 4 (1995) 389-396; Dehnen, Aly, Mon. Not. R.
 * Astron. Soc. 425 (2012) 1068-1082.  Checked in tests/unit/space-kernels.c. */
#include "kernels/rows.h"

#include <math.h>

static const double STEEP = -56.0 / 3;

static double shape(double q)
{
    const double t = 1 - q;

    return t * t * t * t * t * t * (1 + q * (6 + (real)(35.0 / 3) * q));
}

static double slope(double q)
{
    const double t = 1 - q;

    return STEEP * q * (1 + 5 * q) * t * t * t * t * t;
}

static double curvature(double q)
{
    const double t = 1 - q;

    return STEEP * t * t * t * t * (1 + q * (4 - 35 * q));
}

static void gradient(double support, double scale, int n, const lanes *r, const lanes *m,
                     lanes *g)
{
    const real inverse = 1 / support;
    const real factor = STEEP * scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k];
        const lanes t = lanes_positive(1 - q), t2 = t * t;
        g[k] = factor * m[k] * (t2 * t2 * t) * (1 + 5 * q);
    }
}

static void value(double support, double scale, int n, const lanes *r, const lanes *m, lanes *w)
{
    const real inverse = 1 / support;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k];
        const lanes t = lanes_positive(1 - q), t2 = t * t;
        w[k] = (real)scale * m[k] * (t2 * t2 * t2) * (1 + q * (6 + (real)(35.0 / 3) * q));
    }
}

static void laplacian(double support, double scale, int n, const lanes *r, const lanes *m,
                      lanes *l)
{
    const real inverse = 1 / support;
    const real factor = STEEP * scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k];
        const lanes t = lanes_positive(1 - q), t2 = t * t;
        l[k] = factor * m[k] * (t2 * t2) * (DIM * (1 + 4 * q) - 5 * (DIM + 6) * q * q);
    }
}

static const struct kernel_rows rows = {
    .gradient = gradient, .value = value, .laplacian = laplacian
};

const struct kernel kernel_wendland_c4 = {
    .name = "wendland-c4", .about = "smoother than wendland-c2, for more neighbours",
    .source = "Wendland 1995; Dehnen, Aly 2012",
    .sigma = { [2] = 9 / M_PI, [3] = 495 / (32 * M_PI) },
    .w = shape, .dw = slope, .ddw = curvature,
    .rows = &rows,
};
