/* gauss.c -- the bell curve, cut at three of its standard deviations.
 *
 *   w(q) = exp(-a q^2) - exp(-a),   a = 9/2,   q = r/H,   H = 3 hbar          (K6)
 *   1/sigma_2 = pi/a (1 - (1 + a) exp(-a))
 *   1/sigma_3 = (pi/a)^(3/2) erf(sqrt(a)) - 4 pi exp(-a) (1/(2 a) + 1/3)
 *
 * The printed bell never ends and so has no radius beyond which it is 0, as (9)
 * asks; here it is cut at H, lowered so that W is continuous there, and normalised
 * anew (6.5 % more in 2D, 12 % in 3D).  W' still jumps at H, by 5.5 % of its
 * greatest value.  Slow: an exponential for each pair.
 * Gingold, Monaghan, Mon. Not. R. Astron. Soc. 181 (1977) 375-389; Toth 2012, (13).
 * Checked in tests/unit/space-kernels.c. */
#include "kernels/rows.h"

#include <math.h>

#define EDGE 0.011108996538242306 /* exp(-a)          */
#define CORE 0.9973002039367398   /* erf(sqrt(a))     */
#define ROOT 0.8355427582103335   /* sqrt(pi / a)     */

static double bell(double q)
{
    return exp(-4.5 * q * q);
}

static double shape(double q)
{
    return bell(q) - EDGE;
}

static double slope(double q)
{
    return -9 * q * bell(q);
}

static double curvature(double q)
{
    return -9 * (1 - 9 * q * q) * bell(q);
}

/* The same function of the library in every lane, whatever their number. */
static lanes bells(lanes q)
{
    lanes w;

    for (int l = 0; l < LANES; l++)
        w[l] = bell(q[l]);
    return w;
}

static void gradient(double support, double scale, int n, const lanes *r, const lanes *m,
                     lanes *g)
{
    const real inverse = 1 / support;
    const real factor = -9 * scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k];
        g[k] = lanes_where((lanes_mask)(q < 1), factor * m[k] * bells(q));
    }
}

static void value(double support, double scale, int n, const lanes *r, const lanes *m, lanes *w)
{
    const real inverse = 1 / support;

    for (int k = 0; k < n; k++)
        w[k] = (real)scale * m[k] * lanes_positive(bells(inverse * r[k]) - (real)EDGE);
}

static void laplacian(double support, double scale, int n, const lanes *r, const lanes *m,
                      lanes *l)
{
    const real inverse = 1 / support;
    const real factor = -9 * scale * inverse * inverse;

    for (int k = 0; k < n; k++) {
        const lanes q = inverse * r[k];
        l[k] = lanes_where((lanes_mask)(q < 1), factor * m[k] * bells(q) * (DIM - 9 * q * q));
    }
}

static const struct kernel_rows rows = {
    .gradient = gradient, .value = value, .laplacian = laplacian
};

const struct kernel kernel_gauss = {
    .name = "gauss", .about = "the bell curve, cut at three standard deviations; slow",
    .source = "Gingold, Monaghan 1977; Toth 2012, (13), cut",
    .sigma = { [2] = 4.5 / (M_PI * (1 - 5.5 * EDGE)),
               [3] = 1 / (ROOT * ROOT * ROOT * CORE - 16 * M_PI / 9 * EDGE) },
    .w = shape, .dw = slope, .ddw = curvature,
    .rows = &rows,
};
