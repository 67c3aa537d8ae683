/* viscosity-log.c -- the kernel whose Laplacian falls to zero along a straight line.
 *
 *   lap w = 1 - q,   q = r/H,   w(1) = w'(1) = 0:
 *   2D  w(q) = q^2/4 - q^3/9 - ln(q)/6 - 5/36,   sigma_2 = 40/pi
 *   3D  w(q) = (1 - q)^3 (1 + q) / (12 q),       sigma_3 = 45/pi              (K9)
 *
 * The one kernel here with a Laplacian that is nowhere negative: a viscosity made
 * of it never drives what it should brake.  W itself is infinite at the centre:
 * no kernel for densities.  What divides by r counts it as KERNEL_CLOSE H at least.
 * In 3D it is that of Mueller, Charypar, Gross, Symp. Computer Animation (2003)
 * 154-159, W = 15/(2 pi H^3) (-q^3/2 + q^2 + 1/(2 q) - 1), lap W = 45/(pi H^6) (H - r).
 * The 2D one follows from the same conditions.  Toth 2012 prints in (29) the 3D shape
 * with a constant for 2D and with its sign turned, in (30) one more sign turned, and
 * in (31), its sign turned and H^4 for H^5, the Laplacian of the 2D w above, which is
 * not that of (29).
 * Slow: a logarithm for each pair.  Checked in tests/unit/space-kernels.c. */
#include "kernels/rows.h"

#include <math.h>

#if DIM == 2

static double shape(double q)
{
    return q * q * (1.0 / 4 - q / 9) - log(q) / 6 - 5.0 / 36;
}

static double slope(double q)
{
    return -(1 - q) * (1 - q) * (1 + 2 * q) / (6 * q);
}

static double curvature(double q)
{
    return 1.0 / 2 - 2 * q / 3 + 1 / (6 * q * q);
}

static lanes slope_by_q(lanes t, lanes q)
{
    return -(t * t) * (1 + 2 * q) / (6 * q * q);
}

#else

static double shape(double q)
{
    const double t = 1 - q;

    return t * t * t * (1 + q) / (12 * q);
}

static double slope(double q)
{
    return -(1 - q) * (1 - q) * (1 + q * (2 + 3 * q)) / (12 * q * q);
}

static double curvature(double q)
{
    return 1.0 / 3 - q / 2 + 1 / (6 * q * q * q);
}

static lanes slope_by_q(lanes t, lanes q)
{
    return -(t * t) * (1 + q * (2 + 3 * q)) / (12 * q * q * q);
}

#endif

static void gradient(double support, double scale, int n, const lanes *r, const lanes *m,
                     lanes *g)
{
    const real inverse = 1 / support;
    const real factor = scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes q = lanes_max(inverse * r[k], lanes_all(KERNEL_CLOSE));
        g[k] = factor * m[k] * slope_by_q(lanes_positive(1 - q), q);
    }
}

/* Lane by lane, so that the logarithm is the library's whatever their number. */
static void value(double support, double scale, int n, const lanes *r, const lanes *m, lanes *w)
{
    const real inverse = 1 / support;

    for (int k = 0; k < n; k++) {
        const lanes q = lanes_max(inverse * r[k], lanes_all(KERNEL_CLOSE));
        lanes of;
        for (int l = 0; l < LANES; l++)
            of[l] = shape(q[l]);
        w[k] = lanes_where((lanes_mask)(q < 1), (real)scale * m[k] * of);
    }
}

static void laplacian(double support, double scale, int n, const lanes *r, const lanes *m,
                      lanes *l)
{
    const real inverse = 1 / support;
    const real factor = scale * inverse * inverse;

    for (int k = 0; k < n; k++)
        l[k] = factor * m[k] * lanes_positive(1 - inverse * r[k]);
}

static const struct kernel_rows rows = {
    .gradient = gradient, .value = value, .laplacian = laplacian
};

const struct kernel kernel_viscosity_log = {
    .name = "viscosity-log", .about = "for viscosity by its Laplacian, which is never negative",
    .source = "Mueller, Charypar, Gross 2003; Toth 2012, (29)-(31) corrected",
    .sigma = { [2] = 40 / M_PI, [3] = 45 / M_PI },
    .singular = true, .spreads = true,
    .w = shape, .dw = slope, .ddw = curvature,
    .rows = &rows,
};
