/* poly6.c -- a polynomial in r^2, for summed densities.
 *
 *   w(q) = (1 - q^2)^3,  sigma_2 = 4/pi,  sigma_3 = 315/(64 pi)               (K7)
 *
 * in q = r/H, so that in D dimensions
 *
 *   w'/q  = -6 (1 - q^2)^2,   lap w = -6 (1 - q^2) (D - (D + 4) q^2).
 *
 * w' vanishes at the centre like q: as the kernel of pressure it lets particles
 * clump.  Mueller, Charypar, Gross, Symp. Computer Animation (2003) 154-159; in 2D
 * Toth 2012, (15), (16), and (17), which is printed with the 3D bracket
 * (3 - 7 q^2) instead of (2 - 6 q^2).  Checked in tests/unit/space-kernels.c. */
#include "kernels/rows.h"

#include <math.h>

static double shape(double q)
{
    const double t = 1 - q * q;

    return t * t * t;
}

static double slope(double q)
{
    const double t = 1 - q * q;

    return -6 * q * t * t;
}

static double curvature(double q)
{
    return -6 * (1 - q * q) * (1 - 5 * q * q);
}

static void gradient(double support, double scale, int n, const lanes *r, const lanes *m,
                     lanes *g)
{
    const real inverse = 1 / support;
    const real factor = -6 * scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k];
        const lanes t = lanes_positive(1 - q * q);
        g[k] = factor * m[k] * (t * t);
    }
}

static void value(double support, double scale, int n, const lanes *r, const lanes *m, lanes *w)
{
    const real inverse = 1 / support;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k];
        const lanes t = lanes_positive(1 - q * q);
        w[k] = (real)scale * m[k] * (t * t * t);
    }
}

static void laplacian(double support, double scale, int n, const lanes *r, const lanes *m,
                      lanes *l)
{
    const real inverse = 1 / support;
    const real factor = -6 * scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k], q2 = q * q;
        l[k] = factor * m[k] * lanes_positive(1 - q2) * (DIM - (DIM + 4) * q2);
    }
}

static const struct kernel_rows rows = {
    .gradient = gradient, .value = value, .laplacian = laplacian
};

const struct kernel kernel_poly6 = {
    .name = "poly6", .about = "polynomial in r^2 for summed densities; clumps under pressure",
    .source = "Mueller, Charypar, Gross 2003; Toth 2012, (15)-(17) corrected",
    .sigma = { [2] = 4 / M_PI, [3] = 315 / (64 * M_PI) },
    .w = shape, .dw = slope, .ddw = curvature,
    .rows = &rows,
};
