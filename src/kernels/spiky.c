/* spiky.c -- a cone with hollow sides: pushes hardest at the centre.
 *
 *   w(q) = (1 - q)^3,  sigma_2 = 10/pi,  sigma_3 = 15/pi                      (K8)
 *
 * in q = r/H, so that in D dimensions
 *
 *   w'/q  = -3 (1 - q)^2 / q,   lap w = 3 (1 - q) ((D + 1) q - (D - 1)) / q.
 *
 * For pressure: the force does not fade when particles come close.  W'/r and the
 * Laplacian grow like 1/r at the centre; r counts as KERNEL_CLOSE H at least.
 * Desbrun, Gascuel, Computer Animation and Simulation '96, 61-76; Mueller,
 * Charypar, Gross, Symp. Computer Animation (2003) 154-159; in 2D Toth 2012, (25),
 * (26), and (27), which is printed as -6 (1 - q) (1 - 2 q) instead of
 * -3 (1 - q) (1 - 3 q) / q: the 3D bracket without its 1/r.  Checked in
 * tests/unit/space-kernels.c. */
#include "kernels/rows.h"

#include <math.h>

static double shape(double q)
{
    const double t = 1 - q;

    return t * t * t;
}

static double slope(double q)
{
    return -3 * (1 - q) * (1 - q);
}

static double curvature(double q)
{
    return 6 * (1 - q);
}

static void gradient(double support, double scale, int n, const lanes *r, const lanes *m,
                     lanes *g)
{
    const real inverse = 1 / support;
    const real factor = -3 * scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes q = lanes_max(inverse * r[k], lanes_all(KERNEL_CLOSE));
        const lanes t = lanes_positive(1 - q);
        g[k] = factor * m[k] * (t * t) / q;
    }
}

static void value(double support, double scale, int n, const lanes *r, const lanes *m, lanes *w)
{
    const real inverse = 1 / support;

    for (int k = 0; k < n; k++) {
        const lanes t = lanes_positive(1 - inverse * r[k]);
        w[k] = (real)scale * m[k] * (t * t * t);
    }
}

static void laplacian(double support, double scale, int n, const lanes *r, const lanes *m,
                      lanes *l)
{
    const real inverse = 1 / support;
    const real factor = 3 * scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes q = lanes_max(inverse * r[k], lanes_all(KERNEL_CLOSE));
        l[k] = factor * m[k] * lanes_positive(1 - q) * ((DIM + 1) * q - (DIM - 1)) / q;
    }
}

static const struct kernel_rows rows = {
    .gradient = gradient, .value = value, .laplacian = laplacian
};

const struct kernel kernel_spiky = {
    .name = "spiky", .about = "for pressure that does not fade when particles come close",
    .source = "Desbrun, Gascuel 1996; Toth 2012, (25)-(27) corrected",
    .sigma = { [2] = 10 / M_PI, [3] = 15 / M_PI },
    .w = shape, .dw = slope, .ddw = curvature,
    .rows = &rows,
};
