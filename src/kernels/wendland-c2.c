/* wendland-c2.c -- the default smoothing kernel.
 *
 *   w(q) = (1 - q)^4 (1 + 4 q),  sigma_2 = 7/pi,  sigma_3 = 21/(2 pi)         (K1)
 *
 * in q = r/H.  Its Fourier transform is positive, so particles do not pair.
 * Nothing is divided by r:
 *
 *   w'/q = -20 (1 - q)^3,   lap w = -20 (1 - q)^2 (D - (D + 3) q)
 *
 * Wendland, Adv. Comput. Math. 4 (1995) 389-396; Dehnen, Aly, Mon. Not. R.
 * Astron. Soc. 425 (2012) 1068-1082.  Checked in tests/unit/space-kernels.c. */
#include "kernels/wendland-c2.h"

#include <math.h>

static double shape(double q)
{
    const double t = 1 - q;

    return t * t * t * t * (1 + 4 * q);
}

static double slope(double q)
{
    const double t = 1 - q;

    return -20 * q * t * t * t;
}

static double curvature(double q)
{
    const double t = 1 - q;

    return -20 * t * t * (1 - 4 * q);
}

static void gradient(double support, double scale, int n, const lanes *r, const lanes *m,
                     lanes *g)
{
    const struct wendland_c2 c = wendland_c2_make(support, scale);

    for (int k = 0; k < n; k++)
        g[k] = wendland_c2_gradient(&c, r[k], m[k]);
}

static void both(double support, double scale, int n, const lanes *r, const lanes *r2,
                 const lanes *m, lanes *restrict g, lanes *restrict g_r2)
{
    const struct wendland_c2 c = wendland_c2_make(support, scale);

    for (int k = 0; k < n; k++) {
        const lanes gk = wendland_c2_gradient(&c, r[k], m[k]);
        g[k] = gk;
        g_r2[k] = wendland_c2_softened(&c, gk, r2[k]);
    }
}

static void value(double support, double scale, int n, const lanes *r, const lanes *m, lanes *w)
{
    const real inverse = 1 / support;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k];
        const lanes t = lanes_positive(1 - q);
        w[k] = (real)scale * m[k] * (t * t) * (t * t) * (1 + 4 * q);
    }
}

static void laplacian(double support, double scale, int n, const lanes *r, const lanes *m,
                      lanes *l)
{
    const real inverse = 1 / support;
    const real factor = -20 * scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k];
        const lanes t = lanes_positive(1 - q);
        l[k] = factor * m[k] * (t * t) * (DIM - (DIM + 3) * q);
    }
}

static const struct kernel_rows rows = {
    .gradient = gradient, .value = value, .laplacian = laplacian, .both = both
};

const struct kernel kernel_wendland_c2 = {
    .name = "wendland-c2", .about = "smooth, no pairing of particles, cheap",
    .source = "Wendland 1995; Dehnen, Aly 2012",
    .sigma = { [2] = 7 / M_PI, [3] = 21 / (2 * M_PI) },
    .w = shape, .dw = slope, .ddw = curvature,
    .rows = &rows,
};
